// Objects that are drawn with many materials.

#include <refraster/render.h>

#include "tests/support/precisions.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <memory>
#include <vector>

namespace refraster::test {
namespace {

constexpr int columns = 8;

Material shining_in(const Double3& colour) {
  Phong phong;
  phong.ka = colour, phong.kd = phong.ks = Double3(0);
  Material material;
  material.fragment_function = phong;
  return material;
}

/// A quad over each column of pixels, two triangles each; triangle i has the colour of (i + 1) / 16 in red.
WindowScene stripes(const std::vector<TriangleRun>& runs, std::size_t materials) {
  WindowScene window(columns);
  std::vector<Float3> corners;
  for (int x = 0; x < columns; ++x) {
    const Float3 a = window.place(x, 0, 1), b = window.place(x + 1, 0, 1), c = window.place(x + 1, columns, 1),
                 d = window.place(x, columns, 1);
    corners.insert(corners.end(), {a, b, c, a, c, d});
  }
  Object& object = window.add(corners);
  auto mesh = std::make_shared<Mesh>(*object.mesh);
  mesh->material_runs = runs;
  object.mesh = mesh;
  object.material = shining_in(Double3(0, 0, 1));
  for (std::size_t i = 0; i < materials; ++i)
    object.materials.push_back(shining_in(Double3(static_cast<double>(i + 1) / 16, 0, 0)));
  return window;
}

/// Of the middle of each column, in row 0, where the first triangle of its quad is seen.
std::vector<Float3> colours(const WindowScene& window, Precision precision, int samples) {
  RenderOptions options = window.options({Aov::object}, samples);
  options.precision = precision;
  const Frame frame = render(window.scene, options);
  std::vector<Float3> result;
  for (int x = 0; x < columns; ++x) {
    const float* const rgb = frame.radiance.at(x, 0);
    result.push_back({rgb[0], rgb[1], rgb[2]});
  }
  return result;
}

Float3 red(int material) {
  return {static_cast<float>(material + 1) / 16, 0, 0};
}
const Float3 blue(0, 0, 1);

} // namespace

TEST_CASE("each triangle has the material of its run; before the first run, and of none that is there, the object's") {
  const WindowScene window = stripes({{4, 1}, {6, 0}, {8, 1}, {10, no_material}, {12, 2}, {14, 7}}, 3);
  const std::vector<Float3> expected = {blue, blue, red(1), red(0), red(1), blue, red(2), blue};
  for (const Precision precision : every_precision)
    for (const int samples : {1, 4}) CHECK(colours(window, precision, samples) == expected);
}

TEST_CASE("a run may begin in the middle of a quad, and be one triangle long") {
  const WindowScene window = stripes({{0, 0}, {1, 1}, {2, 0}}, 2);
  const Frame frame = window.frame();
  CHECK(frame.radiance.at(0, 0)[0] == red(0).x);           // above the diagonal
  CHECK(frame.radiance.at(0, columns - 1)[0] == red(1).x); // below
  CHECK(frame.radiance.at(1, columns - 1)[0] == red(0).x);
}

TEST_CASE("a list of materials without runs, and runs without a list, leave the object's material") {
  for (const WindowScene& window : {stripes({}, 2), stripes({{0, 0}}, 0)})
    CHECK(colours(window, Precision::double_, 1) == std::vector<Float3>(columns, blue));
}

TEST_CASE("an object of many materials is drawn as one object for each, in the order of its triangles") {
  const WindowScene whole = stripes({{0, 0}, {3, 1}, {7, 2}, {9, 0}}, 3);
  WindowScene parts(columns);
  const Object& object = whole.scene.objects[0];
  for (std::uint32_t i = 0; i < object.mesh->triangles.size(); ++i) {
    Object part = object;
    auto mesh = std::make_shared<Mesh>(*object.mesh);
    mesh->triangles = {object.mesh->triangles[i]};
    mesh->material_runs.clear();
    part.mesh = mesh, part.material = material_of(object, i), part.materials.clear();
    parts.scene.objects.push_back(part);
  }
  for (const int samples : {1, 8})
    CHECK(whole.frame({}, samples).radiance.values == parts.frame({}, samples).radiance.values);
}

TEST_CASE("runs that are not in the order of triangles are refused, and materials are checked one by one") {
  WindowScene window = stripes({{4, 1}, {4, 0}}, 3);
  std::get<Phong>(window.scene.objects[0].materials[2].fragment_function).glossiness = -1;
  const std::vector<SceneFault> faults = validate(window.scene);
  REQUIRE(faults.size() == 2);
  CHECK(faults[0].text() == "objects/0/mesh/material_runs/1: found first triangle 4, expected more than 4, that of the "
                            "run before");
  CHECK(faults[1].text() == "objects/0/materials/2/glossiness: found -1, expected finite numbers from 0");
  CHECK(faults[1].effect == SceneFault::Effect::drawn);
}

} // namespace refraster::test
