// Tangents as MikkTSpace defines them; docs/tangents.md derives it and says which part of its source is which here.

#include <refraster/mesh.h>

#include "math/elementary.h"
#include "math/vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace refraster {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// What MikkTSpace takes for 0: lengths and areas that no normal float holds.
bool is_zero(double x) {
  return !(std::abs(x) > static_cast<double>(std::numeric_limits<float>::min()));
}

/// Of a corner that no triangle gives a direction to: MikkTSpace's own.
const Float4 undirected(1, 0, 0, -1);

/// v in the plane across n, unit; 0 if nothing of it is left.
Double3 across(const Double3& n, const Double3& v) {
  return normalize(v - n * dot(n, v));
}

/// The angle between two vectors, in [0, pi].
double angle_between(const Double3& a, const Double3& b) {
  return atan2(length(cross(a, b)), dot(a, b));
}

/// A triangle that has texture coordinates, and whose corners are at three places.
struct Face {
  std::uint32_t triangle = 0;                            // of the mesh
  std::array<std::uint32_t, 3> corner{};                 // welded vertices
  Double3 along_u{0};                                    // where u grows in it, unit
  bool preserves = false;                                // uv runs round it as its corners do
  bool any = false;                                      // nothing says where u and v grow: it goes with any group
  std::array<std::uint32_t, 3> beyond{none, none, none}; // the face beyond edge k, from corner k to the next
  std::array<std::uint32_t, 3> group{none, none, none};  // of each corner
};

/// Corners of faces around a vertex that are reached from one another over edges, and whose uv runs the same way round.
struct Group {
  std::uint32_t vertex = 0;
  bool preserves = false;
  std::vector<std::uint32_t> faces;
};

class Tangents {
public:
  explicit Tangents(const Mesh& mesh) : mesh_(mesh) {
    weld();
    list_faces();
    join_faces();
    make_groups();
  }

  /// Of each corner of each triangle; 0 of triangles without texture coordinates.
  std::vector<std::array<Float4, 3>> corners() const {
    std::vector<std::array<Float4, 3>> result(mesh_.triangles.size(), {Float4(0), Float4(0), Float4(0)});
    std::vector<Float4> of_group;
    for (const Group& group : groups_) of_group.push_back(tangent_of(group));
    std::vector<Float4> of_vertex(mesh_.positions.size(), undirected); // the first face's that has it
    std::vector<bool> seen(mesh_.positions.size());
    for (const Face& face : faces_)
      for (std::size_t k = 0; k < 3; ++k) {
        const Float4 tangent = face.group[k] == none ? undirected : of_group[face.group[k]];
        result[face.triangle][k] = tangent;
        if (!seen[face.corner[k]]) of_vertex[face.corner[k]] = tangent, seen[face.corner[k]] = true;
      }
    for (const std::uint32_t triangle : degenerate_)
      for (std::size_t k = 0; k < 3; ++k) result[triangle][k] = of_vertex[welded_[mesh_.triangles[triangle][k]]];
    return result;
  }

private:
  Double3 position(std::uint32_t vertex) const { return Double3(mesh_.positions[vertex]); }
  Double3 normal(std::uint32_t vertex) const { return normalize(Double3(mesh_.normals[vertex])); }

  /// Vertices with the same position, normal and texture coordinates are one: the first.
  void weld() {
    const std::size_t count = mesh_.uvs.size();
    const auto values = [&](std::uint32_t v) {
      const Float3 &p = mesh_.positions[v], &n = mesh_.normals[v];
      return std::array{p.x, p.y, p.z, n.x, n.y, n.z, mesh_.uvs[v].x, mesh_.uvs[v].y};
    };
    const auto is_ordered = [](const auto& a) {
      return std::none_of(a.begin(), a.end(), [](float x) { return std::isnan(x); });
    };
    std::vector<std::uint32_t> order;
    welded_.resize(mesh_.positions.size());
    std::iota(welded_.begin(), welded_.end(), 0u);
    for (std::uint32_t v = 0; v < count; ++v)
      if (is_ordered(values(v))) order.push_back(v);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      const auto of_a = values(a), of_b = values(b);
      return of_a != of_b ? of_a < of_b : a < b;
    });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (values(order[i]) == values(order[i - 1])) welded_[order[i]] = welded_[order[i - 1]];
  }

  void list_faces() {
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& vertex = mesh_.triangles[i];
      if (!has_uvs(mesh_, vertex)) continue;
      const Double3 p0 = position(vertex[0]), p1 = position(vertex[1]), p2 = position(vertex[2]);
      if (p0 == p1 || p1 == p2 || p2 == p0) {
        degenerate_.push_back(i);
        continue;
      }
      const auto uv = [&](std::size_t k) { return Double2(mesh_.uvs[vertex[k]]); };
      const Double2 uv1 = uv(1) - uv(0), uv2 = uv(2) - uv(0);
      const Double3 d1 = p1 - p0, d2 = p2 - p0;
      Face face;
      face.triangle = i;
      for (std::size_t k = 0; k < 3; ++k) face.corner[k] = welded_[vertex[k]];
      // With p = p0 + u P_u + v P_v these are P_u and P_v, times the area of the triangle that uv makes, twice.
      const double area = uv1.x * uv2.y - uv1.y * uv2.x;
      const Double3 along_u = d1 * uv2.y - d2 * uv1.y, along_v = d2 * uv1.x - d1 * uv2.x;
      face.preserves = area > 0;
      const double size = std::abs(area);
      face.any = is_zero(area) || is_zero(length(along_u) / size) || is_zero(length(along_v) / size);
      if (!is_zero(area)) face.along_u = normalize(along_u) * (face.preserves ? 1.0 : -1.0);
      faces_.push_back(face);
    }
  }

  /// Two faces are neighbours where one has an edge from a to b and the other from b to a: of several the first, each
  /// edge once.
  void join_faces() {
    struct Edge {
      std::uint32_t low = 0, high = 0, face = 0, k = 0;
      auto operator<=>(const Edge&) const = default;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * faces_.size());
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(faces_[f].corner[k], faces_[f].corner[(k + 1) % 3]);
        edges.push_back({low, high, f, k});
      }
    std::sort(edges.begin(), edges.end());
    const auto beyond = [&](const Edge& edge) -> std::uint32_t& { return faces_[edge.face].beyond[edge.k]; };
    const auto begins = [&](const Edge& edge) { return faces_[edge.face].corner[edge.k]; };
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (beyond(edges[i]) != none) continue;
      for (std::size_t j = i + 1; j < edges.size() && edges[j].low == edges[i].low && edges[j].high == edges[i].high;
           ++j) {
        if (beyond(edges[j]) != none || begins(edges[j]) == begins(edges[i])) continue;
        beyond(edges[i]) = edges[j].face, beyond(edges[j]) = edges[i].face;
        break;
      }
    }
  }

  static std::size_t place_of(const Face& face, std::uint32_t vertex) {
    return face.corner[0] == vertex ? 0 : face.corner[1] == vertex ? 1 : 2;
  }

  void make_groups() {
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        if (!faces_[f].any && faces_[f].group[k] == none) {
          groups_.push_back({faces_[f].corner[k], faces_[f].preserves, {}});
          spread(f);
        }
    for (Group& group : groups_) std::sort(group.faces.begin(), group.faces.end());
  }

  /// From a face to all that belong to the last group: over the two edges at its vertex, the left one first, and all
  /// that is reached by it before the right one.
  void spread(std::uint32_t first) {
    const auto number = static_cast<std::uint32_t>(groups_.size() - 1);
    Group& group = groups_.back();
    std::vector<std::uint32_t> reached{first};
    while (!reached.empty()) {
      const std::uint32_t f = reached.back();
      reached.pop_back();
      Face& face = faces_[f];
      const std::size_t k = place_of(face, group.vertex);
      if (face.group[k] != none) continue;
      // The first that a face without a direction is grouped with gives it its own.
      if (face.any && face.group == std::array{none, none, none}) face.preserves = group.preserves;
      if (face.preserves != group.preserves) continue;
      face.group[k] = number;
      group.faces.push_back(f);
      for (const std::size_t edge : {(k + 2) % 3, k}) // what is put last is taken first
        if (face.beyond[edge] != none) reached.push_back(face.beyond[edge]);
    }
  }

  /// The mean of the faces' directions across the normal, by the angles that they have at the vertex, in that plane.
  Float4 tangent_of(const Group& group) const {
    const Double3 n = normal(group.vertex);
    Double3 sum(0);
    for (const std::uint32_t f : group.faces) {
      const Face& face = faces_[f];
      if (face.any) continue;
      const std::size_t k = place_of(face, group.vertex);
      const Double3 here = position(face.corner[k]);
      const Double3 to_last = across(n, position(face.corner[(k + 2) % 3]) - here);
      const Double3 to_next = across(n, position(face.corner[(k + 1) % 3]) - here);
      sum += across(n, face.along_u) * angle_between(to_last, to_next);
    }
    const Float4 tangent(Float3(normalize(sum)), group.preserves ? 1.0f : -1.0f);
    return std::isfinite(tangent.x + tangent.y + tangent.z) ? tangent : undirected;
  }

  const Mesh& mesh_;
  std::vector<std::uint32_t> welded_; // of each vertex
  std::vector<Face> faces_;
  std::vector<std::uint32_t> degenerate_; // triangles
  std::vector<Group> groups_;
};

} // namespace

void add_tangents(Mesh& mesh) {
  mesh.tangents.clear();
  if (mesh.uvs.empty()) return;
  const std::vector<std::array<Float4, 3>> corners = Tangents(mesh).corners();

  // Vertices with texture coordinates, which come first, have the tangent of their first corner; for another one more
  // vertex, behind them, is what they are but for it.
  const auto count = static_cast<std::uint32_t>(mesh.positions.size()),
             textured = static_cast<std::uint32_t>(mesh.uvs.size());
  std::vector<std::uint32_t> more; // what each is another of
  std::map<std::pair<std::uint32_t, std::array<float, 4>>, std::uint32_t> numbers;
  std::vector<bool> given(textured);
  mesh.tangents.assign(textured, Float4(0));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!has_uvs(mesh, mesh.triangles[i])) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& vertex = mesh.triangles[i][k];
      const Float4& tangent = corners[i][k];
      if (!given[vertex]) mesh.tangents[vertex] = tangent, given[vertex] = true;
      if (mesh.tangents[vertex] == tangent) continue;
      const auto [entry, is_new] = numbers.try_emplace({vertex, {tangent.x, tangent.y, tangent.z, tangent.w}},
                                                       count + static_cast<std::uint32_t>(more.size()));
      if (is_new) more.push_back(vertex), mesh.tangents.push_back(tangent);
      vertex = entry->second; // for now behind all vertices
    }
  }
  if (more.empty()) return;
  const auto added = static_cast<std::uint32_t>(more.size());
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& vertex : triangle)
      if (vertex >= count) vertex -= count - textured;
      else if (vertex >= textured) vertex += added;
  for_each_vertex_attribute([&]<class Value>(const VertexAttribute<Value>& attribute) {
    std::vector<Value>& values = mesh.*attribute.values;
    if constexpr (std::is_same_v<Value, Float4>)
      if (attribute.values == &Mesh::tangents) return;
    if (values.empty()) return;
    std::vector<Value> split;
    const auto value = [&](std::uint32_t v) { return v < values.size() ? values[v] : Value(attribute.otherwise); };
    for (const std::uint32_t vertex : more) split.push_back(value(vertex));
    if (values.size() < textured) values.resize(textured, Value(attribute.otherwise));
    values.insert(values.begin() + textured, split.begin(), split.end());
  });
}

} // namespace refraster
