// Tangents of meshes, against MikkTSpace's definition worked out corner by corner: no welding, no sorting, no groups.

#include <refraster/mesh.h>
#include <refraster/render.h>

#include "tests/support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace refraster::test {
namespace {

using Real = long double;
using V = std::array<Real, 3>;

V operator-(const V& a, const V& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
V operator+(const V& a, const V& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
V operator*(const V& a, Real s) {
  return {a[0] * s, a[1] * s, a[2] * s};
}
Real dot(const V& a, const V& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
V unit(const V& a) {
  const Real size = std::sqrt(dot(a, a));
  return size > 0 ? a * (1 / size) : V{};
}
V vec(const Float3& v) {
  return {Real(v.x), Real(v.y), Real(v.z)};
}

/// What a corner is known by: position, normal and texture coordinates.
struct Vertex {
  V position, normal;
  std::array<Real, 2> uv;
  bool operator==(const Vertex&) const = default;
};

struct Triangle {
  std::array<Vertex, 3> at;
  V along_u{};     // unit
  int winding = 0; // of uv: 1, or -1 where it is mirrored; 0: nothing says where u grows
};

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& indices : mesh.triangles) {
    Triangle t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = indices[k];
      t.at[k] = {vec(mesh.positions[v]), unit(vec(mesh.normals[v])), {Real(mesh.uvs[v].x), Real(mesh.uvs[v].y)}};
    }
    // P = P0 + u Pu + v Pv at the other two corners, solved for Pu by Cramer's rule.
    const V e1 = t.at[1].position - t.at[0].position, e2 = t.at[2].position - t.at[0].position;
    const auto uv = [&](std::size_t k, std::size_t c) { return t.at[k].uv[c] - t.at[0].uv[c]; };
    const Real determinant = uv(1, 0) * uv(2, 1) - uv(1, 1) * uv(2, 0);
    if (determinant != 0) {
      t.along_u = unit((e1 * uv(2, 1) - e2 * uv(1, 1)) * (1 / determinant));
      t.winding = determinant > 0 ? 1 : -1;
    }
    triangles.push_back(t);
  }
  return triangles;
}

/// Whether the two have an edge at this vertex in common, which they run along in opposite directions.
bool joined(const Triangle& a, std::size_t i, const Triangle& b, std::size_t j) {
  return a.at[(i + 1) % 3] == b.at[(j + 2) % 3] || a.at[(i + 2) % 3] == b.at[(j + 1) % 3];
}

/// Of triangles that all have a winding: the mean over those around the corner's vertex that are reached over edges
/// from triangle to triangle of the same winding.
std::pair<V, int> tangent_at(const std::vector<Triangle>& all, std::size_t number, std::size_t corner) {
  const Triangle& from = all[number];
  std::vector<std::pair<std::size_t, std::size_t>> reached{{number, corner}};
  for (std::size_t next = 0; next < reached.size(); ++next)
    for (std::size_t t = 0; t < all.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k) {
        if (!(all[t].at[k] == from.at[corner]) || all[t].winding != from.winding) continue;
        const auto [here, i] = reached[next];
        const std::pair candidate(t, k);
        if (joined(all[here], i, all[t], k) && std::find(reached.begin(), reached.end(), candidate) == reached.end())
          reached.push_back(candidate);
      }
  const V n = from.at[corner].normal;
  const auto flat = [&](const V& v) { return unit(v - n * dot(n, v)); };
  V sum{};
  for (const auto& [t, k] : reached) {
    const V p = all[t].at[k].position;
    const V a = flat(all[t].at[(k + 1) % 3].position - p), b = flat(all[t].at[(k + 2) % 3].position - p);
    sum = sum + flat(all[t].along_u) * std::acos(std::clamp(dot(a, b), Real(-1), Real(1)));
  }
  return {unit(sum), from.winding};
}

/// A float is off by half a unit in its last place, 2^-25 below 1; where angles are near 0 or pi an arc cosine loses
/// half of its digits, 2^-32, which weigh the same.
constexpr Real tolerance = 0x1p-24L;

void check(const Mesh& mesh) {
  const std::vector<Triangle> all = triangles_of(mesh);
  Mesh with = mesh;
  add_tangents(with);
  REQUIRE(with.triangles.size() == mesh.triangles.size());
  REQUIRE(with.tangents.size() == with.uvs.size());
  for (std::size_t t = 0; t < all.size(); ++t) {
    REQUIRE(all[t].winding != 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = with.triangles[t][k];
      const auto [expected, winding] = tangent_at(all, t, k);
      const V off = vec(Float3(with.tangents[v])) - expected;
      CHECK(std::sqrt(dot(off, off)) <= tolerance * 2);
      CHECK(with.tangents[v].w == static_cast<float>(winding));
    }
  }
}

/// What each corner of each triangle has, but for the tangent.
std::vector<std::array<float, 11>> corners(const Mesh& mesh) {
  std::vector<std::array<float, 11>> result;
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t v : triangle) {
      const Float3 p = mesh.positions[v], n = mesh.normals[v];
      const Float2 uv = v < mesh.uvs.size() ? mesh.uvs[v] : Float2(-1);
      const Float3 c = v < mesh.colours.size() ? mesh.colours[v] : Float3(1);
      result.push_back({p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y, c.x, c.y, c.z});
    }
  return result;
}

/// A wavy sheet, whose uv runs forth and back and whose normals have any length.
Mesh sheet(Random& random) {
  Mesh mesh = plane_mesh(3 + random.below(4));
  const int turns = 1 + random.below(3);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const auto jitter = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
    mesh.positions[v] += Float3(jitter(0.1), jitter(0.4), jitter(0.1));
    mesh.normals[v] = Float3(jitter(0.5), 1 + jitter(0.5), jitter(0.5)) * (1 + jitter(0.5));
    const float u = mesh.uvs[v].x * static_cast<float>(turns);
    const float rest = u - 2 * std::floor(u / 2);
    mesh.uvs[v] = Float2(rest < 1 ? rest : 2 - rest, mesh.uvs[v].y * 0.5f + jitter(0.05));
  }
  return mesh;
}

} // namespace

TEST_CASE("tangents of shapes are MikkTSpace's, worked out corner by corner") {
  for (const Mesh& mesh : {cube_mesh(), plane_mesh(3), torus_mesh(7, 5, 0.4), knot_mesh(16, 5, 0.3)}) check(mesh);
}

TEST_CASE("so are those of sheets whose texture coordinates turn back, and whose vertices are there twice") {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    Mesh mesh = sheet(random);
    std::vector<Triangle> all = triangles_of(mesh);
    std::vector<std::array<std::uint32_t, 3>> kept; // without those whose uv has no area
    for (std::size_t t = 0; t < all.size(); ++t)
      if (all[t].winding != 0) kept.push_back(mesh.triangles[t]);
    mesh.triangles = kept;
    check(mesh);
    // What is one vertex to MikkTSpace may be several to the mesh.
    Mesh loose;
    for (const auto& triangle : mesh.triangles) {
      const auto first = static_cast<std::uint32_t>(loose.positions.size());
      for (const std::uint32_t v : triangle) {
        loose.positions.push_back(mesh.positions[v]);
        loose.normals.push_back(mesh.normals[v]);
        loose.uvs.push_back(mesh.uvs[v]);
      }
      loose.triangles.push_back({first, first + 1, first + 2});
    }
    check(loose);
  }
}

TEST_CASE("the plane's tangent is the x axis, its bitangent where v grows") {
  Mesh mesh = plane_mesh(2);
  const std::size_t vertices = mesh.positions.size();
  add_tangents(mesh);
  CHECK(mesh.positions.size() == vertices); // none is split
  // v runs along -z, and cross(y, x) is -z.
  for (const Float4& tangent : mesh.tangents) CHECK(tangent == Float4(1, 0, 0, 1));
}

TEST_CASE("where uv is mirrored a vertex is split, and everything else of it stays") {
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
  mesh.normals.assign(7, Float3(0, 0, 2));
  mesh.uvs = {{1, 0}, {0, 0}, {1, 0}, {0, 1}}; // u = |x|
  mesh.colours = {{1, 0, 0}, {0, 1, 0}};       // not of all
  mesh.triangles = {{0, 1, 3}, {4, 5, 6}, {1, 2, 3}};
  const auto before = corners(mesh);
  add_tangents(mesh);
  CHECK(corners(mesh) == before);
  CHECK(mesh.positions.size() == 9); // 1 and 3 are there twice
  CHECK(mesh.normals.size() == 9);
  REQUIRE(mesh.uvs.size() == 6);
  REQUIRE(mesh.tangents.size() == 6);
  for (const std::uint32_t v : mesh.triangles[0]) CHECK(mesh.tangents[v] == Float4(-1, 0, 0, -1));
  for (const std::uint32_t v : mesh.triangles[2]) CHECK(mesh.tangents[v] == Float4(1, 0, 0, 1));
  for (const std::uint32_t v : mesh.triangles[1]) CHECK(v >= mesh.uvs.size());
}

TEST_CASE("a triangle whose uv has no area takes the tangents of its neighbours, or MikkTSpace's own") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.normals.assign(4, Float3(0, 0, 1));
  mesh.uvs = {{0, 0}, {0, 1}, {1, 0}, {-1, 2}}; // of the second triangle all on a line
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
  add_tangents(mesh);
  // u grows with y, v with x: mirrored.
  for (const std::uint32_t v : {0u, 1u, 2u}) CHECK(mesh.tangents[v] == Float4(0, 1, 0, -1));
  CHECK(mesh.triangles[1] == std::array{2u, 1u, 3u});
  CHECK(mesh.tangents[3] == Float4(1, 0, 0, -1)); // no other triangle is at this corner
  mesh.triangles = {{2, 1, 3}};
  add_tangents(mesh);
  for (const std::uint32_t v : {1u, 2u, 3u}) CHECK(mesh.tangents[v] == Float4(1, 0, 0, -1));
}

TEST_CASE("a triangle with two corners at one place takes the tangents of others at its vertices") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  mesh.normals.assign(4, Float3(0, 0, 1));
  mesh.uvs = {{0, 0}, {0, 1}, {1, 0}, {3, 3}};
  mesh.triangles = {{1, 2, 3}, {0, 1, 2}};
  add_tangents(mesh);
  for (const std::uint32_t v : {0u, 1u, 2u}) CHECK(mesh.tangents[v] == Float4(0, 1, 0, -1));
  CHECK(mesh.tangents[3] == Float4(1, 0, 0, -1));
}

TEST_CASE("a mesh without texture coordinates has no tangents; of any others they are finite") {
  Mesh bare = cube_mesh();
  bare.uvs.clear();
  add_tangents(bare);
  CHECK(bare.tangents.empty());
  Random random(8);
  for (int i = 0; i < 200; ++i) {
    Mesh mesh;
    for (int v = 0; v < 12; ++v) {
      const auto any = [&] {
        return random.below(3) == 0 ? random.hard<float>() : static_cast<float>(random.below(3));
      };
      mesh.positions.emplace_back(any(), any(), any());
      mesh.normals.emplace_back(any(), any(), any());
      mesh.uvs.emplace_back(any(), any());
    }
    for (int t = 0; t < 12; ++t) {
      const auto vertex = [&] { return static_cast<std::uint32_t>(random.below(12)); };
      const std::uint32_t a = vertex(), b = vertex(), c = vertex();
      mesh.triangles.push_back({a, b, c});
    }
    const auto before = corners(mesh);
    add_tangents(mesh);
    CHECK(corners(mesh) == before);
    for (const Float4& t : mesh.tangents) CHECK(std::isfinite(t.x + t.y + t.z + t.w));
  }
}

TEST_CASE("tangents without a map change no bit of a picture") {
  Scene scene;
  scene.camera.position = {0.3, 1, 4}, scene.camera.target = {0, 0, 0};
  scene.point_lights = {{{1, 2, 3}, {1, 1, 1}, 1, 0, 0}};
  Random random(5);
  Mesh mesh = sheet(random);
  mesh.colours = {{1, 0.5f, 0}, {0, 1, 0}};
  Object object;
  object.name = "sheet";
  auto texture = std::make_shared<Texture>();
  texture->levels.push_back({2, 2, {255, 0, 9, 80, 90, 3, 40, 20, 250, 7, 180, 99}});
  object.material.diffuse_map.texture = texture;
  object.mesh = std::make_shared<const Mesh>(mesh);
  scene.objects = {object};
  RenderOptions options;
  options.width = 60, options.height = 40, options.want_radiance_double = true;
  const Frame without = render(scene, options);
  add_tangents(mesh);
  scene.objects[0].mesh = std::make_shared<const Mesh>(mesh);
  CHECK(render(scene, options).radiance_double.values == without.radiance_double.values);
}

} // namespace refraster::test
