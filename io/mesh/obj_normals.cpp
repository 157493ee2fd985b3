#include "io/mesh/obj_faces.h"

#include "io/mesh/mesh_normals.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace refraster {
namespace {

// Half a unit in the last place of 1: one rounding in double, in proportion to the result.
constexpr double rounding = 0x1p-53;
// Of a vector made unit: each component is within 3 units in the last place (scale exact, root, reciprocal and product
// half a unit each and a sum), 6 roundings, and there are three.
constexpr double unit_error = 6 * 1.7320508075688773 * rounding;

Double3 magnitudes(const Double3& a) {
  return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}

} // namespace

double rounding_of(const Float3& point) {
  // Half a unit in the last place of a coordinate is 2^-24 of it; of a subnormal one, half of the smallest float, and
  // of three of these less than that.
  return 0x1p-24 * length(Double3(point)) + static_cast<double>(std::numeric_limits<float>::denorm_min());
}

Double3 area_vector(std::span<const Float3> polygon) {
  const Double3 origin = Double3(polygon[0]);
  Double3 sum(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(Double3(polygon[i]) - origin, Double3(polygon[i + 1]) - origin);
  return sum;
}

FaceNormal face_normal(std::span<const Float3> polygon) {
  const Double3 area = area_vector(polygon), origin = Double3(polygon[0]);
  const std::size_t n = polygon.size();
  // A product in the sum has passed a rounding in each of two differences, one of its own, one where it is subtracted,
  // and one for each of n - 3 additions; one more for this bound's own sum.
  Double3 products(0.0);
  double moved = 0; // to first order, by the rounding of each corner: along it the sum changes by the diagonal across
  for (std::size_t i = 0; i < n; ++i) {
    const Double3 before = Double3(polygon[(i + n - 1) % n]), next = Double3(polygon[(i + 1) % n]);
    moved += rounding_of(polygon[i]) * length(next - before);
    if (i == 0 || i + 1 == n) continue;
    const Double3 a = magnitudes(Double3(polygon[i]) - origin), b = magnitudes(next - origin);
    products += Double3(a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x);
  }
  const double arithmetic = static_cast<double>(n + 2) * rounding * length(products), size = length(area);
  FaceNormal result;
  if (!(size > moved + arithmetic)) return result;
  // |a/|a| - b/|b|| <= 2 |a - b| / |a|.
  result.n = normalize(area);
  result.error = 2 * (moved + arithmetic) / size + unit_error;
  result.arithmetic_error = 2 * arithmetic / size + unit_error;
  return result;
}

namespace {

constexpr double pi = 3.14159265358979323846;

/// Neighbouring corners of a polygon that lie in one place, as far as floats tell: such a corner has no edge to the
/// next, and the angle between its edges is that between the edges of all of them.
struct Run {
  std::size_t first = 0, size = 0; // corners first, first + 1 …, round the polygon
};

void find_runs(std::span<const Float3> polygon, std::vector<Run>& runs) {
  runs.clear();
  const std::size_t n = polygon.size();
  const auto at_the_next = [&](std::size_t i) {
    const Float3 &p = polygon[i], &q = polygon[(i + 1) % n];
    return p == q || length(Double3(p) - Double3(q)) <= rounding_of(p) + rounding_of(q);
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

/// The angle inside a polygon at a corner, in [0, 2 pi), and how far off it may be.
struct Angle {
  double radians, error;
};

/// From the edge to `next` round the normal to the edge to `before`.
Angle inner_angle(const Float3& before, const Float3& p, const Float3& next, const FaceNormal& face) {
  const Double3 to_next = Double3(next) - Double3(p), to_before = Double3(before) - Double3(p);
  const Double3 a = normalize(to_next), b = normalize(to_before), across = cross(a, b);
  const auto direction_error = [&](const Float3& end, const Double3& edge) {
    return 2 * (rounding_of(p) + rounding_of(end)) / length(edge) + unit_error;
  };
  const double edges = direction_error(next, to_next) + direction_error(before, to_before);
  // Cross product, dot products: 7 roundings for the sine, 3 for the cosine. Then the arc tangent and one addition, of
  // angles up to 2 pi, whose unit in the last place is 8 roundings.
  const double error = edges + (10 + 8 * (atan2_error<double>.max + 0.5)) * rounding;
  const double cosine = dot(a, b), sine = dot(face.n, across);
  // An edge that runs back along the one before is no whole turn.
  if (std::abs(sine) <= edges + face.error) return {atan2(std::abs(sine), cosine), error};
  const double angle = atan2(sine, cosine);
  return {angle < 0 ? angle + 2 * pi : angle, error};
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

/// Sums up the normals of faces around vertices, each weighted by the angle that the face takes there.
class NormalSums {
public:
  explicit NormalSums(const SharedNormals& shared)
      : shared_(shared), sums_(static_cast<std::size_t>(shared.count)), counted_in_(sums_.size(), 0) {}

  /// `first`: the face's first corner.
  void add(std::span<const Float3> polygon, std::size_t first, const FaceNormal& face) {
    find_runs(polygon, runs_);
    const std::size_t n = polygon.size();
    for (const Run& run : runs_) {
      ++run_number_;
      for (std::size_t k = 0; k < run.size; ++k) {
        const std::size_t i = (run.first + k) % n;
        const std::int32_t number = shared_.number[first + i];
        // A vertex named twice in one place has one angle there.
        if (number < 0 || std::exchange(counted_in_[static_cast<std::size_t>(number)], run_number_) == run_number_)
          continue;
        const Angle angle =
            inner_angle(polygon[(run.first + n - 1) % n], polygon[i], polygon[(run.first + run.size) % n], face);
        sums_[static_cast<std::size_t>(number)].add(face.n * angle.radians,
                                                    angle.radians * (face.error + 2 * rounding) + angle.error);
      }
    }
  }
  const std::vector<Sum>& sums() const { return sums_; }

private:
  const SharedNormals& shared_;
  std::vector<Sum> sums_;
  std::vector<std::uint64_t> counted_in_; // of each normal: the last run that it was counted in
  std::uint64_t run_number_ = 0;
  std::vector<Run> runs_;
};

} // namespace

bool add_missing_normals(ObjText& obj, const MeshNormals& wanted, std::uint64_t& steps_left) {
  ObjFaces& faces = obj.faces;
  if (wanted.from != NormalsFrom::file) {
    for (ObjCorner& corner : faces.corners) corner.vn = -1;
    obj.vn.clear();
  }
  const auto lacks = [](const ObjCorner& corner) { return corner.vn < 0; };
  if (std::none_of(faces.corners.begin(), faces.corners.end(), lacks)) return true;

  std::vector<Float3> polygon;
  const auto polygon_of = [&](std::size_t f) {
    polygon.clear();
    for (const ObjCorner& corner : faces.face(f)) polygon.push_back(obj.v[static_cast<std::size_t>(corner.v)]);
    return std::span<const Float3>(polygon);
  };
  const auto is_wanted = [&](std::size_t f) {
    const auto corners = faces.face(f);
    return std::any_of(corners.begin(), corners.end(), lacks);
  };
  std::vector<FaceNormal> normals(faces.count());
  for (std::size_t f = 0; f < faces.count(); ++f)
    if (is_wanted(f)) normals[f] = face_normal(polygon_of(f));

  const bool by_file = wanted.from == NormalsFrom::file;
  if (wanted.from == NormalsFrom::flat) obj.smoothing.assign(faces.count(), smoothing_off);
  if (wanted.from == NormalsFrom::smooth) obj.smoothing.assign(faces.count(), 1);
  const bool by_crease = wanted.from == NormalsFrom::crease || (by_file && !obj.has_smoothing);
  const SharedNormals shared =
      by_crease ? shared_by_crease(faces, normals, obj.v.size(),
                                   by_file ? crease_degrees_of_files : wanted.crease_degrees, steps_left)
                : shared_by_group(faces, obj.smoothing);
  if (shared.count == 0) return false;

  NormalSums sums(shared);
  for (std::size_t f = 0; f < faces.count(); ++f)
    if (is_wanted(f)) sums.add(polygon_of(f), faces.begin[f], normals[f]);
  const auto given = static_cast<std::int32_t>(obj.vn.size());
  for (const Sum& sum : sums.sums()) obj.vn.emplace_back(sum.direction());
  for (std::size_t f = 0; f < faces.count(); ++f)
    for (std::size_t i = faces.begin[f]; i < faces.begin[f + 1]; ++i) {
      const std::int32_t number = shared.number[i];
      if (number < 0) continue;
      faces.corners[i].vn = given + number;
      // Of a flat face there is nothing to be summed up.
      if (!by_crease && obj.smoothing[f] == smoothing_off)
        obj.vn[static_cast<std::size_t>(given + number)] = Float3(normals[f].n);
    }
  return true;
}

} // namespace refraster
