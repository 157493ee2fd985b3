#include "io/mesh/obj_faces.h"

#include "io/mesh/triple_index.h"
#include "math/elementary/degrees.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace refraster {

SharedNormals shared_by_group(const ObjFaces& faces, std::span<const std::int32_t> smoothing) {
  const auto missing =
      std::count_if(faces.corners.begin(), faces.corners.end(), [](const ObjCorner& corner) { return corner.vn < 0; });
  TripleIndex normals(static_cast<std::size_t>(missing));
  SharedNormals shared;
  shared.number.reserve(faces.corners.size());
  for (std::size_t f = 0; f < faces.count(); ++f)
    for (const ObjCorner& corner : faces.face(f)) {
      const bool flat = smoothing[f] == smoothing_off;
      shared.number.push_back(corner.vn >= 0 ? -1
                              : flat         ? normals({-1, static_cast<std::int32_t>(f), 0})
                                             : normals({corner.v, smoothing[f], 1}));
    }
  shared.count = static_cast<std::int32_t>(normals.size());
  return shared;
}

namespace {

/// Disjoint sets of corners: each names one of its set, the first one itself.
class Sets {
public:
  explicit Sets(std::size_t size) : above_(size) { std::iota(above_.begin(), above_.end(), 0u); }
  std::uint32_t first_of(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]]; // halves the path
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = first_of(a), b = first_of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> above_;
};

class Creases {
public:
  Creases(const ObjFaces& faces, std::span<const FaceNormal> normals, double crease_degrees, std::uint64_t& steps_left)
      : faces_(faces), normals_(normals), min_cosine_(cos_degrees(crease_degrees)), steps_left_(steps_left),
        sets_(faces.corners.size()), face_of_(faces.corners.size()) {
    for (std::size_t f = 0; f < faces.count(); ++f)
      std::fill(face_of_.begin() + faces.begin[f], face_of_.begin() + faces.begin[f + 1],
                static_cast<std::uint32_t>(f));
  }

  /// `corners`: of one vertex, in the order of the file. False if steps run out.
  bool join(std::span<const std::uint32_t> corners) {
    edges_.clear();
    std::uint32_t first = 0; // of the corners of this face
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t corner = corners[k], face = face_of_[corner];
      if (k > 0 && face_of_[corners[k - 1]] == face) sets_.unite(first, corner);
      else first = corner;
      if (normals_[face].n == Double3(0.0)) continue; // it belongs to none
      const std::uint32_t begin = faces_.begin[face], end = faces_.begin[face + 1];
      const std::int32_t vertex = faces_.corners[corner].v;
      for (const std::uint32_t other : {corner == begin ? end - 1 : corner - 1, corner + 1 == end ? begin : corner + 1})
        if (faces_.corners[other].v != vertex) edges_.emplace_back(faces_.corners[other].v, first);
    }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    steps_ = 64 * corners.size() + steps_left_;
    for (std::size_t i = 0, end = 0; i < edges_.size(); i = end) {
      while (end < edges_.size() && edges_[end].first == edges_[i].first) ++end;
      if (end - i == 1) continue;
      if (end - i == 2) join_two(edges_[i].second, edges_[i + 1].second); // nearly always
      else join_all(i, end);
    }
    const bool enough = steps_ > 0;
    steps_left_ = std::min(steps_left_, steps_);
    return enough;
  }

  std::uint32_t first_of(std::uint32_t corner) { return sets_.first_of(corner); }

private:
  using Corners = std::vector<std::uint32_t>;

  bool join_two(std::uint32_t a, std::uint32_t b) {
    if (sets_.first_of(a) == sets_.first_of(b)) return true;
    if (steps_ == 0) return false;
    --steps_;
    if (!belong_together(normals_[face_of_[a]], normals_[face_of_[b]])) return false;
    sets_.unite(a, b);
    return true;
  }

  /// Of the faces at one edge, edges_[begin] to edges_[end], each joins the sets of those that it belongs to. n^2 steps
  /// where none of n belong together.
  void join_all(std::size_t begin, std::size_t end) {
    // A face that is there a thousand times is one here.
    const auto normal = [&](std::uint32_t corner) {
      const Double3& n = normals_[face_of_[corner]].n;
      return std::tuple(n.x, n.y, n.z);
    };
    Corners corners;
    for (std::size_t i = begin; i < end; ++i) corners.push_back(edges_[i].second);
    std::sort(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) { return normal(a) < normal(b); });
    const auto last = std::unique(corners.begin(), corners.end(), [&](std::uint32_t a, std::uint32_t b) {
      if (normal(a) != normal(b)) return false;
      sets_.unite(a, b);
      return true;
    });
    corners.erase(last, corners.end());

    std::vector<Corners> sets;
    for (const std::uint32_t corner : corners) {
      if (steps_ == 0) return;
      Corners joined{corner};
      for (std::size_t k = 0; k < sets.size();) {
        Corners& set = sets[k];
        if (std::none_of(set.begin(), set.end(), [&](std::uint32_t other) { return join_two(other, corner); })) {
          ++k;
          continue;
        }
        if (set.size() > joined.size()) std::swap(set, joined);
        joined.insert(joined.end(), set.begin(), set.end());
        std::swap(set, sets.back());
        sets.pop_back();
      }
      sets.push_back(std::move(joined));
    }
  }

  /// Whether the angle is at most the crease, as far as double tells: no edge of a box that stands askew is smooth, and
  /// the next one not, where the crease is 90 degrees.
  bool belong_together(const FaceNormal& a, const FaceNormal& b) const {
    return dot(a.n, b.n) >= min_cosine_ - (a.arithmetic_error + b.arithmetic_error);
  }

  const ObjFaces& faces_;
  std::span<const FaceNormal> normals_;
  double min_cosine_;
  std::uint64_t& steps_left_;
  std::uint64_t steps_ = 0; // of those at this vertex, what is left
  Sets sets_;
  std::vector<std::uint32_t> face_of_;
  /// The vertex at the other end, and the face's first corner at this one.
  std::vector<std::pair<std::int32_t, std::uint32_t>> edges_;
};

} // namespace

SharedNormals shared_by_crease(const ObjFaces& faces, std::span<const FaceNormal> normals, std::size_t vertices,
                               double crease_degrees, std::uint64_t& steps_left) {
  const RawVector<ObjCorner>& corners = faces.corners;
  // The corners of each vertex, by a counting sort.
  std::vector<std::uint32_t> begin(vertices + 1);
  for (const ObjCorner& corner : corners)
    if (corner.vn < 0) ++begin[static_cast<std::size_t>(corner.v) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1), sorted(begin.back());
  for (std::uint32_t i = 0; i < corners.size(); ++i)
    if (corners[i].vn < 0) sorted[next[static_cast<std::size_t>(corners[i].v)]++] = i;

  Creases creases(faces, normals, crease_degrees, steps_left);
  for (std::size_t v = 0; v < vertices; ++v)
    if (!creases.join(std::span(sorted).subspan(begin[v], begin[v + 1] - begin[v]))) {
      steps_left = 0;
      return {};
    }

  SharedNormals shared;
  shared.number.assign(corners.size(), -1);
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (corners[i].vn >= 0) continue;
    const std::uint32_t first = creases.first_of(i); // not after i, so that it has its number
    shared.number[i] = first == i ? shared.count++ : shared.number[first];
  }
  return shared;
}

} // namespace refraster
