// Opacity decides visibility: once a pixel and triangle, at the pixel's centre and in double, for every precision.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "raster/shade/opacity.h"
#include "tests/support/invariants.h"
#include "tests/support/precisions.h"
#include "tests/support/random.h"
#include "tests/support/scenes/leaf_scene.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/scenes/same_parts.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace refraster::test {
namespace {

constexpr int side = 16;
/// Rows from v = 0 upward: texel (i, j) is i + side j, of 255.
TextureMap numbered() {
  auto texture = std::make_shared<Texture>();
  TextureLevel level{side, side, {}};
  for (int i = 0; i < side * side; ++i)
    for (int c = 0; c < 3; ++c) level.rgb.push_back(static_cast<float>(i));
  texture->levels.push_back(std::move(level));
  TextureMap map;
  map.texture = std::move(texture), map.filter = TextureFilter::nearest;
  return map;
}

/// Two squares that fill the image, one behind the other: red before green. Pixel (x, y) has texel (x, side - 1 - y) at
/// its centre.
Scene two_posters() {
  Scene scene;
  scene.camera.position = {0, 0, 1};
  scene.camera.target = {0, 0, 0};
  scene.camera.fov_y_degrees = 90;
  Mesh mesh = leaf_card(1);
  Object front;
  front.mesh = std::make_shared<const Mesh>(std::move(mesh));
  Phong black;
  black.ka = black.kd = black.ks = Double3(0);
  front.material.fragment_function = black;
  Object back = front;
  front.material.emissive = {1, 0, 0}, back.material.emissive = {0, 1, 0};
  back.position.z = -1, back.scale = Double3(2);
  front.material.opacity_map = numbered();
  scene.objects = {front, back};
  return scene;
}

RenderOptions of_side(Precision precision, int samples) {
  RenderOptions options;
  options.width = options.height = side;
  options.precision = precision, options.samples = samples;
  options.want_radiance_double = true;
  options.aovs = {Aov::object, Aov::depth};
  return options;
}

/// The geometry of a frame, before it is drawn.
struct Prepared {
  RenderOptions options;
  Geometry geometry;
  Bins bins;
  FrameContext context;

  Prepared(const Scene& scene, const RenderOptions& its_options)
      : options(its_options), context{{scene, options}, geometry, bins} {
    transform(context, geometry);
    FrameCounts counts;
    bin_triangles(context, geometry, bins, counts);
  }
  bool is_cut_out(std::uint32_t number, int x, int y) const {
    const TriangleRef ref = TriangleFinder(context.scene, geometry).at(number);
    const Material& material = material_of(context.scene.objects[ref.object], ref.triangle);
    if (!material.has_cut_outs()) return false;
    // A triangle that was dropped has no opacity, and need not be cut out.
    const std::array<WindowVertex, 3> v = window_corners(geometry, ref);
    const int states = v[0].outcode | v[1].outcode | v[2].outcode;
    if ((states & outcode::not_finite) || ((states & outcode::unsnapped) && !bins.find_projective(number)))
      return false;
    return opacity_at(context, number, x, y) < material.opacity_threshold;
  }
};

/// The scene as pixel (x, y) sees it: triangles that are cut out there are left out, and no opacity is looked at.
Scene without_cut_out(const Scene& scene, const Prepared& prepared, int x, int y) {
  Scene result = scene;
  std::uint32_t number = 0;
  for (Object& object : result.objects) {
    Mesh mesh = *object.mesh;
    for (auto& triangle : mesh.triangles)
      if (prepared.is_cut_out(number++, x, y)) triangle[1] = triangle[2] = triangle[0]; // no area: dropped
    object.mesh = std::make_shared<const Mesh>(std::move(mesh));
    object.material.opacity_threshold = 0; // nothing is below it
    for (Material& material : object.materials) material.opacity_threshold = 0;
  }
  return result;
}

/// That each pixel of a picture is the pixel of the scene without what is cut out there. Returns how many pixels that
/// changes.
int check_pixel_by_pixel(const Scene& scene, RenderOptions options) {
  options.want_radiance_double = true;
  const Frame frame = render(scene, options);
  Scene whole = scene;
  for (Object& object : whole.objects) {
    object.material.opacity_threshold = 0;
    for (Material& material : object.materials) material.opacity_threshold = 0;
  }
  const Frame uncut = render(whole, options);
  const Prepared prepared(scene, options);
  int changed = 0;
  for (int y = 0; y < options.height; ++y)
    for (int x = 0; x < options.width; ++x) {
      RenderOptions one = options;
      one.crop = PixelRect{x, y, 1, 1};
      one.threads = 1;
      const Frame expected = render(without_cut_out(scene, prepared, x, y), one);
      CAPTURE(x);
      CAPTURE(y);
      bool differs = false;
      for (int c = 0; c < 3; ++c) {
        CHECK(frame.radiance_double.at(x, y)[c] == expected.radiance_double.at(0, 0)[c]);
        differs |= frame.radiance_double.at(x, y)[c] != uncut.radiance_double.at(x, y)[c];
      }
      changed += differs;
    }
  return changed;
}

} // namespace

TEST_CASE(
    "below the threshold nothing of a triangle is in a pixel, and what is behind it is seen, in every precision") {
  for (const Precision precision : every_precision)
    for (const int samples : {1, 2, 4, 8, 16})
      for (const double threshold : {0.0, 100 / 255.0, 0.5, 1.0}) {
        Scene scene = two_posters();
        scene.objects[0].material.opacity_threshold = threshold;
        const Frame frame = render(scene, of_side(precision, samples));
        for (int y = 0; y < side; ++y)
          for (int x = 0; x < side; ++x) {
            const bool there = (x + side * (side - 1 - y)) / 255.0 >= threshold;
            CHECK(frame.radiance_double.at(x, y)[0] == (there ? 1 : 0));
            CHECK(frame.radiance_double.at(x, y)[1] == (there ? 0 : 1));
            CHECK(frame.aovs[0].at(x, y)[0] == (there ? 1.0f : 2.0f));
            CHECK((frame.aovs[1].at(x, y)[0] < 0.95f) == there); // of near 0.1 and far 100: at 1, and at 2
          }
        CHECK(frame.counts.shaded == side * side);
        if (samples == 1) CHECK(frame.counts.fragments == side * side);
      }
}

TEST_CASE("what has no texture coordinates is there") {
  Scene scene = two_posters();
  Mesh mesh = *scene.objects[0].mesh;
  mesh.uvs.clear();
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  const Frame frame = render(scene, of_side(Precision::double_, 1));
  CHECK(std::all_of(frame.aovs[0].values.begin(), frame.aovs[0].values.end(), [](float o) { return o == 1; }));
}

TEST_CASE("of a triangle that does not reach a pixel's centre the opacity there decides, where its plane is") {
  // From a quarter of a pixel right of the centres of column 7: of its eight samples there are some beyond that. The
  // centre's u is -1/64 of the card's width: the last column where it repeats, the first where its edge goes on.
  Scene scene = two_posters();
  scene.objects[0].position.x = 0.75 / side * 2 + 7.0 / side * 2; // the left edge from -1 to column 7.75
  auto halves = std::make_shared<Texture>();
  halves->levels.push_back({2, 1, {0, 0, 0, 255, 255, 255}});
  TextureMap& map = scene.objects[0].material.opacity_map;
  map.texture = halves;
  const auto red = [&](TextureWrap wrap) {
    map.wrap = wrap;
    return render(scene, of_side(Precision::double_, 8)).radiance_double.at(7, 8)[0];
  };
  CHECK(red(TextureWrap::repeat) == 0.25); // two of the standard samples are at 3/16 and more: (5, 1) and (7, -7)
  CHECK(red(TextureWrap::clamp) == 0);
}

TEST_CASE("each pixel is that of the scene without what is cut out there: leaves of all sizes, near and far") {
  for (const auto& [filter, samples] : {std::pair(TextureFilter::nearest, 1), std::pair(TextureFilter::bilinear, 8),
                                        std::pair(TextureFilter::trilinear, 2)}) {
    RenderOptions options;
    options.width = 36, options.height = 24, options.samples = samples, options.tile_size = 16;
    CHECK(check_pixel_by_pixel(leaf_scene(filter), options) > 120);
  }
}

TEST_CASE("and in random scenes") {
  int changed = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    Random random(seed), own(seed + 1000);
    Scene scene = random_scene(random);
    for_each_light_list(scene, [](auto& lights) { // which are those of whole triangles
      for (auto& light : lights) light.shadow = Shadow::none;
    });
    for (Object& object : scene.objects) {
      if (object.mesh->triangles.size() > 500) continue; // takes long
      object.material.opacity_map = leaf_scene(TextureFilter::bilinear).objects[0].material.opacity_map;
      object.material.opacity_threshold = own.uniform(0.1, 0.9);
    }
    RenderOptions options;
    options.width = 13, options.height = 9, options.tile_size = 8;
    options.samples = seed % 2 ? 1 : 4;
    if (!validate(scene).empty()) continue;
    changed += check_pixel_by_pixel(scene, options);
  }
  CHECK(changed > 100);
}

TEST_CASE("pictures with cut-outs have the same bits for any threads, tiles and crop") {
  const Scene scene = leaf_scene(TextureFilter::trilinear);
  RenderOptions options;
  options.width = 150, options.height = 90, options.samples = 4, options.want_radiance_double = true;
  options.aovs = all_aovs();
  CHECK(fault_of(render(scene, options), scene, options) == "");
  check_same_parts(scene, options);
}

TEST_CASE("a picture with a map that cuts nothing out has the bits of one without") {
  const Scene scene = leaf_scene(TextureFilter::bilinear, 0);
  Scene without = scene;
  for (Object& object : without.objects) object.material.opacity_map = {};
  RenderOptions options;
  options.width = 80, options.height = 60, options.samples = 2;
  CHECK(difference(render(scene, options), render(without, options)) == "");
  // The test can fail: a threshold makes another picture.
  CHECK(difference(render(leaf_scene(TextureFilter::bilinear), options), render(without, options)) != "");
}

} // namespace refraster::test
