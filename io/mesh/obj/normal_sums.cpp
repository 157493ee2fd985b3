#include "io/mesh/obj/normal_sums.h"

#include "io/mesh/obj/polygon_batch.h"
#include "io/parallel/pieces.h"

#include <algorithm>
#include <array>
#include <unordered_set>
#include <vector>

namespace refraster {
namespace {

/// Whether two neighbouring corners, so far from each other, lie in one place, as far as floats tell.
template <class T>
MaskOf<T> is_within_rounding(const T& distance, const T& p_rounding, const T& q_rounding) {
  return distance <= p_rounding + q_rounding; // so are equal ones
}

/// Neighbouring corners of a polygon that lie in one place: such a corner has no edge to the next, and the angle
/// between its edges is that between the edges of all of them.
struct Run {
  std::size_t first = 0, size = 0; // corners first, first + 1 …, round the polygon
};

void find_runs(std::span<const Double3> polygon, std::span<const double> roundings, std::vector<Run>& runs) {
  runs.clear();
  const std::size_t n = polygon.size();
  const auto at_the_next = [&](std::size_t i) {
    const std::size_t next = (i + 1) % n;
    return is_within_rounding<double>(length(polygon[next] - polygon[i]), roundings[i], roundings[next]);
  };
  std::size_t start = 0;
  while (start < n && at_the_next((start + n - 1) % n)) ++start;
  if (start == n) return;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (start + k) % n;
    if (k == 0 || !at_the_next((i + n - 1) % n)) runs.push_back({i, 0});
    ++runs.back().size;
  }
}

/// A sum of vectors, and how far rounding may have moved it.
struct Sum {
  Double3 value{0};
  double error = 0;

  void add(const Double3& term, double term_error) {
    value += term;
    error += term_error + rounding * length(value);
  }
  /// Zero where it is not known to be anything else.
  Double3 direction() const { return length(value) > error ? normalize(value) : Double3(0.0); }
};

/// What a face adds at a corner.
template <class T>
struct Term {
  Vec3<T> value;
  T error;
};
template <class T>
Term<T> term_of(const FaceNormalOf<T>& face, const InnerAngle<T>& angle) {
  return {face.n * angle.radians, angle.radians * (face.error + T(2 * rounding)) + angle.error};
}

/// Sums of the numbers from `first` on.
class NormalSums {
public:
  NormalSums(const ObjText& obj, std::span<const FaceNormal> normals, const SharedNormals& shared, std::int32_t first,
             std::int32_t last)
      : obj_(obj), normals_(normals), shared_(shared), first_(first), sums_(static_cast<std::size_t>(last - first)) {}

  void add_faces() {
    const ObjFaces& faces = obj_.faces;
    for (std::size_t f = 0; f < faces.count(); ++f) {
      const std::size_t begin = faces.begin[f], size = faces.begin[f + 1] - begin;
      bool is_mine = false;
      for (std::size_t i = 0; i < size; ++i) is_mine = is_mine || sum_of(begin + i);
      if (!is_mine) continue;
      if (!batch_.takes(size)) add_batch();
      if (batch_.takes(size)) batch_.add(f, faces.face(f), obj_.v);
      else add_face(f);
    }
    add_batch();
  }

  void write(std::span<Float3> sums) const {
    for (std::size_t i = 0; i < sums_.size(); ++i)
      sums[static_cast<std::size_t>(first_) + i] = Float3(sums_[i].direction());
  }

private:
  using Lanes = PolygonBatch::Lanes;

  /// That of a corner; null if it is not of these.
  Sum* sum_of(std::size_t corner) {
    const std::int32_t number = shared_.number[corner];
    const auto place = static_cast<std::uint32_t>(number) - static_cast<std::uint32_t>(first_);
    return number >= 0 && place < sums_.size() ? &sums_[place] : nullptr;
  }

  void add_batch() {
    if (batch_.count() == 0) return;
    batch_.load();
    const std::size_t n = batch_.corners();
    const auto points = batch_.points();
    const auto roundings = batch_.roundings();
    std::array<std::array<double, PolygonBatch::lanes>, 5> columns{};
    for (int lane = 0; lane < batch_.count(); ++lane) {
      const FaceNormal& normal = normals_[batch_.face(lane)];
      const auto column = static_cast<std::size_t>(lane);
      columns[0][column] = normal.n.x, columns[1][column] = normal.n.y, columns[2][column] = normal.n.z;
      columns[3][column] = normal.error;
    }
    const auto lanes_of = PolygonBatch::lanes_of;
    const FaceNormalOf<Lanes> face{
        {lanes_of(columns[0]), lanes_of(columns[1]), lanes_of(columns[2])}, lanes_of(columns[3]), lanes_of(columns[4])};
    std::array<Term<Lanes>, PolygonBatch::max_corners> terms;
    MaskOf<Lanes> has_runs = Lanes(0.0) > Lanes(0.0);
    std::array<EdgeDirection<Lanes>, PolygonBatch::max_corners> edges; // from each corner to the next
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = i + 1 == n ? 0 : i + 1;
      edges[i] = edge_direction<Lanes>({points[i], roundings[i]}, {points[next], roundings[next]});
      has_runs = has_runs | is_within_rounding(edges[i].length, roundings[i], roundings[next]);
    }
    for (std::size_t i = 0; i < n; ++i)
      terms[i] = term_of(face, inner_angle(edges[i], edges[i == 0 ? n - 1 : i - 1].reversed(), face));
    const std::uint32_t odd = lane_set(has_runs);
    for (int lane = 0; lane < batch_.count(); ++lane) {
      const std::size_t f = batch_.face(lane);
      if (odd >> lane & 1) {
        add_face(f);
        continue;
      }
      for (std::size_t i = 0; i < n; ++i)
        if (Sum* const sum = sum_of(obj_.faces.begin[f] + i))
          sum->add({terms[i].value.x[lane], terms[i].value.y[lane], terms[i].value.z[lane]}, terms[i].error[lane]);
    }
    batch_.clear();
  }

  /// Any face.
  void add_face(std::size_t f) {
    polygon_.clear(), roundings_.clear();
    for (const ObjCorner& corner : obj_.faces.face(f)) {
      polygon_.emplace_back(obj_.v[static_cast<std::size_t>(corner.v)]);
      roundings_.push_back(rounding_of(polygon_.back()));
    }
    find_runs(polygon_, roundings_, runs_);
    const std::size_t n = polygon_.size();
    const auto point = [&](std::size_t i) { return RoundedPoint<double>{polygon_[i % n], roundings_[i % n]}; };
    for (const Run& run : runs_) {
      counted_.clear();
      for (std::size_t k = 0; k < run.size; ++k) {
        const std::size_t i = (run.first + k) % n;
        Sum* const sum = sum_of(obj_.faces.begin[f] + i);
        // A vertex named twice in one place has one angle there.
        if (!sum || (run.size > 1 && !counted_.insert(sum).second)) continue;
        const Term<double> term =
            term_of(normals_[f], inner_angle(edge_direction(point(i), point(run.first + run.size)),
                                             edge_direction(point(i), point(run.first + n - 1)), normals_[f]));
        sum->add(term.value, term.error);
      }
    }
  }

  const ObjText& obj_;
  std::span<const FaceNormal> normals_;
  const SharedNormals& shared_;
  std::int32_t first_;
  RawVector<Sum> sums_;
  PolygonBatch batch_;
  std::vector<Double3> polygon_;
  std::vector<double> roundings_;
  std::vector<Run> runs_;
  std::unordered_set<const Sum*> counted_; // of a run
};

} // namespace

void sum_normals(const ObjText& obj, std::span<const FaceNormal> normals, const SharedNormals& shared, int threads,
                 std::span<Float3> sums) {
  // A thread takes a range of numbers, and those faces that have any of them. Numbers follow the file, as faces mostly
  // do: few faces are of several ranges.
  const std::int64_t count = shared.count, pieces = std::clamp<std::int64_t>(count / 1024, 1, threads);
  for_pieces(threads, static_cast<std::size_t>(pieces), [&](std::size_t piece, int) {
    const auto border = [&](std::size_t i) {
      return static_cast<std::int32_t>(count * static_cast<std::int64_t>(i) / pieces);
    };
    NormalSums range(obj, normals, shared, border(piece), border(piece + 1));
    range.add_faces();
    range.write(sums);
  });
}

} // namespace refraster
