#include "verify/bounds/device_triangle.h"

#include "raster/shade/corner_values.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr double u = 0x1p-24;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of a division and the viewport: of the quotient, the product and the sum, for coordinates up to the image's size.
constexpr double viewport_roundings = 6;
/// Of the quotient of two planes: a division, and products that make up for one.
constexpr double quotient_roundings = 3.5;

} // namespace

DeviceTriangle::DeviceTriangle(const DeviceFrame& frame, std::uint32_t number)
    : frame_(frame), ref_(frame.triangle(number)), number_(number) {
  place_corners();
}

const Float3& DeviceTriangle::mesh_position(std::size_t corner) const {
  const Mesh& mesh = *frame_.scene().objects[ref_.object].mesh;
  return mesh.positions[mesh.triangles[ref_.triangle][corner]];
}

double DeviceTriangle::corner_reach(std::size_t corner) const {
  return snap_radius() + corner_error_[corner];
}

double DeviceTriangle::snap_radius() const {
  const RasterProfile& raster = frame_.profile().raster;
  return raster.lattice * raster.snap_steps;
}

void DeviceTriangle::place_corners() {
  const Geometry& geometry = frame_.context().geometry;
  const double width = frame_.width(), height = frame_.height(), half = std::max(width, height) / 2;
  std::array<Double3, 3> homogeneous;
  std::uint8_t any = 0;
  in_front_ = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex v = geometry.window[ref_.vertex[i]];
    any |= v.outcode;
    if (v.outcode & outcode::not_finite) return;
    const Float3& p = mesh_position(i);
    const Double4 clip = clip_position(geometry.transforms[ref_.object], p);
    homogeneous[i] = {(clip.x + clip.w) / 2 * width, (clip.w - clip.y) / 2 * height, clip.w};
    z_clip_[i] = clip.z, w_clip_[i] = clip.w;
    const double x = frame_.clip_error(ref_.object, 0, p), y = frame_.clip_error(ref_.object, 1, p),
                 z = frame_.clip_error(ref_.object, 2, p), w = frame_.clip_error(ref_.object, 3, p);
    xy_error_[i] = half * std::max(x, y), w_error_[i] = w;
    z_error_[i] = z + w; // of z / w, where that is at most 1
    if (!(clip.w > w)) {
      in_front_ = false;
      continue;
    }
    corner_[i] = Double2(homogeneous[i].x, homogeneous[i].y) / clip.w;
    const double far = std::max(std::abs(corner_[i].x - width / 2), std::abs(corner_[i].y - height / 2));
    viewport_error_[i] = viewport_roundings * u * (half + far);
    corner_error_[i] = (xy_error_[i] + far * w) / (clip.w - w) + viewport_error_[i];
    if (!(v.outcode & outcode::unsnapped)) moved_[i] = corner_[i] - Double2(v.x, v.y) / double{subpixels};
  }
  // Wholly outside of one side of the view, by more than any rounding moves it: the sides and, of three corners in
  // front, nothing else. Depth is judged where it is asked for.
  seen_ = w_clip_[0] > -w_error_[0] || w_clip_[1] > -w_error_[1] || w_clip_[2] > -w_error_[2];
  if (!seen_) return;
  clipped_ = any != 0;
  planes_ = WindowTriangle(homogeneous);
  PixelRect& box = pixels_;
  box = {0, 0, frame_.width(), frame_.height()};
  if (in_front_) {
    area_error_ = AreaError(corner_, width, height);
    reach_ = snap_radius() + std::max({corner_error_[0], corner_error_[1], corner_error_[2]});
    const auto along = [&](int axis, int size, int& first, int& count) {
      const double a = corner_[0][axis], b = corner_[1][axis], c = corner_[2][axis];
      const double low = std::floor(std::min({a, b, c}) - reach_), high = std::floor(std::max({a, b, c}) + reach_);
      first = static_cast<int>(std::clamp(low, 0.0, static_cast<double>(size)));
      count = static_cast<int>(std::clamp(high + 1, 0.0, static_cast<double>(size))) - first;
    };
    along(0, frame_.width(), box.x, box.width), along(1, frame_.height(), box.y, box.height);
    const Double2 e1 = corner_[1] - corner_[0], e2 = corner_[2] - corner_[0];
    const double area = e1.x * e2.y - e1.y * e2.x; // y down: positive if clockwise
    double may_differ = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Double2 edge = corner_[(i + 2) % 3] - corner_[(i + 1) % 3];
      const double r = corner_reach(i);
      may_differ += r * (std::abs(edge.x) + std::abs(edge.y)) + 2 * r * corner_reach((i + 1) % 3);
    }
    facing_ = area > may_differ ? -1 : area < -may_differ ? 1 : 0;
  } else {
    // The sign of the homogeneous determinant is that of the area of what lies in front. A double's roundings in it are
    // below 2^-50 of the sizes it is made from; those of float coordinates matter.
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i)
      size += (std::abs(homogeneous[i].x) + std::abs(homogeneous[i].y)) * std::abs(w_clip_[(i + 1) % 3]);
    const double error = (std::max({xy_error_[0], xy_error_[1], xy_error_[2]}) +
                          snap_radius() * std::max({w_clip_[0], w_clip_[1], w_clip_[2], 0.0}) +
                          std::max({w_error_[0], w_error_[1], w_error_[2]})) *
                         size * 3 / std::max(half, 1.0);
    facing_ = planes_.determinant > error ? -1 : planes_.determinant < -error ? 1 : 0;
  }
}

Coverage DeviceTriangle::coverage(double x, double y) const {
  if (!seen_) return {};
  return in_front_ ? coverage_in_front(x, y) : coverage_by_weights(x, y);
}

/// Two ways, of which either suffices. Wherever the corners are, the triangle lies within its Minkowski sum with the
/// square of all that a corner may be moved, and holds what is farther inside. That is far too much where a corner lies
/// near the eye plane, and its place in the window is hardly known, though the lines to it are: then what counts is how
/// an edge is moved near the point. From a to b, p is on the inner side by cross(b - a, p - a); where the ends are
/// moved by d and e, that changes by cross(e, p - a) + cross(d, b - p) - cross(e, d).
Coverage DeviceTriangle::coverage_in_front(double x, double y) const {
  const auto [low_x, high_x] = std::minmax({corner_[0].x, corner_[1].x, corner_[2].x});
  const auto [low_y, high_y] = std::minmax({corner_[0].y, corner_[1].y, corner_[2].y});
  if (x < low_x - reach_ || x > high_x + reach_ || y < low_y - reach_ || y > high_y + reach_) return {};
  const Double2 e1 = corner_[1] - corner_[0], e2 = corner_[2] - corner_[0];
  const double sign = e1.x * e2.y - e1.y * e2.x < 0 ? -1 : 1;
  const auto size = [](const Double2& v) { return std::abs(v.x) + std::abs(v.y); };
  const double vertex_shift = vertex_shift_at(x, y);
  Coverage result{Coverage::Certainty::inside, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t ia = (k + 1) % 3, ib = (k + 2) % 3;
    const Double2 p(x, y), &a = corner_[ia], &b = corner_[ib];
    const Double2 edge = b - a;
    const double value = sign * (edge.x * (y - a.y) - edge.y * (x - a.x));
    double reach = reach_ * size(edge) + 2 * reach_ * reach_;
    if (facing_ != 0) {
      const double ra = snap_radius() + viewport_error_[ia], rb = snap_radius() + viewport_error_[ib];
      reach = std::min(reach, rb * size(p - a) + ra * size(b - p) + 2 * ra * rb + vertex_shift * size(edge));
    }
    if (value < -reach) return {};
    if (value <= reach || facing_ == 0) {
      result.certainty = Coverage::Certainty::ambiguous;
      result.ambiguous_edges = static_cast<std::uint8_t>(result.ambiguous_edges | (1 << k));
    }
  }
  return result;
}

/// With h = 1 / w = sum l_i and clip coordinates c_i + d_i, and p counted from the middle of the window, the point that
/// has the weights l is moved by
///     (sum l_i d_i.xy - p sum l_i d_i.w) / (h + sum l_i d_i.w):
/// that of a corner near the eye plane by no more than others, however far it is in the window. The weights are those
/// of the point that is moved to p, which lies within the shift itself.
double DeviceTriangle::vertex_shift_at(double x, double y) const {
  const std::array<double, 3> weight = planes_.at(x, y);
  const double from_centre = std::max(std::abs(x - frame_.width() / 2.0), std::abs(y - frame_.height() / 2.0));
  double moved = 0, change = 0, w_moved = 0, h = 0, h_change = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double error = xy_error_[i] + from_centre * w_error_[i];
    const double slope = std::abs(planes_.l[i].x) + std::abs(planes_.l[i].y);
    moved += std::abs(weight[i]) * error, change += slope * error;
    w_moved += std::abs(weight[i]) * w_error_[i], h += weight[i], h_change += slope;
  }
  const auto shift_within = [&](double shift) {
    const double least = std::abs(h) - h_change * shift - w_moved - 2 * change;
    return least > 0 ? (moved + change * shift) / least : infinite;
  };
  const double first = shift_within(0);
  for (const double factor : {1.01, 1.1, 2.0})
    if (shift_within(first * factor) <= first * factor) return first * factor;
  return infinite;
}

double DeviceTriangle::reach_at(double x, double y) const {
  const std::array<double, 3> weight = planes_.at(x, y);
  double in_front = 0;
  for (std::size_t i = 0; i < 3; ++i) in_front += std::max(weight[i] * w_clip_[i], 0.0);
  const double viewport = viewport_roundings * u * std::max(frame_.width(), frame_.height()) / 2;
  return (snap_radius() + viewport) * std::max(in_front, 1.0) + vertex_shift_at(x, y);
}

/// With a corner behind the eye an edge is a ray, and what moves its other corner moves a point on it by as much as the
/// weights of the corners in front add up to. An edge that is cut at the border of the view is between points in front.
Coverage DeviceTriangle::coverage_by_weights(double x, double y) const {
  if (planes_.is_flat()) return {Coverage::Certainty::ambiguous, 7};
  const std::array<double, 3> value = planes_.at(x, y);
  const double reach = reach_at(x, y);
  if (!std::isfinite(reach)) return {Coverage::Certainty::ambiguous, 7};
  Coverage result{Coverage::Certainty::inside, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = reach * (std::abs(planes_.l[k].x) + std::abs(planes_.l[k].y));
    if (value[k] < -along) return {};
    if (value[k] <= along) {
      result.certainty = Coverage::Certainty::ambiguous;
      result.ambiguous_edges = static_cast<std::uint8_t>(result.ambiguous_edges | (1 << k));
    }
  }
  return result;
}

/// Over a triangle in front of the eye, the slope along x is the difference of two products, ((p0 - p1) (y2 - y0) - (p2
/// - p0) (y0 - y1)) / d with p = f / w, or, where planes start at a corner, a sum of the values' own: in needles each
/// is larger than what is left of them. So is the area d. A triangle that is cut becomes others, with corners in view.
DeviceTriangle::Plane DeviceTriangle::plane(const std::array<double, 3>& corner_values, double x, double y) const {
  Double3 sum(0);
  for (std::size_t i = 0; i < 3; ++i) sum += planes_.l[i] * corner_values[i];
  const double width = frame_.width(), height = frame_.height(), value = sum.x * x + sum.y * y + sum.z;
  double most = 0;
  // Slopes that are all off by one factor turn the plane about the corner at which it starts, whichever that is.
  double from_corner = 0;
  Double2 along(std::abs(sum.x), std::abs(sum.y));
  if (clipped_) { // a plane is largest at a corner of the view
    for (const double px : {0.0, width})
      for (const double py : {0.0, height}) most = std::max(most, std::abs(sum.x * px + sum.y * py + sum.z));
    from_corner = std::abs(value) + most;
  }
  if (in_front_) {
    std::array<double, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = corner_values[i] / w_clip_[i];
      if (!clipped_) most = std::max(most, std::abs(p[i])), from_corner = std::max(from_corner, std::abs(value - p[i]));
    }
    const Double2 whole = corner_[1] - corner_[0], other = corner_[2] - corner_[0];
    const double area = std::abs(whole.x * other.y - whole.y * other.x);
    along = Double2(0);
    Double2 of_values(0);
    for (std::size_t i = 0; i < 3; ++i) { // whichever corner a device begins with
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Double2 e1 = corner_[j] - corner_[i], e2 = corner_[k] - corner_[i], across = corner_[k] - corner_[j];
      const double d1 = std::abs(p[j] - p[i]), d2 = std::abs(p[k] - p[i]);
      along = {std::max(along.x, (d1 * std::abs(e2.y) + d2 * std::abs(e1.y)) / area),
               std::max(along.y, (d1 * std::abs(e2.x) + d2 * std::abs(e1.x)) / area)};
      of_values += Double2(std::abs(p[i] * across.y), std::abs(p[i] * across.x)) / area;
    }
    if (frame_.profile().interpolation.anchor == InterpolationAnchor::triangle) along = of_values;
  }
  return {value, sum.x, sum.y, plane_error(most, along, x, y) + area_error_at(x, y) * from_corner};
}

/// Off by so many units of the magnitudes that it is summed from, as InterpolationProfile says.
double DeviceTriangle::plane_error(double most, const Double2& along, double x, double y) const {
  const InterpolationProfile& interpolation = frame_.profile().interpolation;
  Double2 from(x, frame_.height() - y); // OpenGL's origin is the lower left corner
  if (interpolation.anchor == InterpolationAnchor::triangle) {
    from = Double2(0);
    for (const Double2& corner : corner_)
      from = {std::max(from.x, std::abs(x - corner.x)), std::max(from.y, std::abs(y - corner.y))};
    if (clipped_) from = {std::max(x, frame_.width() - x), std::max(y, frame_.height() - y)};
  }
  const double size = most + along.x * from.x + along.y * from.y;
  return std::max(interpolation.units * u * size, interpolation.relative * most);
}

ValueRange DeviceTriangle::depth(double x, double y) const {
  if (planes_.is_flat()) return {};
  const Plane z = plane(z_clip_, x, y);
  // A depth between the planes is at most 1, whatever its corners are.
  const double error_of_plane =
      clipped_ ? plane_error(1, {std::abs(z.along_x), std::abs(z.along_y)}, x, y) + 2 * area_error_at(x, y) : z.error;
  const double reach = in_front_ ? exact_reach_at(x, y) : reach_at(x, y);
  const std::array<double, 3> weight = planes_.at(x, y);
  double vertex_error = 0;
  for (std::size_t i = 0; i < 3; ++i) vertex_error += std::abs(weight[i]) * z_error_[i];
  const double error = vertex_error + error_of_plane + reach * (std::abs(z.along_x) + std::abs(z.along_y));
  const double quantum = frame_.profile().depth.format == DepthFormat::unorm16 ? 0x1p-16 : 0x1p-24;
  const double centre = 0.5 * z.value + 0.5, radius = 0.5 * error + quantum;
  if (!std::isfinite(centre + radius)) return {};
  return {centre - radius, centre + radius};
}

SampleShift DeviceTriangle::shift(double x, double y) const {
  SampleShift result;
  const RasterProfile& raster = frame_.profile().raster;
  if (!in_front_ || planes_.is_flat()) {
    const double ours = 0.5 / subpixels;
    const double both = reach_at(x, y) * (1 + ours / std::max(snap_radius(), ours));
    result.radius = Double2(both * subpixels);
    return result;
  }
  const bool same_lattice =
      raster.setup_positions == SetupPositions::snapped && raster.lattice * subpixels == 1 && raster.snap_steps <= 0.5;
  const double snap = raster.setup_positions == SetupPositions::exact ? 0 : snap_radius();
  // What the vertex stage loses moves samples near the point by no more than that; or corners. Where these are rounded
  // to the same places, their weights 1 / w still are not the same.
  const double vertex_shift = vertex_shift_at(x, y);
  const bool whole = std::isinf(vertex_shift);
  for (int axis = 0; axis < 2; ++axis) {
    std::array<ValueRange, 3> moved;
    for (std::size_t i = 0; i < 3; ++i) {
      const double error = whole ? corner_error_[i] : viewport_error_[i];
      moved[i] = {moved_[i][axis] - snap - error, moved_[i][axis] + snap + error};
      // A device that rounds to our lattice has our point, but where the exact one is nearly halfway between two.
      if (same_lattice && !clipped_) {
        const double half = 0.5 / subpixels;
        moved[i] = {moved_[i][axis] - corner_error_[i] < -half ? -1.0 / subpixels : 0,
                    moved_[i][axis] + corner_error_[i] > half ? 1.0 / subpixels : 0};
      }
    }
    // What moves the corners one way moves what a sample sees the other way.
    const ValueRange range = mean_of_corners(moved, x, y);
    result.centre[axis] = -(range.lo + range.hi) / 2 * subpixels;
    result.radius[axis] = ((range.hi - range.lo) / 2 + (whole ? 0 : vertex_shift)) * subpixels;
  }
  return result;
}

/// The matrix is 1 + sum of d_i (gradient of b_i) with d_i what corner i is moved by; the gradient of its weight b_i is
/// 1 over its altitude.
double DeviceTriangle::turned() const {
  if (planes_.is_flat()) return infinite;
  const double snap = frame_.profile().raster.setup_positions == SetupPositions::exact ? 0 : snap_radius();
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double gradient = std::hypot(planes_.l[i].x, planes_.l[i].y) * std::abs(w_clip_[i]);
    const double error = corner_error_[i];
    const Double2 moved(std::abs(moved_[i].x) + snap + error, std::abs(moved_[i].y) + snap + error);
    sum += std::hypot(moved.x, moved.y) * gradient;
  }
  return sum;
}

/// What is moved at the corners, at a point of the moved triangle: the mean by its weights there. They add up to 1, and
/// differ from those of the unmoved triangle by what these change over as far as a corner may be moved. Inside none is
/// negative, and the mean lies between the corners' ends; outside it may lie beyond.
ValueRange DeviceTriangle::mean_of_corners(const std::array<ValueRange, 3>& moved, double x, double y) const {
  const std::array<double, 3> weight = planes_.at(x, y);
  double farthest = 0, sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    farthest = std::max({farthest, std::abs(moved[i].lo), std::abs(moved[i].hi), snap_radius() + viewport_error_[i]});
    sum += std::abs(weight[i] * w_clip_[i]);
  }
  const bool inside = sum <= 1 + 0x1p-40;
  if (!inside) farthest *= 2 * sum; // where the weights of the moved triangle add up to more, too
  ValueRange mean{0, 0}, hull{infinite, -infinite};
  for (std::size_t i = 0; i < 3; ++i) {
    const double change = farthest * (std::abs(planes_.l[i].x) + std::abs(planes_.l[i].y)) * std::abs(w_clip_[i]);
    double low = weight[i] * w_clip_[i] - change, high = weight[i] * w_clip_[i] + change;
    if (inside) low = std::clamp(low, 0.0, 1.0), high = std::clamp(high, 0.0, 1.0);
    mean.lo += std::min(low * moved[i].lo, high * moved[i].lo);
    mean.hi += std::max(low * moved[i].hi, high * moved[i].hi);
    hull.lo = std::min(hull.lo, moved[i].lo), hull.hi = std::max(hull.hi, moved[i].hi);
  }
  if (!inside) return mean;
  return {std::max(mean.lo, hull.lo), std::min(mean.hi, hull.hi)};
}

double DeviceTriangle::exact_reach_at(double x, double y) const {
  std::array<ValueRange, 3> moved;
  const double vertex_shift = vertex_shift_at(x, y);
  const bool whole = std::isinf(vertex_shift);
  for (std::size_t i = 0; i < 3; ++i) {
    const double reach = snap_radius() + (whole ? corner_error_[i] : viewport_error_[i]);
    moved[i] = {-reach, reach};
  }
  const ValueRange range = mean_of_corners(moved, x, y);
  return std::max(-range.lo, range.hi) + (whole ? 0 : vertex_shift);
}

double DeviceTriangle::attribute_error(int row, double x, double y) const {
  if (planes_.is_flat()) return infinite;
  const Geometry& geometry = frame_.context().geometry;
  const Mesh& mesh = *frame_.scene().objects[ref_.object].mesh;
  const auto& indices = mesh.triangles[ref_.triangle];
  std::array<double, 3> value{};
  double corner_error = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const WorldVertex& world = geometry.world[ref_.vertex[i]];
    if (row < normal_row) {
      value[i] = world.position[row - position_row];
      corner_error = std::max(corner_error, frame_.world_error(ref_.object, row - position_row, mesh_position(i)));
    } else if (row < uv_row) {
      value[i] = world.normal[row - normal_row];
      corner_error =
          std::max(corner_error, frame_.normal_error(ref_.object, row - normal_row, mesh.normals[indices[i]]));
    } else if (row < uv_row + 2) {
      value[i] = static_cast<double>(mesh.uvs[indices[i]][row - uv_row]);
    }
  }
  if (row >= uv_row + 2)
    for_each_further_attribute(mesh, geometry.transforms[ref_.object], indices, [&](int first, const auto& corners) {
      const auto component = static_cast<std::size_t>(row - first);
      if (row < first || component >= corners[0].size()) return;
      for (std::size_t i = 0; i < 3; ++i) value[i] = corners[i][component];
    });
  if (row >= tangent_row && row < tangent_row + 3) // of further attributes those that a vertex stage changes
    for (const std::uint32_t vertex : indices)
      if (vertex < mesh.tangents.size())
        corner_error =
            std::max(corner_error, frame_.tangent_error(ref_.object, row - tangent_row, Float3(mesh.tangents[vertex])));
  const Plane g = plane(value, x, y), h = plane({1, 1, 1}, x, y);
  if (!(h.value > h.error)) return infinite;
  const double f = g.value / h.value;
  return (g.error + std::abs(f) * h.error) / (h.value - h.error) +
         quotient_roundings * 2 * frame_.profile().operations.relative * std::abs(f) + corner_error;
}

} // namespace refraster
