#include "io/mesh/obj/weld.h"

#include "io/file/pieces.h"
#include "io/mesh/obj_faces.h"
#include "math/large_memory.h"

#include <algorithm>
#include <memory>
#include <mutex>

namespace refraster {
namespace {

/// Numbers different (v, vt, vn) in the order in which they appear. The vertices of one v form a chain: neighbours in
/// the file are so neighbours in memory, where a hash would scatter them. What is beyond a chain's greatest length goes
/// into a hash table, so that no file takes more than steps in proportion to its size.
class VertexIndex {
public:
  VertexIndex(std::size_t points, std::size_t corners) : first_(points, -1), corners_(corners) {
    next_.reserve(corners / 4), vertices_.reserve(corners / 4); // more only where most faces share none
  }

  std::uint32_t operator()(const ObjCorner& corner) {
    std::int32_t& first = first_[static_cast<std::size_t>(corner.v)];
    int length = 0;
    for (std::int32_t i = first; i >= 0; i = next_[static_cast<std::size_t>(i)], ++length) {
      const TripleIndex::Triple& vertex = vertices_[static_cast<std::size_t>(i)];
      if (vertex[1] == corner.vt && vertex[2] == corner.vn) return static_cast<std::uint32_t>(i);
    }
    const auto number = static_cast<std::int32_t>(vertices_.size());
    const TripleIndex::Triple vertex{corner.v, corner.vt, corner.vn};
    if (length == max_chain) {
      if (!others_) others_ = std::make_unique<TripleIndex>(corners_);
      const auto other = static_cast<std::size_t>((*others_)(vertex));
      if (other < numbers_.size()) return numbers_[other];
      numbers_.push_back(static_cast<std::uint32_t>(number));
      next_.push_back(-1); // of no chain
    } else {
      next_.push_back(first);
      first = number;
    }
    vertices_.push_back(vertex);
    return static_cast<std::uint32_t>(number);
  }

  RawVector<TripleIndex::Triple> take_vertices() { return std::move(vertices_); }

private:
  static constexpr int max_chain = 32;
  RawVector<std::int32_t> first_; // of each v, its last vertex; -1: none so far
  RawVector<std::int32_t> next_;  // of each vertex, the one of its v before it
  RawVector<TripleIndex::Triple> vertices_;
  std::size_t corners_;
  std::unique_ptr<TripleIndex> others_;
  std::vector<std::uint32_t> numbers_; // of others_
};

InputError too_intricate(const std::string& path, std::size_t face, std::size_t corners) {
  return InputError(InputFault{path, 0, 0, "face " + std::to_string(face + 1),
                               "a polygon of " + std::to_string(corners) + " corners that takes too long to cut",
                               "simpler polygons, or triangles"});
}

/// Of faces that are not all triangles. `names`: of each corner, its vertex.
void cut(const std::string& path, const ObjText& obj, const RawVector<std::uint32_t>& names, int threads,
         std::uint64_t& steps_left, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const ObjFaces& faces = obj.faces;
  constexpr std::size_t block = 4096; // faces that a thread takes at a time
  std::vector<std::size_t> others;    // that are no fans: they share steps_left, one after the other
  std::mutex of_others;
  const auto polygon_of = [&](std::size_t f, std::vector<Float3>& polygon) {
    polygon.clear();
    for (const ObjCorner& corner : faces.face(f)) polygon.push_back(obj.v[static_cast<std::size_t>(corner.v)]);
  };
  for_pieces(threads, (faces.count() + block - 1) / block, [&](std::size_t b, int) {
    std::vector<Float3> polygon;
    std::vector<std::size_t> others_here;
    for (std::size_t f = b * block; f < std::min((b + 1) * block, faces.count()); ++f) {
      const std::uint32_t first = faces.begin[f], size = faces.begin[f + 1] - first;
      if (size > 3) {
        polygon_of(f, polygon);
        if (!is_fan(polygon)) {
          others_here.push_back(f);
          continue;
        }
      }
      for (std::uint32_t i = 0; i < size - 2; ++i)
        triangles[first - 2 * f + i] = {names[first], names[first + i + 1], names[first + i + 2]};
    }
    const std::lock_guard lock(of_others);
    others.insert(others.end(), others_here.begin(), others_here.end());
  });
  std::sort(others.begin(), others.end());
  std::vector<Float3> polygon;
  for (const std::size_t f : others) {
    polygon_of(f, polygon);
    const auto parts = triangulate(polygon, steps_left);
    if (parts.empty()) throw too_intricate(path, f, polygon.size());
    const std::uint32_t first = faces.begin[f];
    for (std::size_t i = 0; i < parts.size(); ++i)
      triangles[first - 2 * f + i] = {names[first + parts[i][0]], names[first + parts[i][1]],
                                      names[first + parts[i][2]]};
  }
}

/// Numbers those vertices first that have a vt.
void put_textured_first(WeldedFaces& welded) {
  RawVector<TripleIndex::Triple>& vertices = welded.vertices;
  const auto has_vt = [](const TripleIndex::Triple& vertex) { return vertex[1] >= 0; };
  if (std::is_partitioned(vertices.begin(), vertices.end(), has_vt)) return; // nearly always
  std::vector<std::uint32_t> place(vertices.size());
  std::uint32_t textured = 0;
  auto plain = static_cast<std::uint32_t>(std::count_if(vertices.begin(), vertices.end(), has_vt));
  for (std::size_t i = 0; i < vertices.size(); ++i) place[i] = has_vt(vertices[i]) ? textured++ : plain++;
  std::stable_partition(vertices.begin(), vertices.end(), has_vt);
  for (auto& triangle : welded.triangles)
    for (std::uint32_t& vertex : triangle) vertex = place[vertex];
}

} // namespace

WeldedFaces weld(const std::string& path, const ObjText& obj, int threads, std::uint64_t& steps_left) {
  const RawVector<ObjCorner>& corners = obj.faces.corners;
  WeldedFaces welded;
  VertexIndex index(obj.v.size(), corners.size());
  resize_in_large_pages(welded.triangles, corners.size() - 2 * obj.faces.count());
  // Each face has 3 corners at least, so that this is so where all have 3.
  if (corners.size() == 3 * obj.faces.count()) {
    for (std::size_t i = 0; i < welded.triangles.size(); ++i)
      welded.triangles[i] = {index(corners[3 * i]), index(corners[3 * i + 1]), index(corners[3 * i + 2])};
  } else {
    RawVector<std::uint32_t> names(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) names[i] = index(corners[i]);
    cut(path, obj, names, threads, steps_left, welded.triangles);
  }
  welded.vertices = index.take_vertices();
  put_textured_first(welded);
  return welded;
}

} // namespace refraster
