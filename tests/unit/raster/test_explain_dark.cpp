// Why an image shows nothing: each reason, and silence where it shows something.

#include <refraster/mesh.h>

#include "raster/explain/explain_dark.h"
#include "tests/support/shading/merl_tables.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace refraster;

namespace {

/// Matt: by the textbook's formula, a light behind a surface makes a highlight on its rim all the same.
Phong matt() {
  Phong phong;
  phong.ks = Double3(0);
  return phong;
}

/// Balls of radius 1, seen by a camera at the origin that looks along -z. Lit from the eye.
Scene scene_of(const std::vector<Double3>& places) {
  Scene scene;
  scene.direction_lights = {{{0, 0, -1}, {1, 1, 1}}};
  const auto sphere = std::make_shared<const Mesh>(sphere_mesh(24, 12));
  for (const Double3& place : places) {
    Object object;
    object.name = "ball " + std::to_string(scene.objects.size());
    object.mesh = sphere;
    object.position = place;
    object.material.fragment_function = matt();
    scene.objects.push_back(object);
  }
  return scene;
}

RenderOptions small() {
  RenderOptions options;
  options.width = 64, options.height = 48;
  options.threads = 1;
  return options;
}

RenderOptions small_radiance() {
  RenderOptions options = small();
  options.want_rgb8 = false;
  options.want_radiance = true;
  return options;
}

std::string explained(const Scene& scene, const RenderOptions& options = small()) {
  const Frame frame = render(scene, options);
  return explain_dark_image(scene, options, {frame.rgb8, frame.radiance}, frame.counts.shaded);
}

const std::string background_only = "the image shows background only: ";

/// What is said of surfaces that are seen and dark; fails where nothing is.
std::string reason(const Scene& scene, const RenderOptions& options = small()) {
  const std::string text = explained(scene, options);
  const std::size_t colon = text.find(": ");
  REQUIRE_MESSAGE(colon != std::string::npos, text);
  CHECK(text.find("nearly black") != std::string::npos);
  return text.substr(colon + 2);
}

Object flat(const std::vector<Float3>& corners, const Float3& normal) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = corners;
  mesh->normals.assign(corners.size(), normal);
  mesh->triangles = {{0, 1, 2}};
  Object object;
  object.name = "flat";
  object.mesh = mesh;
  object.material.fragment_function = matt();
  return object;
}

Scene measured(std::shared_ptr<const MerlTable> table) {
  Scene scene = scene_of({{0, 0, -5}});
  Merl merl;
  merl.table = std::move(table);
  scene.objects[0].material.fragment_function = merl;
  return scene;
}

} // namespace

TEST_CASE("an image that shows a lit surface is not explained, whatever its background and format") {
  for (const double background : {0.0, 0.2, 8.0}) {
    Scene scene = scene_of({{0, 0, -5}});
    scene.background = Double3(background);
    for (const int samples : {1, 16})
      for (RenderOptions options : {small(), small_radiance()}) {
        options.samples = samples;
        CHECK(explained(scene, options) == "");
      }
  }
}

TEST_CASE("a scene without objects, and one with a mesh of no triangle") {
  CHECK(explained(Scene{}) == background_only + "the scene has no objects");
  Scene scene = scene_of({{0, 0, -5}});
  scene.objects[0].mesh = std::make_shared<const Mesh>();
  CHECK(explained(scene) == background_only + "the only object, \"ball 0\", has no triangle");
}

TEST_CASE("objects beyond the far plane: how far the nearest is") {
  // The nearest vertex is the pole that looks at the eye, or the nearest of a ring: 571 and 570 in front of it.
  Scene scene = scene_of({{0, 0, -900}, {0, 0, -571}, {0, 0, -800}});
  CHECK(explained(scene) == background_only + "all 3 objects lie beyond the far plane, 100; the nearest is 570 away");
  // 1.1 away from a far plane at 1: as many digits as show that it is beyond.
  scene = scene_of({{0, 0, -2.00001}});
  scene.camera.far = 1;
  CHECK(explained(scene) ==
        background_only + "the only object, \"ball 0\", lies beyond the far plane, 1; it is 1.00001 away");
}

TEST_CASE("objects around the camera, of which only what is in the view counts") {
  Scene scene = scene_of({{0, 0, 0}});
  scene.objects[0].scale = Double3(1000);
  CHECK(explained(scene).find("lies beyond the far plane, 100; it is ") != std::string::npos);
}

TEST_CASE("objects on one side of the view") {
  const std::string lies = background_only + "the only object, \"ball 0\", lies ";
  CHECK(explained(scene_of({{0, 0, 5}})) == lies + "behind the camera");
  CHECK(explained(scene_of({{-30, 0, -5}})) == lies + "outside the view to the left");
  CHECK(explained(scene_of({{30, 0, -5}})) == lies + "outside the view to the right");
  CHECK(explained(scene_of({{0, -30, -5}})) == lies + "outside the view, below it");
  CHECK(explained(scene_of({{0, 30, -5}})) == lies + "outside the view, above it");
  Scene near = scene_of({{0, 0, -5}});
  near.camera.near = 7;
  CHECK(explained(near) == lies + "nearer than the near plane, 7");
  // On two sides of a corner of the view: a triangle whose vertices are outside of different planes.
  Scene corner;
  corner.objects = {flat({{-9, 0, -5}, {0, -9, -5}, {-9, -9, -5}}, {0, 0, 1})};
  CHECK(explained(corner) == background_only + "the only object, \"flat\", lies outside the view");
}

TEST_CASE("objects of several fates are reported group by group") {
  CHECK(explained(scene_of({{0, 0, 5}, {0, 0, -300}, {0, 0, 9}})) ==
        background_only +
            "2 objects lie behind the camera; the object \"ball 1\" lies beyond the far plane, 100; it is 299 away");
  CHECK(explained(scene_of({{0, 0, 5}, {0, 0, 9}})) == background_only + "both objects lie behind the camera");
}

TEST_CASE("triangles that face away and are culled, also those of a mirrored object") {
  Scene scene;
  scene.objects = {flat({{-1, -1, -5}, {0, 1, -5}, {1, -1, -5}}, {0, 0, 1})}; // clockwise
  scene.objects[0].cull = Cull::back;
  CHECK(explained(scene) == background_only + "all triangles face away and are culled (\"cull\": \"back\")");
  scene.objects[0].scale = {-1, 1, 1};
  CHECK(render(scene, small()).counts.shaded > 0);
}

TEST_CASE("surfaces of which nothing is left by their opacity") {
  Scene scene = scene_of({{0, 0, -5}, {0, 0, 9}});
  TextureMap& map = scene.objects[0].material.opacity_map;
  map.texture = std::make_shared<const Texture>(Texture{255, {TextureLevel{1, 1, {127, 127, 127}}}});
  CHECK(explained(scene) ==
        background_only + "all of the object \"ball 0\" is cut out: its opacity is below the threshold at the pixels' "
                          "centres (\"opacity_map\"); the object \"ball 1\" lies behind the camera");
  scene.objects[0].material.opacity_threshold = 0.25;
  CHECK(render(scene, small()).counts.shaded > 0);
}

TEST_CASE("triangles without area and without a pixel's centre") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.objects[0].scale = {0, 0, 1};
  CHECK(explained(scene) == background_only + "the only object, \"ball 0\", has no area: each triangle is a line or a "
                                              "point");
  scene.objects = {flat({{0.1f, 0.3f, -5}, {0.2f, 0.3f, -5}, {0.4f, 0.3f, -5}}, {0, 0, 1})};
  CHECK(explained(scene).find("has no area") != std::string::npos);
  scene = scene_of({{0.01, 0.01, -5}});
  scene.objects[0].scale = Double3(1e-4);
  CHECK(explained(scene) ==
        background_only + "the only object, \"ball 0\", covers no pixel's centre: too small or too thin in the image");
}

TEST_CASE("vertices beyond a double") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.objects[0].scale = Double3(1e308);
  scene.objects[0].position = Double3(1.7e308);
  CHECK(explained(scene) ==
        background_only + "the only object, \"ball 0\", has no vertex within the range of a double");
}

TEST_CASE("a crop beside what the image shows") {
  RenderOptions options = small();
  options.crop = PixelRect{0, 0, 10, 10};
  CHECK(explained(scene_of({{0, 0, -5}}), options) ==
        "the crop shows background only: the only object, \"ball 0\", lies outside the crop");
  CHECK(explained(scene_of({{0, 0, -5}})) == "");
}

TEST_CASE("a scene without light, with and without ambient reflection") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights.clear();
  CHECK(explained(scene) == "the image is nearly black, no value above 13 of 255: the scene has no light, only ambient "
                            "reflection (ka)"); // 0.05 * 255
  std::get<Phong>(scene.objects[0].material.fragment_function).ka = Double3(0);
  CHECK(explained(scene) ==
        "the image is nearly black, no value above 0 of 255: the scene has no light and ambient is 0");
  scene.point_lights = {{{0, 0, 0}, {0, 0, 0}}, {{0, 1, 0}, {0, 0, 0}}};
  CHECK(reason(scene) == "both lights have radiance 0");
}

TEST_CASE("lights behind what is seen, by n.l at its pixels") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights = {{{0, 0, 1}, {1, 1, 1}}}; // from behind the ball: no point of the side that is seen
  CHECK(reason(scene) == "no light reaches what is seen: the only light is behind it");
  scene.point_lights = {{{0, 0, -50}, {1, 1, 1}}};
  CHECK(reason(scene) == "no light reaches what is seen: both lights are behind it");
  scene.point_lights.push_back({{0, 0, -60}, {0, 0, 0}});
  CHECK(reason(scene) == "no light reaches what is seen: all 3 lights are behind it or have radiance 0");
  scene.point_lights.clear();
  scene.direction_lights[0].direction = {1, 0, 0.05}; // grazes a part of it
  CHECK(explained(scene) == "");
}

TEST_CASE("a bright background does not hide that all surfaces are black") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights.clear();
  scene.background = {0.3, 0.5, 2.0};
  for (const int samples : {1, 16})
    for (RenderOptions options : {small(), small_radiance()}) {
      options.samples = samples;
      options.transfer = Transfer::linear;
      if (options.want_radiance) std::get<Phong>(scene.objects[0].material.fragment_function).ka = Double3(0.005);
      CAPTURE(samples);
      CAPTURE(options.want_radiance);
      CHECK(explained(scene, options).substr(0, 41) == "all surfaces are nearly black, none above");
    }
}

TEST_CASE("a light that is too weak, and what of the others is behind") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights[0].radiance = Double3(0.02);
  std::get<Phong>(scene.objects[0].material.fragment_function).ka = Double3(0);
  CHECK(reason(scene) == "little light reaches what is seen, 0.02 at most (radiance times attenuation times n.l)");
  scene.point_lights = {{{0, 0, -50}, {1, 1, 1}}};
  CHECK(reason(scene) ==
        "little light reaches what is seen, 0.02 at most (radiance times attenuation times n.l); 1 of 2 "
        "lights is behind it");
}

TEST_CASE("surfaces that reflect nothing or little") {
  Scene scene = scene_of({{0, 0, -5}});
  Phong& phong = std::get<Phong>(scene.objects[0].material.fragment_function);
  phong.ka = phong.kd = phong.ks = Double3(0);
  CHECK(reason(scene) == "what is seen reflects no light: kd and ks are 0");
  phong.kd = Double3(0.05);
  CHECK(reason(scene) == "what is seen reflects little of the light that arrives, which is up to 1 (radiance times "
                         "attenuation times n.l)");
}

TEST_CASE("normals that point away from the camera, or nowhere") {
  Scene scene;
  scene.direction_lights = {{{0, 0, -1}, {1, 1, 1}}};
  scene.objects = {flat({{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}}, {0, 0, -1})};
  CHECK(reason(scene) == "no light reaches what is seen: the only light is behind it; its normals point away from the "
                         "camera");
}

TEST_CASE("measured tables without a measured sample, and of zeros") {
  CHECK(reason(measured(table_of([](int, int, int) { return Rgb<double>(-1); }))) ==
        "the table has no measured sample");
  CHECK(reason(measured(table_of([](int, int, int) { return Rgb<double>(0); }))) == "the table has no sample above 0");
  CHECK(explained(measured(table_of([](int, int, int) { return Rgb<double>(1); }))) == "");
  Scene scene = measured(table_of([](int, int, int) { return Rgb<double>(1); }));
  scene.direction_lights = {{{0, 0, 1}, {1, 1, 1}}};
  CHECK(reason(scene) == "no light reaches what is seen: the only light is behind it");
}

TEST_CASE("a measured surface seen from the side that its normals point away from") {
  Scene scene = measured(table_of([](int, int, int) { return Rgb<double>(1); }));
  const Material material = scene.objects[0].material;
  scene.objects = {flat({{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}}, {0, 0, -1})};
  scene.objects[0].material = material;
  scene.direction_lights = {{{0, 0, 1}, {1, 1, 1}}}; // on that side
  CHECK(reason(scene) ==
        "the normals of what is seen point away from the camera, and a measured BRDF is 0 on that side");
}

TEST_CASE("nearly black is what is shown: up to 25 of 255, by whatever curve; in a float image up to 0.01") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights.clear();
  const auto with_ambient = [&](double ka) -> const Scene& {
    std::get<Phong>(scene.objects[0].material.fragment_function).ka = Double3(ka);
    return scene;
  };
  CHECK(explained(with_ambient(25.4 / 255)) != "");
  CHECK(explained(with_ambient(25.6 / 255)) == "");
  RenderOptions srgb = small();
  srgb.transfer = Transfer::srgb;
  CHECK(explained(with_ambient(0.0099), srgb) != ""); // a hundredth of white is 25.46
  CHECK(explained(with_ambient(0.0102), srgb) == "");
  CHECK(explained(with_ambient(0.0099), small_radiance()) != "");
  CHECK(explained(with_ambient(0.0101), small_radiance()) == "");
}

TEST_CASE("a large image is explained in fewer pixels, and OpenGL's without counts") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights = {{{0, 0, 1}, {1, 1, 1}}};
  RenderOptions options = small();
  options.width = 3000, options.height = 1500;
  CHECK(reason(scene, options) == "no light reaches what is seen: the only light is behind it");
  const Frame frame = render(scene, small());
  CHECK(explain_dark_image(scene, small(), {frame.rgb8, frame.radiance}, std::nullopt) == explained(scene));
  const Scene empty;
  const Frame of_nothing = render(empty, small());
  CHECK(explain_dark_image(empty, small(), {of_nothing.rgb8, of_nothing.radiance}, std::nullopt) ==
        background_only + "the scene has no objects");
}

TEST_CASE("where memory does not suffice for an explanation there is none") {
  Scene scene = scene_of({{0, 0, -5}});
  scene.direction_lights.clear();
  RenderOptions options = small();
  const Frame frame = render(scene, options);
  options.memory = MemoryBudget(1, [] { return std::uint64_t{1}; });
  CHECK(explain_dark_image(scene, options, {frame.rgb8, frame.radiance}, frame.counts.shaded) == "");
}
