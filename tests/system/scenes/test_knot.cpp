#include <refraster/mesh.h>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace refraster {
namespace {

/// The curve of the header, with the C library's sine.
Double3 knot_centre(double u) {
  const double t = 2 * std::numbers::pi * u;
  const double distance = 1 + 0.4 * std::cos(3 * t);
  return {-distance * std::sin(2 * t), -0.4 * std::sin(3 * t), -distance * std::cos(2 * t)};
}

constexpr int segments = 60, rings = 12;
constexpr double tube_radius = 0.25;

} // namespace

TEST_CASE("a knot's vertices lie around its curve at the tube's radius, and their normals point away from it") {
  const Mesh mesh = knot_mesh(segments, rings, tube_radius);
  CHECK(mesh.triangles.size() == 2 * segments * rings);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Double3 away = Double3(mesh.positions[i]) - knot_centre(static_cast<double>(mesh.uvs[i].x));
    const Double3 normal(mesh.normals[i]);
    // u, position and normal are rounded to float: 2^-24 of at most 2, and u moves the centre at most 2 pi 3.1 as fast.
    const double error = 2 * 0x1p-24 * 20 + 4 * 0x1p-24;
    CHECK(std::abs(length(away) - tube_radius) <= error);
    CHECK(length(away - normal * tube_radius) <= error);
  }
}

TEST_CASE("a knot is closed, and its triangles face outward") {
  const Mesh mesh = knot_mesh(segments, rings, tube_radius);
  const auto place = [&](std::uint32_t vertex) {
    const Float3& p = mesh.positions[vertex];
    return std::array{p.x, p.y, p.z};
  };
  std::set<std::pair<std::array<float, 3>, std::array<float, 3>>> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) CHECK(edges.emplace(place(t[k]), place(t[(k + 1) % 3])).second);
    const Double3 a(mesh.positions[t[0]]), b(mesh.positions[t[1]]), c(mesh.positions[t[2]]);
    CHECK(dot(cross(b - a, c - a), Double3(mesh.normals[t[0]])) > 0);
  }
  for (const auto& [from, to] : edges) CHECK(edges.count({to, from}) == 1);
}

} // namespace refraster
