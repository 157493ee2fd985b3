// What corners bring of a declared vertex attribute.

#include "raster/shade/corner_values.h"

#include <doctest/doctest.h>

#include <array>

namespace refraster {
namespace {

Object scaled_and_moved() {
  Object object;
  object.position = {10, 20, 30};
  object.scale = {2, 3, 4};
  return object;
}

std::array<double, 3> corner(Transformed transformed, std::uint32_t vertex = 0) {
  Mesh mesh;
  mesh.positions = {Float3(0), Float3(0)};
  mesh.normals = {Float3(1)};
  VertexAttribute<Float3> attribute{&Mesh::normals};
  attribute.transformed = transformed, attribute.otherwise = 0.5f;
  return corner_value(mesh, object_transform(scaled_and_moved(), Double4x4(1)), attribute, vertex);
}

} // namespace

TEST_CASE("a corner's value is turned into the world as its attribute is declared") {
  CHECK(corner(Transformed::as_is) == std::array{1.0, 1.0, 1.0});
  CHECK(corner(Transformed::as_position) == std::array{12.0, 23.0, 34.0});
  // Cofactors of the scale: 3 * 4, 2 * 4, 2 * 3, up to a power of two.
  const std::array<double, 3> normal = corner(Transformed::as_normal);
  CHECK(normal[1] == normal[0] * 8 / 12);
  CHECK(normal[2] == normal[0] / 2);
  CHECK(normal[0] > 0);
}

TEST_CASE("a tangent is made unit in the world, and its frame's handedness is the other one where the model mirrors") {
  Mesh mesh;
  mesh.tangents = {Float4(0, -2, 0, 1), Float4(0, 0, 0, -1)};
  for (const double mirrored : {1.0, -1.0}) {
    Object object;
    object.scale = {mirrored, 3, 4};
    const ObjectTransform transform = object_transform(object, Double4x4(1));
    const auto tangent = [&](std::uint32_t vertex) {
      return corner_value(mesh, transform, declared(&Mesh::tangents), vertex);
    };
    CHECK(tangent(0) == std::array{0.0, -1.0, 0.0, mirrored});
    CHECK(tangent(1) == std::array{0.0, 0.0, 0.0, -mirrored}); // 0 stays 0
    CHECK(tangent(2) == std::array{0.0, 0.0, 0.0, 0.0});
  }
}

TEST_CASE("a vertex that has none of an attribute brings what stands for it") {
  CHECK(corner(Transformed::as_is, 1) == std::array{0.5, 0.5, 0.5});
}

TEST_CASE("each component of each attribute has a row of its own") {
  int next = 0;
  for_each_attribute_row([&](const auto& attribute, int row) {
    CHECK(row == next);
    CHECK(first_row(attribute.values) == row);
    next += attribute.components;
  });
  CHECK(next == attribute_rows);
}

} // namespace refraster
