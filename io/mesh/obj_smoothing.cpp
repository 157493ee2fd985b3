#include "io/mesh/obj_faces.h"

#include "io/mesh/obj/first_numbers.h"
#include "io/mesh/triple_index.h"
#include "io/parallel/pieces.h"
#include "math/elementary/degrees.h"

#include <algorithm>
#include <array>
#include <bit>
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
  explicit Sets(std::size_t size) : above_(size) {}
  /// Alone in its set, as it must be before anything else is asked of it.
  void make(std::uint32_t i) { above_[i] = i; }
  /// The same as first_of, for several threads at once: nothing is changed.
  std::uint32_t found(std::uint32_t i) const {
    while (above_[i] != i) i = above_[i];
    return i;
  }
  std::uint32_t first_of(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]]; // halves the path
    return i;
  }
  /// Puts a corner that is alone into the set of one that is its first.
  void put(std::uint32_t i, std::uint32_t first) { above_[i] = first; }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = first_of(a), b = first_of(b);
    above_[std::max(a, b)] = std::min(a, b);
  }

private:
  RawVector<std::uint32_t> above_;
};

/// Of each corner, its face.
class FacesOfCorners {
public:
  explicit FacesOfCorners(const ObjFaces& faces) {
    if (faces.corners.size() == 3 * faces.count()) return; // all are triangles, having 3 corners at least
    faces_.resize(faces.corners.size());
    for (std::size_t f = 0; f < faces.count(); ++f)
      std::fill(faces_.begin() + faces.begin[f], faces_.begin() + faces.begin[f + 1], static_cast<std::uint32_t>(f));
  }
  std::uint32_t operator[](std::uint32_t corner) const { return faces_.empty() ? corner / 3 : faces_[corner]; }

private:
  RawVector<std::uint32_t> faces_;
};

/// Joins the corners of a vertex. Those of different vertices may be joined at the same time.
class Creases {
public:
  Creases(const ObjFaces& faces, const FacesOfCorners& face_of, std::span<const FaceNormal> normals,
          double crease_degrees, Sets& sets)
      : faces_(faces), face_of_(face_of), normals_(normals), min_cosine_(cos_degrees(crease_degrees)), sets_(sets) {}

  /// `corners`: of one vertex, in the order of the file. False if steps run out.
  bool join(std::span<const std::uint32_t> corners, std::uint64_t& steps_left) {
    if (join_fan(corners)) return true;
    for (const std::uint32_t corner : corners) sets_.make(corner);
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
        if (faces_.corners[other].v != vertex)
          edges_.push_back(std::uint64_t{static_cast<std::uint32_t>(faces_.corners[other].v)} << 32 | first);
    }
    sort_edges();
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    steps_ = 64 * corners.size() + steps_left;
    for (std::size_t i = 0, end = 0; i < edges_.size(); i = end) {
      while (end < edges_.size() && edges_[end] >> 32 == edges_[i] >> 32) ++end;
      if (end - i == 1) continue;
      if (end - i == 2) join_two(corner_of(edges_[i]), corner_of(edges_[i + 1])); // nearly always
      else join_all(i, end);
    }
    const bool enough = steps_ > 0;
    steps_left = std::min(steps_left, steps_);
    return enough;
  }

private:
  using Corners = std::vector<std::uint32_t>;
  static constexpr std::size_t max_fan = 8;

  /// As nearly every vertex is: few faces, each there once and with a normal, all of one winding, so that an edge where
  /// two meet leaves one of them and arrives in the other. False for any other vertex: then nothing is changed.
  bool join_fan(std::span<const std::uint32_t> corners) {
    const std::size_t n = corners.size();
    if (n > max_fan) return false;
    std::array<std::int32_t, max_fan> next, before; // of each face, the vertices at the other ends of its edges here
    next.fill(-1), before.fill(-2);
    std::array<const FaceNormal*, max_fan> normals;
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t corner = corners[k], face = face_of_[corner];
      const std::uint32_t begin = faces_.begin[face], end = faces_.begin[face + 1];
      normals[k] = &normals_[face];
      next[k] = faces_.corners[corner + 1 == end ? begin : corner + 1].v;
      before[k] = faces_.corners[corner == begin ? end - 1 : corner - 1].v;
      const std::int32_t vertex = faces_.corners[corner].v;
      if (next[k] == vertex || before[k] == vertex || next[k] == before[k] || normals[k]->n == Double3(0.0) ||
          (k > 0 && normals[k] == normals[k - 1]))
        return false;
    }
    const auto equal_to = [](const std::array<std::int32_t, max_fan>& list, std::int32_t vertex) {
      std::uint32_t set = 0;
      for (std::size_t i = 0; i < max_fan; ++i) set |= static_cast<std::uint32_t>(list[i] == vertex) << i;
      return set;
    };
    std::array<std::uint32_t, max_fan> meets{}; // of each face, a bit for each one that it belongs together with
    std::uint32_t met = 0;                      // by another one, along the edge that arrives in them
    for (std::size_t k = 0; k < n; ++k) {
      const std::uint32_t arrives = equal_to(before, next[k]);
      if ((arrives & (arrives - 1)) != 0 || (arrives & met) != 0) return false; // three faces at an edge, or more
      if (arrives == 0) { // a border, unless another face leaves along it too
        if (equal_to(next, next[k]) != 1u << k) return false;
        continue;
      }
      met |= arrives;
      const auto other = static_cast<std::size_t>(std::countr_zero(arrives));
      if (belong_together(*normals[k], *normals[other])) meets[k] |= arrives, meets[other] |= 1u << k;
    }
    for (std::uint32_t left = ((1u << n) - 1) & ~met; left != 0; left &= left - 1) { // borders, unless two faces arrive
      const auto k = static_cast<std::size_t>(std::countr_zero(left));
      if (equal_to(before, before[k]) != 1u << k) return false;
    }
    for (std::uint32_t left = (1u << n) - 1; left != 0;) {
      const auto first = static_cast<std::size_t>(std::countr_zero(left));
      std::uint32_t set = 0;
      for (std::uint32_t added = 1u << first; added != 0;) {
        const auto k = static_cast<std::size_t>(std::countr_zero(added));
        set |= 1u << k;
        added = (added | meets[k]) & ~set;
        sets_.put(corners[k], corners[first]);
      }
      left &= ~set;
    }
    return true;
  }

  static std::uint32_t corner_of(std::uint64_t edge) { return static_cast<std::uint32_t>(edge); }

  /// A vertex has some six edges, twice: to insert one by one is the fastest.
  void sort_edges() {
    if (edges_.size() > 32) return std::sort(edges_.begin(), edges_.end());
    for (std::size_t i = 1; i < edges_.size(); ++i) {
      const std::uint64_t edge = edges_[i];
      std::size_t at = i;
      for (; at > 0 && edges_[at - 1] > edge; --at) edges_[at] = edges_[at - 1];
      edges_[at] = edge;
    }
  }

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
    for (std::size_t i = begin; i < end; ++i) corners.push_back(corner_of(edges_[i]));
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
  const FacesOfCorners& face_of_;
  std::span<const FaceNormal> normals_;
  double min_cosine_;
  Sets& sets_;
  std::uint64_t steps_ = 0; // of those at this vertex, what is left
  /// The vertex at the other end in the upper half, and the face's first corner at this one.
  std::vector<std::uint64_t> edges_;
};

/// The corners without a vn, vertex by vertex, in the order of the file.
class CornersOfVertices {
public:
  CornersOfVertices(const RawVector<ObjCorner>& corners, std::size_t vertices, std::size_t pieces)
      : corners_(corners), vertices_(vertices), pieces_(pieces), begin_(vertices + 1) {}

  /// Pieces are ranges of vertices. First all are counted, in parallel, then added up, then filled, in parallel.
  void count(std::size_t piece) {
    const auto [first, last] = range(piece);
    std::fill(begin_.begin() + static_cast<std::ptrdiff_t>(first + 1),
              begin_.begin() + static_cast<std::ptrdiff_t>(last + 1), 0u);
    each(first, last, [&](std::uint32_t, std::size_t v) { ++begin_[v + 1]; });
  }
  void add_up() {
    begin_[0] = 0;
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    sorted_.resize(begin_.back());
  }
  void fill(std::size_t piece) {
    const auto [first, last] = range(piece);
    std::vector<std::uint32_t> next(begin_.begin() + static_cast<std::ptrdiff_t>(first),
                                    begin_.begin() + static_cast<std::ptrdiff_t>(last));
    each(first, last, [&, from = first](std::uint32_t i, std::size_t v) { sorted_[next[v - from]++] = i; });
  }

  std::pair<std::size_t, std::size_t> range(std::size_t piece) const {
    return {vertices_ * piece / pieces_, vertices_ * (piece + 1) / pieces_};
  }
  std::span<const std::uint32_t> operator[](std::size_t v) const {
    return std::span<const std::uint32_t>(sorted_).subspan(begin_[v], begin_[v + 1] - begin_[v]);
  }

private:
  template <class Body>
  void each(std::size_t first, std::size_t last, const Body& body) const {
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      const auto v = static_cast<std::size_t>(corners_[i].v);
      if (corners_[i].vn < 0 && v - first < last - first) body(i, v);
    }
  }

  const RawVector<ObjCorner>& corners_;
  std::size_t vertices_, pieces_;
  RawVector<std::uint32_t> begin_, sorted_;
};

} // namespace

SharedNormals shared_by_crease(const ObjFaces& faces, std::span<const FaceNormal> normals, std::size_t vertices,
                               double crease_degrees, int threads, std::uint64_t& steps_left) {
  const RawVector<ObjCorner>& corners = faces.corners;
  const std::size_t pieces = std::clamp<std::size_t>(vertices / 1024, 1, static_cast<std::size_t>(threads));
  CornersOfVertices at(corners, vertices, pieces);
  for_pieces(threads, pieces, [&](std::size_t piece, int) { at.count(piece); });
  at.add_up();

  Sets sets(corners.size());
  const FacesOfCorners face_of(faces);
  // Those for which the steps that are free do not suffice take the others one after the other.
  std::vector<std::vector<std::size_t>> intricate(pieces);
  for_pieces(threads, pieces, [&](std::size_t piece, int) {
    at.fill(piece);
    Creases creases(faces, face_of, normals, crease_degrees, sets);
    const auto [first, last] = at.range(piece);
    for (std::size_t v = first; v < last; ++v)
      if (std::uint64_t none = 0; !at[v].empty() && !creases.join(at[v], none)) intricate[piece].push_back(v);
  });
  Creases creases(faces, face_of, normals, crease_degrees, sets);
  for (const std::vector<std::size_t>& of_piece : intricate)
    for (const std::size_t v : of_piece)
      if (!creases.join(at[v], steps_left)) {
        steps_left = 0;
        return {};
      }

  SharedNormals shared;
  shared.number.resize(corners.size());
  const auto first = [&](std::size_t i) {
    return corners[i].vn >= 0 ? std::int64_t{-1} : std::int64_t{sets.found(static_cast<std::uint32_t>(i))};
  };
  shared.count = static_cast<std::int32_t>(
      number_firsts(threads, corners.size(), first, shared.number.data(), [](std::size_t, std::uint32_t) {}));
  return shared;
}

} // namespace refraster
