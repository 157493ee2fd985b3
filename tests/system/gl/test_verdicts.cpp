// Scenes through Mesa's drivers. Those of the gallery are a suite: gallery.json.

#include <refraster/files.h>
#include <refraster/mesh.h>

#include "gl/context/driver_environment.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/gl/device_images.h"
#include "tests/support/gl/seeded_faults.h"
#include "tests/support/scenes/brick_scene.h"
#include "tests/support/scenes/half_textured.h"
#include "tests/support/scenes/leaf_scene.h"
#include "tests/support/scenes/listed_scenes.h"
#include "tests/support/scenes/shadow_scene.h"
#include "tests/system/gl/small_scenes.h"
#include "verify/device/read_profile.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

using namespace refraster;

namespace {

/// As the profile's driver is told to draw. Mesa reads that once a process.
DeviceProfile entered(const std::string& name) {
  DeviceProfile profile = device_profile(name);
  enter_environment(profile.environment);
  return profile;
}

void say_unexplained(const std::string& name, const Verdict& verdict) {
  int said = 0;
  for (const JudgedDetail& pixel : verdict.details) {
    if (pixel.found != PixelClass::unexplained || said++ == 10) continue;
    std::ostringstream text;
    text << name << " (" << pixel.x << ", " << pixel.y << ") by its " << name_of(pixel.objection);
    for (int c = 0; c < 3; ++c)
      text << "; " << pixel.reference[c] << " here, " << pixel.actual[c] << " there, allowed " << pixel.allowed.lo[c]
           << " to " << pixel.allowed.hi[c];
    MESSAGE(text.str());
  }
}

GlFrame drawn(const Scene& scene, int width, int height, const DeviceProfile& profile) {
  GlOptions options;
  options.width = width, options.height = height;
  options.renderer = profile.renderer;
  options.want_radiance = options.want_ids = options.want_depth = true;
  return render_gl(scene, options);
}

/// 0 unexplained pixels in 8 bits and in floats, with ids and depth. Gives the share that is not exact in floats.
double check_scene(const std::string& name, const Scene& scene, int width, int height, const DeviceProfile& profile) {
  const GlFrame frame = drawn(scene, width, height, profile);
  INFO(name << " through " << frame.driver.renderer << ", " << width << " x " << height);
  double inexact = 0;
  for (const DeviceImage& image : {in_8_bits(frame), in_float(frame)}) {
    const Verdict verdict = judge(scene, image, profile, {});
    say_unexplained(name, verdict);
    CHECK(verdict.is_explained());
    for (const ObjectBias& bias : verdict.biases) CHECK(!bias.is_biased());
    inexact = 1 - static_cast<double>(verdict.count(PixelClass::exact)) / (width * height);
  }
  return inexact;
}
constexpr std::pair<int, int> odd_sizes[] = {{64, 1}, {1, 63}, {31, 33}, {1, 1}};

/// Surfaces of which a part is cut out, by every filter.
void check_leaves(const std::string& profile_name, int width, int height) {
  const DeviceProfile profile = entered(profile_name);
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    check_scene("leaves, " + std::string(name_of(filter)), leaf_scene(filter, 0.45), width, height, profile);
}

/// Bricks whose normals maps turn, mirrored and from both sides; and that a wrong way of turning them is found.
void check_bricks(TextureFilter filter, BrickMaps maps, const DeviceProfile& profile) {
  Scene scene = brick_scene(filter, maps);
  Mesh half = *scene.objects[1].mesh; // open: its inside is seen, too
  half.triangles.resize(half.triangles.size() / 2);
  scene.objects[1].mesh = std::make_shared<const Mesh>(std::move(half));
  scene.objects[1].two_sided = TwoSided::yes;
  const std::string name(name_of(filter));
  check_scene(name, scene, 112, 63, profile);
  // The test can fail.
  const auto is_explained = [&](auto&& plant) {
    Scene wrong = scene;
    for (Object& object : wrong.objects) plant(object);
    return judge(scene, in_float(drawn(wrong, 112, 63, profile)), profile, {}).is_explained();
  };
  CHECK_FALSE(is_explained([](Object& object) { object.material.normal_map = object.material.bump_map = {}; }));
  CHECK_FALSE(is_explained([](Object& object) { // the bitangent's sign
    Mesh mesh = *object.mesh;
    for (Float4& tangent : mesh.tangents) tangent.w = -tangent.w;
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  }));
  if (maps != BrickMaps::heights)
    CHECK_FALSE(is_explained([](Object& object) { // green down, as Direct3D has it
      Texture texture = *object.material.normal_map.texture;
      for (TextureLevel& level : texture.levels)
        for (std::size_t i = 1; i < level.rgb.size(); i += 3) level.rgb[i] = 255 - level.rgb[i];
      object.material.normal_map.texture = std::make_shared<const Texture>(std::move(texture));
    }));
  if (maps != BrickMaps::normals)
    CHECK_FALSE(is_explained([](Object& object) { object.material.bump_scale *= -1; })); // dents for bumps
}

} // namespace

TEST_CASE("a scene through llvmpipe shows the same surfaces, in colours that are explained") {
  for (const std::string& path : quick_scenes()) check_scene(path, listed_scene(path), 112, 63, entered("llvmpipe"));
}

TEST_CASE("an object that is lit from both sides shows them through llvmpipe as here, mirrored or not") {
  Scene scene = ball(Phong{});
  Mesh half = *scene.objects[0].mesh; // open: its inside is seen, too
  half.triangles.resize(half.triangles.size() / 2);
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(half));
  scene.objects[0].two_sided = TwoSided::yes;
  const DeviceProfile profile = entered("llvmpipe");
  for (const Double3& scale : {Double3(1.5, 1, 0.7), Double3(-1.5, 1, 0.7), Double3(1.5, -1, -0.7), Double3(-1)}) {
    scene.objects[0].scale = scale;
    for (const double turn : {0.0, 180.0}) {
      scene.objects[0].rotate_degrees = {20, turn, 0};
      check_scene("both sides", scene, 96, 64, profile);
    }
  }
  // The test can fail: one side alone is another picture.
  Scene one_side = scene;
  one_side.objects[0].two_sided = TwoSided::no;
  CHECK_FALSE(judge(scene, in_float(drawn(one_side, 96, 64, profile)), profile, {}).is_explained());
}

TEST_CASE("every texture of a material, wherever it is placed and whatever its numbers mean, is explained") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    for (const ColourSpace colour_space : {ColourSpace::linear, ColourSpace::srgb})
      for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::clamp}) {
        Scene scene = half_textured(filter);
        Material& material = scene.objects[0].material;
        Texture texture{255, {material.diffuse_map.texture->levels[0]}};
        if (colour_space == ColourSpace::srgb) decode_srgb(texture);
        build_mip_levels(texture);
        TextureMap map{std::make_shared<const Texture>(texture), filter, wrap, {1.5, -2}, {0.25, 1.125}};
        material.diffuse_map = material.specular_map = map;
        map.scale = Double2(1), map.offset = Double2(0);
        material.emissive_map = map;
        material.emissive = {0.3, 0.2, 0.1};
        check_scene(std::string(name_of(filter)) + " " + std::string(name_of(wrap)), scene, 112, 63,
                    entered("llvmpipe"));
        // The test can fail: without one of them it is another picture.
        Scene without = scene;
        without.objects[0].material.specular_map = {};
        const DeviceProfile profile = entered("llvmpipe");
        CHECK_FALSE(judge(scene, in_float(drawn(without, 112, 63, profile)), profile, {}).is_explained());
      }
}

TEST_CASE("shadow maps through llvmpipe are explained, with every filter; most comparisons are decided") {
  constexpr int width = 112, height = 63;
  const DeviceProfile profile = entered("llvmpipe");
  for (const ShadowFilter filter : {ShadowFilter::nearest, ShadowFilter::two_by_two, ShadowFilter::pcf3}) {
    double coarser = 0.5; // most pixels have bounds of less than four levels, and more of them the finer the map
    for (const int size : {64, 300}) {
      ShadowMap map;
      map.size = size, map.filter = filter;
      const Scene scene = with_shadows(shadow_scene(), map);
      const std::string name = "shadow maps, " + std::string(name_of(filter));
      CHECK(check_scene(name, scene, width, height, profile) > 0.01);
      const Verdict verdict = judge(scene, in_8_bits(drawn(scene, width, height, profile)), profile, {});
      CHECK(verdict.count(PixelClass::shadow) < width * height / 50);
      CHECK(verdict.power.below_four > coarser);
      coarser = verdict.power.below_four;
    }
  }
  // The test can fail: without one light's shadow it is another picture.
  ShadowMap map;
  map.size = 256;
  const Scene scene = with_shadows(shadow_scene(), map);
  Scene wrong = scene;
  wrong.direction_lights[0].shadow = Shadow::none;
  CHECK_FALSE(judge(scene, in_float(drawn(wrong, width, height, profile)), profile, {}).is_explained());
}

TEST_CASE("shadow maps through softpipe are explained") {
  ShadowMap map;
  map.size = 96;
  for (const ShadowFilter filter : {ShadowFilter::nearest, ShadowFilter::pcf3}) {
    map.filter = filter;
    check_scene("shadow maps", with_shadows(shadow_scene(), map), 64, 36, entered("softpipe"));
  }
}

TEST_CASE("what llvmpipe cuts out by opacity is what is cut out here, or near the threshold") {
  check_leaves("llvmpipe", 112, 63);
  // The test can fail: at another threshold, and where nothing is cut out.
  const DeviceProfile profile = entered("llvmpipe");
  const Scene scene = leaf_scene(TextureFilter::bilinear);
  const test::TemporaryFolder folder;
  for (const std::string_view planted : {"< 0.6", "< 0.0"}) {
    const SeededFault fault{"planted", {}, {{FaultyStage::fragment, "< opacityThreshold", planted}}};
    const std::optional<Scene> faulty = with_fault(scene, fault, {112, 63}, folder.path);
    REQUIRE(faulty);
    const GlFrame frame = drawn(*faulty, 112, 63, profile);
    for (DeviceImage image : {in_8_bits(frame), in_float(frame)}) {
      image.ids = {}, image.depth = {}; // by its colours alone
      CHECK(judge(scene, image, profile, {}).count(PixelClass::unexplained) > 20);
    }
  }
}

TEST_CASE("normals that maps turn are explained, mirrored and from both sides; a wrong way of turning them is found") {
  const DeviceProfile profile = entered("llvmpipe");
  check_bricks(TextureFilter::nearest, BrickMaps::heights, profile);
  check_bricks(TextureFilter::bilinear, BrickMaps::both, profile);
  check_bricks(TextureFilter::trilinear, BrickMaps::normals, profile);
}

TEST_CASE("images of one row, of one column and of odd sides show the same surfaces, in colours that are explained") {
  const DeviceProfile profile = entered("llvmpipe");
  std::size_t scene = 0; // of each scene one size: all of them in the suite long
  for (const std::string& path : quick_scenes()) {
    const auto& [width, height] = odd_sizes[scene++ % std::size(odd_sizes)];
    check_scene(path, listed_scene(path), width, height, profile);
  }
}

TEST_CASE("what may be wrong grows with the distance from the lower left corner, where OpenGL's window begins") {
  // The same triangle in all four corners of the window, mirrored there: nothing but the distance differs.
  constexpr int side = 255;
  Phong dull;
  dull.ks = Double3(0);
  Scene scene = ball(dull);
  scene.point_lights.clear();
  scene.direction_lights = {{{0, 0, -1}, Double3(1)}};
  scene.camera.position = {0, 0, 1}; // and looks at the origin, with 90 degrees
  scene.camera.fov_y_degrees = 90;
  Object& object = scene.objects[0];
  Mesh triangle;
  triangle.positions = {{-1, -1, 0}, {-0.9375f, -1, 0.0625f}, {-1, -0.9375f, 0.0625f}};
  triangle.normals = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}};
  triangle.triangles = {{0, 1, 2}};
  object.mesh = std::make_shared<const Mesh>(triangle);
  object.rotate_degrees = Double3(0);
  const DeviceProfile profile = device_profile("llvmpipe");
  struct Errors {
    double normal, depth, colour;
  };
  const auto errors = [&](double mirror_x, double mirror_y) -> Errors {
    object.scale = {mirror_x, mirror_y, 1};
    RenderOptions options;
    options.width = options.height = side;
    const DeviceFrame frame(scene, options, profile, ShaderMatrices::one);
    const DeviceTriangle at(frame, 0);
    const int x = mirror_x > 0 ? 2 : side - 3, y = mirror_y > 0 ? side - 3 : 2;
    const ValueRange depth = at.depth(x + 0.5, y + 0.5);
    return {at.attribute_error(normal_row, x + 0.5, y + 0.5), depth.hi - depth.lo,
            PixelBounder(frame).bounds(at, x, y).colour.width()};
  };
  const auto check = [](const Errors& far, const Errors& near) {
    CHECK(far.normal > near.normal);
    CHECK(far.depth > near.depth);
    CHECK(far.colour > near.colour);
  };
  const Errors lower_left = errors(1, 1), lower_right = errors(-1, 1), upper_left = errors(1, -1),
               upper_right = errors(-1, -1);
  check(lower_right, lower_left);
  check(upper_left, lower_left);
  check(upper_right, lower_right);
  check(upper_right, upper_left);
}

TEST_CASE("on triangles without texture coordinates llvmpipe shows no texture either") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
    check_scene("half_textured", half_textured(filter), 160, 90, entered("llvmpipe"));
}

TEST_CASE(
    "colours of vertices through llvmpipe are explained, with a texture and without, and their absence is found") {
  Scene coloured = half_textured(TextureFilter::bilinear);
  Mesh mesh = *coloured.objects[0].mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.colours.emplace_back(static_cast<float>(i % 7) / 6, 0.25f, static_cast<float>(i % 3));
  mesh.colours.resize(mesh.colours.size() * 3 / 4); // the others are white
  Scene white = coloured;
  coloured.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  const DeviceProfile profile = entered("llvmpipe");
  check_scene("vertex colours", coloured, 160, 90, profile);
  const Verdict verdict = judge(coloured, in_8_bits(drawn(white, 160, 90, profile)), profile, {});
  CHECK(verdict.count(PixelClass::unexplained) > 1000);
}

TEST_SUITE_BEGIN("slow");

TEST_CASE("a ground seen edge on through llvmpipe without its shortcuts has levels of detail that are explained") {
  // Toward the horizon a row's step in the texture is up to twice that of the row below: it tells which two rows make
  // a block. In a window of odd height the lowest row begins a block, and the highest has one of its own.
  Texture stripes;
  stripes.levels.push_back({1, 64, {}});
  for (int i = 0; i < 64; ++i)
    for (int c = 0; c < 3; ++c) stripes.levels[0].rgb.push_back(i % 7 < 3 ? 255.0f : 10.0f);
  build_mip_levels(stripes);
  Scene scene = ball(Phong{});
  Object& ground = scene.objects[0];
  ground.mesh = std::make_shared<const Mesh>(plane_mesh(1));
  ground.position = {0, -1, 0};
  ground.scale = {20, 1, 20};
  ground.rotate_degrees = Double3(0);
  ground.material.diffuse_map.texture = std::make_shared<const Texture>(stripes);
  ground.material.diffuse_map.filter = TextureFilter::trilinear;
  for (const auto& [width, height] : {std::pair(32, 32), std::pair(32, 33), std::pair(33, 35)}) {
    check_scene("stripes", scene, width, height, entered("llvmpipe-precise"));
  }
}

TEST_CASE("what opacity cuts out through llvmpipe without its shortcuts is explained") {
  check_leaves("llvmpipe-precise", 128, 72);
}

TEST_CASE("what opacity cuts out through softpipe is explained") {
  check_leaves("softpipe", 96, 54);
}

TEST_SUITE_END();

TEST_SUITE("long") {
  TEST_CASE("images of all odd sizes, of every quick scene, are explained") {
    const DeviceProfile profile = entered("llvmpipe");
    for (const std::string& path : quick_scenes())
      for (const auto& [width, height] : odd_sizes) check_scene(path, listed_scene(path), width, height, profile);
  }

  TEST_CASE("normals that maps turn are explained, by every filter and of every kind of map") {
    const DeviceProfile profile = entered("llvmpipe");
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear})
      for (const BrickMaps maps : {BrickMaps::normals, BrickMaps::heights, BrickMaps::both})
        check_bricks(filter, maps, profile);
  }
}
