#include "verify/bounds/device_triangle.h"

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

double DeviceTriangle::snap_radius() const {
  const RasterProfile& raster = frame_.profile().raster;
  return raster.lattice * raster.snap_steps;
}

void DeviceTriangle::place_corners() {
  const Geometry& geometry = frame_.context().geometry;
  const double width = frame_.width(), height = frame_.height(), half = std::max(width, height) / 2;
  std::array<Double3, 3> homogeneous;
  std::uint8_t all = 0xff, any = 0;
  in_front_ = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const WindowVertex v = geometry.window[ref_.vertex[i]];
    all &= v.outcode, any |= v.outcode;
    if (v.outcode & outcode::not_finite) return;
    const Float3& p = mesh_position(i);
    const Double4 clip = clip_position(geometry.transforms[ref_.object], p);
    homogeneous[i] = {(clip.x + clip.w) / 2 * width, (clip.w - clip.y) / 2 * height, clip.w};
    z_clip_[i] = clip.z, w_clip_[i] = clip.w;
    const double x = frame_.clip_error(ref_.object, 0, p), y = frame_.clip_error(ref_.object, 1, p),
                 z = frame_.clip_error(ref_.object, 2, p), w = frame_.clip_error(ref_.object, 3, p);
    const double xy = half * (std::max(x, y) + w) + viewport_roundings * u * half * std::abs(clip.w);
    xy_error_ = std::max(xy_error_, xy), z_error_ = std::max(z_error_, z), w_error_ = std::max(w_error_, w);
    if (!(clip.w > w)) {
      in_front_ = false;
      continue;
    }
    corner_[i] = Double2(homogeneous[i].x, homogeneous[i].y) / clip.w;
    const double far = std::max(std::abs(corner_[i].x), std::abs(corner_[i].y));
    corner_error_[i] = (xy + far * w) / (clip.w - w);
    if (!(v.outcode & outcode::unsnapped)) moved_[i] = corner_[i] - Double2(v.x, v.y) / double{subpixels};
  }
  // Wholly outside of one side of the view, by more than any rounding moves it: the sides and, of three corners in
  // front, nothing else. Depth is judged where it is asked for.
  seen_ = w_clip_[0] > -w_error_ || w_clip_[1] > -w_error_ || w_clip_[2] > -w_error_;
  if (!seen_) return;
  clipped_ = any != 0;
  planes_ = WindowTriangle(homogeneous);
  PixelRect& box = pixels_;
  box = {0, 0, frame_.width(), frame_.height()};
  if (in_front_) {
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
    const double may_differ =
        reach_ * (std::abs(e1.x) + std::abs(e1.y) + std::abs(e2.x) + std::abs(e2.y)) * 2 + 8 * reach_ * reach_;
    facing_ = area > may_differ ? -1 : area < -may_differ ? 1 : 0;
  } else {
    // The sign of the homogeneous determinant is that of the area of what lies in front. A double's roundings in it are
    // below 2^-50 of the sizes it is made from; those of float coordinates matter.
    double size = 0;
    for (std::size_t i = 0; i < 3; ++i)
      size += (std::abs(homogeneous[i].x) + std::abs(homogeneous[i].y)) * std::abs(w_clip_[(i + 1) % 3]);
    const double error = (xy_error_ + snap_radius() * std::max({w_clip_[0], w_clip_[1], w_clip_[2], 0.0}) + w_error_) *
                         size * 3 / std::max(half, 1.0);
    facing_ = planes_.determinant > error ? -1 : planes_.determinant < -error ? 1 : 0;
  }
}

Coverage DeviceTriangle::coverage(double x, double y) const {
  if (!seen_) return {};
  return in_front_ ? coverage_in_front(x, y) : coverage_by_weights(x, y);
}

/// Wherever the corners are within their reach r, the triangle lies within its Minkowski sum with a square of side 2 r,
/// and holds what is farther than r from every edge, and 2 r^2 of an edge's value for the ends of the edge.
Coverage DeviceTriangle::coverage_in_front(double x, double y) const {
  const auto [low_x, high_x] = std::minmax({corner_[0].x, corner_[1].x, corner_[2].x});
  const auto [low_y, high_y] = std::minmax({corner_[0].y, corner_[1].y, corner_[2].y});
  if (x < low_x - reach_ || x > high_x + reach_ || y < low_y - reach_ || y > high_y + reach_) return {};
  const Double2 e1 = corner_[1] - corner_[0], e2 = corner_[2] - corner_[0];
  const double sign = e1.x * e2.y - e1.y * e2.x < 0 ? -1 : 1;
  Coverage result{Coverage::Certainty::inside, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Double2 &a = corner_[(k + 1) % 3], &b = corner_[(k + 2) % 3];
    const Double2 edge = b - a;
    const double value = sign * (edge.x * (y - a.y) - edge.y * (x - a.x));
    const double reach = reach_ * (std::abs(edge.x) + std::abs(edge.y)) + 2 * reach_ * reach_;
    if (value < -reach) return {};
    if (value <= reach) {
      result.certainty = Coverage::Certainty::ambiguous;
      result.ambiguous_edges = static_cast<std::uint8_t>(result.ambiguous_edges | (1 << k));
    }
  }
  return result;
}

double DeviceTriangle::reach_at(double x, double y) const {
  const std::array<double, 3> weight = planes_.at(x, y);
  double in_front = 0;
  for (std::size_t i = 0; i < 3; ++i) in_front += std::max(weight[i] * w_clip_[i], 0.0);
  const double inverse_w = std::abs(weight[0]) + std::abs(weight[1]) + std::abs(weight[2]);
  return snap_radius() * std::max(in_front, 1.0) + (xy_error_ + std::max(x, y) * w_error_) * inverse_w;
}

/// With a corner behind the eye an edge is a ray, and what moves its other corner moves a point on it by as much as the
/// weights of the corners in front add up to. An edge that is cut at the border of the view is between points in front.
Coverage DeviceTriangle::coverage_by_weights(double x, double y) const {
  if (planes_.is_flat()) return {Coverage::Certainty::ambiguous, 7};
  const std::array<double, 3> value = planes_.at(x, y);
  const double reach = reach_at(x, y);
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
/// - p0) (y0 - y1)) / d with p = f / w: in needles each is larger than what is left of them. A triangle that is cut
/// becomes others, with corners in view.
DeviceTriangle::Plane DeviceTriangle::plane(const std::array<double, 3>& corner_values, double x, double y) const {
  Double3 sum(0);
  for (std::size_t i = 0; i < 3; ++i) sum += planes_.l[i] * corner_values[i];
  const double width = frame_.width(), height = frame_.height();
  double most = 0;
  Double2 along(std::abs(sum.x), std::abs(sum.y));
  if (clipped_) { // a plane is largest at a corner of the view
    for (const double px : {0.0, width})
      for (const double py : {0.0, height}) most = std::max(most, std::abs(sum.x * px + sum.y * py + sum.z));
  }
  if (in_front_) {
    std::array<double, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) {
      p[i] = corner_values[i] / w_clip_[i];
      if (!clipped_) most = std::max(most, std::abs(p[i]));
    }
    const Double2 e1 = corner_[1] - corner_[0], e2 = corner_[2] - corner_[0];
    const double area = std::abs(e1.x * e2.y - e1.y * e2.x);
    const double d1 = std::abs(p[0] - p[1]), d2 = std::abs(p[2] - p[0]);
    along = Double2(d1 * std::abs(e2.y) + d2 * std::abs(e1.y), d1 * std::abs(e2.x) + d2 * std::abs(e1.x)) / area;
  }
  return {sum.x * x + sum.y * y + sum.z, sum.x, sum.y, plane_error(most, along, x, y)};
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
  const Plane z = plane(z_clip_, x, y), h = plane({1, 1, 1}, x, y);
  const double inverse_w = std::abs(h.value);
  // A depth between the planes is at most 1, whatever its corners are.
  const double error_of_plane = clipped_ ? plane_error(1, {std::abs(z.along_x), std::abs(z.along_y)}, x, y) : z.error;
  const double reach = in_front_ ? reach_ : reach_at(x, y);
  const double error = (z_error_ + w_error_ * std::max(1.0, std::abs(z.value))) * inverse_w + error_of_plane +
                       reach * (std::abs(z.along_x) + std::abs(z.along_y));
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
  // Weights of the corners on the screen add up to 1, and none is negative inside: the shift is a mean of the corners'.
  const bool same_lattice =
      raster.setup_positions == SetupPositions::snapped && raster.lattice * subpixels == 1 && raster.snap_steps <= 0.5;
  const double snap = raster.setup_positions == SetupPositions::exact ? 0 : snap_radius();
  const std::array<double, 3> weight = planes_.at(x, y);
  const double outside =
      std::max(std::abs(weight[0] * w_clip_[0]) + std::abs(weight[1] * w_clip_[1]) + std::abs(weight[2] * w_clip_[2]),
               1.0); // above 1 where the point is outside
  for (int axis = 0; axis < 2; ++axis) {
    double low = infinite, high = -infinite;
    for (std::size_t i = 0; i < 3; ++i) {
      double from = moved_[i][axis] - snap - corner_error_[i], to = moved_[i][axis] + snap + corner_error_[i];
      // A device that rounds to our lattice has our point, but where the exact one is nearly halfway between two.
      if (same_lattice && !clipped_) {
        const double half = 0.5 / subpixels;
        from = moved_[i][axis] - corner_error_[i] < -half ? -1.0 / subpixels : 0;
        to = moved_[i][axis] + corner_error_[i] > half ? 1.0 / subpixels : 0;
      }
      low = std::min(low, from), high = std::max(high, to);
    }
    // What moves the corners one way moves what a sample sees the other way.
    result.centre[axis] = -(low + high) / 2 * subpixels;
    result.radius[axis] = (high - low) / 2 * subpixels;
    if (outside > 1) { // a mean no more
      const double most = std::max(std::abs(low), std::abs(high)) * outside * subpixels;
      result.centre[axis] = 0, result.radius[axis] = most;
    }
  }
  return result;
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
    } else {
      value[i] = static_cast<double>(mesh.uvs[indices[i]][row - uv_row]);
    }
  }
  const Plane g = plane(value, x, y), h = plane({1, 1, 1}, x, y);
  if (!(h.value > h.error)) return infinite;
  const double f = g.value / h.value;
  return (g.error + std::abs(f) * h.error) / (h.value - h.error) +
         quotient_roundings * 2 * frame_.profile().operations.relative * std::abs(f) + corner_error;
}

} // namespace refraster
