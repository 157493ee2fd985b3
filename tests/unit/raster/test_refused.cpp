// What a caller can get wrong is told, in every build: render() throws before it draws.

#include <refraster/mesh.h>
#include <refraster/render.h>
#include <refraster/scene.h>

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

using namespace refraster;

namespace {

Scene ball() {
  Scene scene;
  scene.camera.position = {0, 0, 4};
  Object object;
  object.mesh = std::make_shared<const Mesh>(sphere_mesh(16, 8));
  scene.objects.push_back(object);
  return scene;
}

std::string refusal(const Scene& scene, const RenderOptions& options) {
  try {
    render(scene, options);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("options out of their range are refused, each by its name") {
  struct Row {
    std::function<void(RenderOptions&)> spoil;
    const char* text;
  };
  const Row rows[] = {
      {[](auto& o) { o.width = 0; },
       "options/width and height: found 0 x 48 pixels, expected 1 to 16384 pixels a side"},
      {[](auto& o) { o.height = 16385; },
       "options/width and height: found 64 x 16385 pixels, expected 1 to 16384 pixels a side"},
      {[](auto& o) { o.samples = 3; }, "options/samples: found 3, expected 1, 2, 4, 8 or 16"},
      {[](auto& o) { o.tile_size = 48; }, "options/tile_size: found 48, expected 8, 16, 32, 64 or 128"},
      {[](auto& o) { o.tile_size = 0; }, "options/tile_size: found 0, expected 8, 16, 32, 64 or 128"},
      {[](auto& o) { o.threads = -1; }, "options/threads: found -1, expected 0 or more"},
      {[](auto& o) { o.precision = static_cast<Precision>(9); },
       "options/precision: found 9, expected one of the enum"},
      {[](auto& o) {
         o.crop = PixelRect{60, 0, 5, 5};
       },
       "options/crop: found 5 x 5 pixels at (60, 0), expected a part of the image of 64 x 48 pixels"},
      {[](auto& o) {
         o.crop = PixelRect{0, -1, 5, 5};
       },
       "options/crop: found 5 x 5 pixels at (0, -1), expected a part of the image of 64 x 48 pixels"},
      {[](auto& o) {
         o.crop = PixelRect{1, 1, std::numeric_limits<int>::max(), 5};
       },
       "options/crop: found 2147483647 x 5 pixels at (1, 1), expected a part of the image of 64 x 48 pixels"},
  };
  for (const Row& row : rows) {
    RenderOptions options{.width = 64, .height = 48};
    row.spoil(options);
    CHECK(refusal(ball(), options) == row.text);
  }
}

TEST_CASE("render refuses the first fault of a scene that validate() calls refused, wherever it stands") {
  const RenderOptions options{.width = 64, .height = 48, .threads = 2};
  const std::function<void(Scene&)> spoils[] = {
      [](Scene& s) { s.objects[0].mesh = nullptr; },
      [](Scene& s) { s.camera.far = std::numeric_limits<double>::infinity(); },
      [](Scene& s) { s.objects[0].material.fragment_function = Merl{}; },
      [](Scene& s) { s.objects[0].material.diffuse_map.texture = std::make_shared<Texture>(); },
      [](Scene& s) {
        auto mesh = std::make_shared<Mesh>(*s.objects[0].mesh);
        mesh->triangles.back()[1] = 4000000000;
        s.objects[0].mesh = mesh;
      },
      [](Scene& s) {
        auto mesh = std::make_shared<Mesh>(*s.objects[0].mesh);
        mesh->positions.clear(), mesh->normals.clear(), mesh->uvs.clear();
        s.objects[0].mesh = mesh;
      },
  };
  Renderer renderer;
  Frame frame;
  const Frame expected = render(ball(), options);
  for (const auto& spoil : spoils) {
    Scene scene = ball();
    spoil(scene);
    const std::vector<SceneFault> faults = validate(scene);
    REQUIRE(faults.size() == 1);
    CHECK(refusal(scene, options) == faults[0].text());
    // And the renderer is good for the next frame.
    CHECK_THROWS_AS(renderer.render(scene, options, frame), std::invalid_argument);
    renderer.render(ball(), options, frame);
    CHECK(frame.rgb8.values == expected.rgb8.values);
  }
}

TEST_CASE("what is out of range but finite is drawn, and so is a mesh with a vertex that is not finite") {
  Scene scene = ball();
  scene.background = Double3(-1);
  auto mesh = std::make_shared<Mesh>(*scene.objects[0].mesh);
  mesh->positions[20].x = std::numeric_limits<float>::quiet_NaN();
  scene.objects[0].mesh = mesh;
  CHECK(validate(scene).size() == 2);
  const Frame frame = render(scene, {.width = 64, .height = 48, .threads = 1});
  CHECK(frame.counts.not_finite > 0);
  CHECK(frame.counts.drawn > 0);
}
