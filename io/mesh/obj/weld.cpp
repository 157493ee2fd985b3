#include "io/mesh/obj/weld.h"

#include "io/mesh/obj/first_numbers.h"
#include "io/mesh/obj_faces.h"
#include "io/parallel/pages.h"
#include "io/parallel/pieces.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <mutex>

namespace refraster {
namespace {

/// Finds of each corner the first one with the same (v, vt, vn), among those whose v lies in a range: of other ranges
/// other threads do. The different ones of one v form a chain: neighbours in the file are so neighbours in memory,
/// where a hash would scatter them. What is beyond a chain's greatest length goes into a hash table, so that no file
/// takes more than steps in proportion to its size.
class FirstCorners {
public:
  FirstCorners(const RawVector<ObjCorner>& corners, std::int32_t first_v, std::int32_t last_v)
      : corners_(corners), first_v_(first_v), chains_(static_cast<std::size_t>(last_v - first_v), -1) {
    links_.reserve(chains_.size() + chains_.size() / 16); // more only where a v has several vertices
  }

  void find(std::int32_t* firsts) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const auto place = static_cast<std::uint32_t>(corners_[i].v) - static_cast<std::uint32_t>(first_v_);
      if (place < chains_.size()) firsts[i] = first_of(static_cast<std::int32_t>(i), chains_[place]);
    }
  }

private:
  static constexpr int max_chain = 32;
  struct Link {
    std::int32_t corner, vt, vn, before; // before: the one of its v before it; -1: none
  };

  std::int32_t first_of(std::int32_t i, std::int32_t& chain) {
    const ObjCorner& corner = corners_[static_cast<std::size_t>(i)];
    int length = 0;
    for (std::int32_t at = chain; at >= 0; ++length) {
      const Link& link = links_[static_cast<std::size_t>(at)];
      if (link.vt == corner.vt && link.vn == corner.vn) return link.corner;
      at = link.before;
    }
    if (length == max_chain) return other(i, corner);
    links_.push_back({i, corner.vt, corner.vn, chain});
    chain = static_cast<std::int32_t>(links_.size()) - 1;
    return i;
  }

  std::int32_t other(std::int32_t i, const ObjCorner& corner) {
    if (!others_) others_ = std::make_unique<TripleIndex>(corners_.size());
    const auto number = static_cast<std::size_t>((*others_)({corner.v, corner.vt, corner.vn}));
    if (number == first_others_.size()) first_others_.push_back(i);
    return first_others_[number];
  }

  const RawVector<ObjCorner>& corners_;
  std::int32_t first_v_;
  RawVector<std::int32_t> chains_; // of each v, its last link; -1: none so far
  RawVector<Link> links_;
  std::unique_ptr<TripleIndex> others_;
  std::vector<std::int32_t> first_others_; // of others_
};

/// Of each corner, the number of its vertex, and these, both in the order in which they appear. Meanwhile `triangles`
/// become as many as there will be: to clear memory takes as long.
void number_vertices(const ObjText& obj, int threads, WeldedFaces& welded, RawVector<std::int32_t>& numbers) {
  const RawVector<ObjCorner>& corners = obj.faces.corners;
  const std::size_t points = obj.v.size();
  const std::size_t pieces = std::clamp<std::size_t>(points / 1024, 1, static_cast<std::size_t>(threads));
  RawVector<std::int32_t> firsts(corners.size());
  numbers.resize(corners.size());
  for_pieces(threads, pieces + 1, [&](std::size_t piece, int) {
    if (piece == pieces) return resize_in_pages(welded.triangles, corners.size() - 2 * obj.faces.count());
    const auto border = [&](std::size_t i) { return static_cast<std::int32_t>(points * i / pieces); };
    FirstCorners(corners, border(piece), border(piece + 1)).find(firsts.data());
  });
  // There are no more vertices than corners; pages that are not needed are not touched.
  welded.vertices.resize(corners.size());
  welded.vertices.resize(number_firsts(
      threads, corners.size(), [&](std::size_t i) { return firsts[i]; }, numbers.data(),
      [&](std::size_t i, std::uint32_t number) {
        welded.vertices[number] = {corners[i].v, corners[i].vt, corners[i].vn};
      }));
}

InputError too_intricate(const std::string& path, std::size_t face, std::size_t corners) {
  return InputError(InputFault{path, 0, 0, "face " + std::to_string(face + 1),
                               "a polygon of " + std::to_string(corners) + " corners that takes too long to cut",
                               "simpler polygons, or triangles"});
}

/// Of faces that are not all triangles. `names`: of each corner, its vertex.
void cut(const std::string& path, const ObjText& obj, const RawVector<std::int32_t>& names, int threads,
         std::uint64_t& steps_left, std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const ObjFaces& faces = obj.faces;
  constexpr std::size_t block = 4096; // faces that a thread takes at a time
  std::vector<std::size_t> others;    // that are no fans: they share steps_left, one after the other
  std::mutex of_others;
  const auto name = [&](std::size_t corner) { return static_cast<std::uint32_t>(names[corner]); };
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
        triangles[first - 2 * f + i] = {name(first), name(first + i + 1), name(first + i + 2)};
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
      triangles[first - 2 * f + i] = {name(first + parts[i][0]), name(first + parts[i][1]), name(first + parts[i][2])};
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
  WeldedFaces welded;
  RawVector<std::int32_t> numbers;
  number_vertices(obj, threads, welded, numbers);
  // Each face has 3 corners at least, so that this is so where all have 3.
  if (numbers.size() == 3 * obj.faces.count()) {
    static_assert(sizeof welded.triangles[0] == 3 * sizeof numbers[0]);
    constexpr std::size_t block = 1 << 15; // triangles that a thread takes at a time
    const std::size_t count = welded.triangles.size();
    for_pieces(threads, (count + block - 1) / block, [&](std::size_t b, int) {
      const std::size_t first = b * block, size = std::min(block, count - first);
      std::memcpy(welded.triangles.data() + first, numbers.data() + 3 * first, size * sizeof welded.triangles[0]);
    });
  } else {
    cut(path, obj, numbers, threads, steps_left, welded.triangles);
  }
  put_textured_first(welded);
  return welded;
}

} // namespace refraster
