#include "io/obj_faces.h"

#include "io/triple_index.h"
#include "math/elementary.h"

#include <algorithm>

namespace refraster {

Double3 area_vector(std::span<const Float3> polygon) {
  const Double3 origin = Double3(polygon[0]);
  Double3 sum(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(Double3(polygon[i]) - origin, Double3(polygon[i + 1]) - origin);
  return sum;
}

namespace {

constexpr double pi = 3.14159265358979323846;

/// The angle inside a polygon at p, in [0, 2 pi): from the edge to `next` round the normal n to the edge to `before`.
double inner_angle(const Double3& before, const Double3& p, const Double3& next, const Double3& n) {
  const Double3 a = normalize(next - p), b = normalize(before - p);
  const double angle = atan2(dot(n, cross(a, b)), dot(a, b));
  return angle < 0 ? angle + 2 * pi : angle;
}

} // namespace

void add_missing_normals(ObjText& obj, ObjFaces& faces) {
  const auto lacks = [](const ObjCorner& corner) { return corner.vn < 0; };
  const auto missing = static_cast<std::size_t>(std::count_if(faces.corners.begin(), faces.corners.end(), lacks));
  if (missing == 0) return;

  // One normal for each (vertex, smoothing group); for a flat face, one of its own.
  TripleIndex normals(missing);
  std::vector<Double3> sums;
  const auto first = static_cast<std::int32_t>(obj.vn.size());
  std::vector<Float3> polygon;
  for (std::size_t f = 0; f < faces.count(); ++f) {
    const std::span<ObjCorner> corners = faces.face(f);
    if (std::none_of(corners.begin(), corners.end(), lacks)) continue;
    polygon.clear();
    for (const ObjCorner& corner : corners) polygon.push_back(obj.v[static_cast<std::size_t>(corner.v)]);
    const Double3 n = normalize(area_vector(polygon));
    const std::size_t size = corners.size();
    for (std::size_t i = 0; i < size; ++i) {
      if (!lacks(corners[i])) continue;
      const bool flat = obj.smoothing[f] == smoothing_off;
      const std::int32_t normal =
          flat ? normals({-1, static_cast<std::int32_t>(f), 0}) : normals({corners[i].v, obj.smoothing[f], 1});
      sums.resize(normals.size(), Double3(0.0));
      corners[i].vn = first + normal;
      sums[static_cast<std::size_t>(normal)] +=
          flat ? n
               : n * inner_angle(Double3(polygon[(i + size - 1) % size]), Double3(polygon[i]),
                                 Double3(polygon[(i + 1) % size]), n);
    }
  }
  for (const Double3& sum : sums) obj.vn.push_back(Float3(normalize(sum)));
}

} // namespace refraster
