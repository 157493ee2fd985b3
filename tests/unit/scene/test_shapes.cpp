// Meshes that need no file.

#include <refraster/mesh.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

using namespace refraster;

namespace {

struct Named {
  std::string name;
  Mesh mesh;
};

std::vector<Named> shapes() {
  std::vector<Named> list;
  list.push_back({"sphere", sphere_mesh(64, 32)});
  list.push_back({"smallest sphere", sphere_mesh(3, 2)});
  list.push_back({"cube", cube_mesh()});
  list.push_back({"plane", plane_mesh(5)});
  list.push_back({"torus", torus_mesh(48, 24, 0.25)});
  list.push_back({"smallest torus", torus_mesh(3, 3, 0.25)});
  return list;
}

using Place = std::tuple<float, float, float>;

Place place(const Mesh& mesh, std::uint32_t vertex) {
  const Float3 p = mesh.positions[vertex];
  return {p.x, p.y, p.z};
}

Double3 corner(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, std::size_t k) {
  return Double3(mesh.positions[triangle[k]]);
}

/// Six times the volume of the tetrahedra from the origin, summed: positive when seen from outside they turn left.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles)
    sum += dot(corner(mesh, triangle, 0), cross(corner(mesh, triangle, 1), corner(mesh, triangle, 2)));
  return sum / 6;
}

/// Directed edges by position that have no partner in the other direction.
std::size_t open_edges(const Mesh& mesh) {
  std::map<std::pair<Place, Place>, int> balance;
  for (const auto& triangle : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Place from = place(mesh, triangle[k]), to = place(mesh, triangle[(k + 1) % 3]);
      ++balance[{from, to}];
      --balance[{to, from}];
    }
  return static_cast<std::size_t>(
      std::count_if(balance.begin(), balance.end(), [](const auto& e) { return e.second > 0; }));
}

} // namespace

TEST_CASE("every triangle of a shape turns left seen from the side its normals point to") {
  for (const Named& shape : shapes())
    for (const auto& triangle : shape.mesh.triangles) {
      const Mesh& mesh = shape.mesh;
      const Double3 a = corner(mesh, triangle, 0), b = corner(mesh, triangle, 1), c = corner(mesh, triangle, 2);
      for (const std::uint32_t vertex : triangle)
        CHECK_MESSAGE(dot(cross(b - a, c - a), Double3(mesh.normals[vertex])) > 0, shape.name);
    }
}

TEST_CASE("no texture is mirrored: uv turn left where the triangle does") {
  for (const Named& shape : shapes())
    for (const auto& [i, j, k] : shape.mesh.triangles) {
      const Mesh& mesh = shape.mesh;
      const Float2 right = mesh.uvs[j] - mesh.uvs[i], up = mesh.uvs[k] - mesh.uvs[i];
      CHECK_MESSAGE(right.x * up.y > right.y * up.x, shape.name);
    }
}

TEST_CASE("sphere, cube and torus are closed, to the bit, and hold nearly the volume of the round bodies") {
  // Chords of a circle in n parts lose 1 - sin(2 pi / n) / (2 pi / n) of its area, about (2 pi / n)^2 / 6: 0.16 % for
  // 64, 0.64 % for 32 parts (twice: latitude and longitude).
  CHECK(open_edges(sphere_mesh(64, 32)) == 0);
  CHECK(open_edges(cube_mesh()) == 0);
  CHECK(open_edges(torus_mesh(48, 24, 0.25)) == 0);
  CHECK(volume(sphere_mesh(64, 32)) == doctest::Approx(4 * std::numbers::pi / 3).epsilon(0.008));
  CHECK(volume(sphere_mesh(64, 32)) < 4 * std::numbers::pi / 3);
  CHECK(volume(cube_mesh()) == 8);
  CHECK(volume(torus_mesh(64, 64, 0.25)) ==
        doctest::Approx(2 * std::numbers::pi * std::numbers::pi / 16).epsilon(0.0033));
}

TEST_CASE("normals have unit length, and uv lie in the unit square") {
  // Three coordinates, each rounded to float: the length is off by at most sqrt(3) half ulps of 1.
  const double bound = std::sqrt(3.0) * static_cast<double>(std::numeric_limits<float>::epsilon()) / 2;
  for (const Named& shape : shapes()) {
    const Mesh& mesh = shape.mesh;
    REQUIRE(mesh.normals.size() == mesh.positions.size());
    REQUIRE(mesh.uvs.size() == mesh.positions.size());
    for (const Float3& normal : mesh.normals) CHECK_MESSAGE(std::abs(length(Double3(normal)) - 1) <= bound, shape.name);
    for (const Float2& uv : mesh.uvs) CHECK_MESSAGE((0 <= uv.x && uv.x <= 1 && 0 <= uv.y && uv.y <= 1), shape.name);
  }
}

TEST_CASE("every vertex is used") {
  for (const Named& shape : shapes()) {
    const Mesh& mesh = shape.mesh;
    std::set<std::uint32_t> used;
    for (const auto& triangle : mesh.triangles) used.insert(triangle.begin(), triangle.end());
    CHECK_MESSAGE(used.size() == mesh.positions.size(), shape.name);
  }
}

TEST_CASE("a shape has as many triangles as its contract says") {
  CHECK(sphere_mesh(64, 32).triangles.size() == 2 * 64 * 31);
  CHECK(cube_mesh().triangles.size() == 12);
  CHECK(plane_mesh(5).triangles.size() == 50);
  CHECK(torus_mesh(48, 24, 0.25).triangles.size() == 2 * 48 * 24);
}

TEST_CASE("the sphere is its own mirror image in x, y and z, to the bit") {
  const Mesh mesh = sphere_mesh(16, 10);
  std::set<Place> places;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) places.insert(place(mesh, v));
  for (const auto& [x, y, z] : places) {
    CHECK(places.count({-x, y, z}) == 1);
    CHECK(places.count({x, -y, z}) == 1);
    CHECK(places.count({x, y, -z}) == 1);
  }
}

TEST_CASE("the middle of a texture faces +Z on the sphere, its seam is at -Z, and north is up") {
  const Mesh mesh = sphere_mesh(4, 4);
  int middles = 0, seams = 0;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Float2 uv = mesh.uvs[v];
    if (uv == Float2(0.5F, 0.5F)) {
      ++middles;
      CHECK(mesh.positions[v] == Float3(0, 0, 1));
    }
    if (uv.y == 0.5F && (uv.x == 0 || uv.x == 1)) {
      ++seams;
      CHECK(mesh.positions[v] == Float3(0, 0, -1));
    }
    if (uv == Float2(0.75F, 0.5F)) CHECK(mesh.positions[v] == Float3(1, 0, 0));
    if (uv.y == 1) CHECK(mesh.positions[v] == Float3(0, 1, 0));
  }
  CHECK(middles == 1);
  CHECK(seams == 2);
}
