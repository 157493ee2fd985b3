#include "raster/vertex/scene_view.h"

#include "math/elementary.h"
#include "raster/vertex/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace refraster {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is nearer than this part of the extent would fill the image with a single corner of the model. It also bounds
/// far / near by 11 for what is as deep as it is wide, of which 24 bits of depth make nothing coarse.
constexpr double nearest_part = 0.1;
/// Distances below this part of the coordinates keep fewer than 22 of the 52 bits of a double.
constexpr double lost_part = 0x1p-30;
/// How far the planes lie from the vertices, of their distance: farther than rounding moves them, also in float.
constexpr double plane_gap = 0.01;
/// Of the far plane's distance, where vertices are as near as may be: what a depth buffer of 24 bits still resolves to
/// a part in 2^14 of the farthest distance.
constexpr double closest_plane = 0x1p-10;
/// Products of two distances stay finite. Floats end at 2^128.
constexpr double farthest = 0x1p500;

/// Of the camera: to the right, up, and toward the viewer. Each of length 1 and across the others.
using Axes = std::array<Double3, 3>;

/// The front, to the right and above of a scene whose vector up is `up`: what the shortest rotation that takes +y there
/// makes of z, x and y. With +z up the front is -y; with -y up it is -z.
Axes axes_of_up(const Double3& up) {
  const Double3 y = normalize(up);
  const double sine_squared = y.x * y.x + y.z * y.z;
  if (y.y < 0 && sine_squared == 0) return {Double3(1, 0, 0), y, Double3(0, 0, -1)}; // any half turn would do
  // Rodrigues' formula for the axis (0, 1, 0) x y, written out. f is 1 / (1 + cosine), and for a cosine near -1 the
  // same without cancellation.
  const double f = y.y < 0 ? (1 - y.y) / sine_squared : 1 / (1 + y.y);
  return {Double3(1 - y.x * y.x * f, -y.x, -y.x * y.z * f), y, Double3(-y.x * y.z * f, -y.z, 1 - y.z * y.z * f)};
}

Axes axes_of(const Double3& up_of_camera, const CameraFit& fit) {
  const auto [right, up, front] = axes_of_up(up_of_camera);
  const double ca = cos_degrees(fit.azimuth_degrees), sa = sin_degrees(fit.azimuth_degrees);
  const double ce = cos_degrees(fit.elevation_degrees), se = sin_degrees(fit.elevation_degrees);
  const Double3 sideways = right * ca - front * sa, outward = right * sa + front * ca;
  return {sideways, up * ce - outward * se, up * se + outward * ce};
}

/// Least and greatest of some numbers.
struct Span {
  double least = infinity, most = -infinity;
  void add(double x) { least = std::min(least, x), most = std::max(most, x); }
  double size() const { return most - least; }
  double middle() const { return least * 0.5 + most * 0.5; }
};

/// Along an axis a across the view: the greatest a + k d and -a + k d of all points, and the depths d where they are.
struct Support {
  double k = 0;
  double above = -infinity, below = -infinity;
  double depth_above = 0, depth_below = 0;

  explicit Support(double slope) : k(slope) {}
  void add(double a, double d) {
    const double kd = k * d;
    if (a + kd > above) above = a + kd, depth_above = d;
    if (kd - a > below) below = kd - a, depth_below = d;
  }
  double centre() const { return (above - below) * 0.5; }
  /// Where the eye must stand for all points to lie within the slopes k, wherever the centre is.
  double eye() const { return (above + below) * 0.5 / k; }
};

/// All vertices of a scene, along the camera's axes.
class Points {
public:
  Points(const Scene& scene, const Axes& axes) {
    for (const Object& object : scene.objects) {
      const Double4x4 world = object_transform(object, Double4x4(1)).world_from_object;
      Part part{object.mesh.get(), {}};
      for (std::size_t row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) part.rows[row][column] = dot(axes[row], Double3(world[column]));
      parts_.push_back(part);
    }
  }
  /// visit(right, up, depth); depths grow toward the viewer.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const Part& part : parts_)
      for (const Float3& position : part.mesh->positions) {
        const Double3 p(position);
        const auto along = [&](std::size_t i) {
          const Double4& row = part.rows[i];
          return row.x * p.x + row.y * p.y + (row.z * p.z + row.w);
        };
        const double x = along(0), y = along(1), depth = along(2);
        if (std::isfinite(x) && std::isfinite(y) && std::isfinite(depth)) visit(x, y, depth);
      }
  }

private:
  struct Part {
    const Mesh* mesh;
    std::array<Double4, 3> rows;
  };
  std::vector<Part> parts_;
};

/// Where the middle of the image lies, seen from `eye`: so that the greatest slope to the one side is that to the
/// other. The least k with half the width of the points, along lines of slope k, at most k times the eye's distance is
/// a root of a convex, falling and piecewise linear function, so Newton's method from 0 ends at it after finitely many
/// steps: a few.
std::array<double, 2> centre_from(const Points& points, double eye) {
  std::array<Support, 2> found{Support(0), Support(0)};
  std::array<double, 2> k{};
  constexpr int max_steps = 64;
  for (int step = 0; step < max_steps; ++step) {
    found = {Support(k[0]), Support(k[1])};
    points.for_each([&](double x, double y, double depth) { found[0].add(x, depth), found[1].add(y, depth); });
    bool moved = false;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Support& at = found[axis];
      const double excess = (at.above + at.below) * 0.5 - at.k * eye;
      const double distance = eye - (at.depth_above * 0.5 + at.depth_below * 0.5);
      const double next = at.k + excess / distance;
      if (!(next > at.k)) continue;
      k[axis] = next, moved = true;
    }
    if (!moved) break;
  }
  return {found[0].centre(), found[1].centre()};
}

void place_camera(const Scene& scene, const CameraFit& fit, double aspect, Camera& camera) {
  const Axes axes = axes_of(camera.up, fit);
  const Points points(scene, axes);
  const double ky = tan_degrees(camera.fov_y_degrees / 2) * (1 - 2 * fit.margin), kx = ky * aspect;

  Span across, upward, depth;
  Support tight_x(kx), tight_y(ky);
  points.for_each([&](double x, double y, double d) {
    across.add(x), upward.add(y), depth.add(d);
    tight_x.add(x, d), tight_y.add(y, d);
  });
  if (!(depth.least <= depth.most)) across.add(0), upward.add(0), depth.add(0); // nothing to see
  const double extent = std::max({across.size(), upward.size(), depth.size()});
  const double greatest = std::max({std::abs(across.least), std::abs(across.most), std::abs(upward.least),
                                    std::abs(upward.most), std::abs(depth.least), std::abs(depth.most)});
  const double gap = std::max(extent > 0 ? extent * nearest_part : 1, greatest * lost_part);

  Double3 middle(across.middle(), upward.middle(), depth.middle()); // of the image, along the axes
  double eye = depth.most + gap;
  if (fit.target) {
    middle = {dot(axes[0], *fit.target), dot(axes[1], *fit.target), dot(axes[2], *fit.target)};
    eye = std::max(eye, middle.z + gap);
    points.for_each([&](double x, double y, double d) {
      eye = std::max(eye, std::max(std::abs(x - middle.x) / kx, std::abs(y - middle.y) / ky) + d);
    });
  } else if (extent > 0) {
    eye = std::max({eye, tight_x.eye(), tight_y.eye()});
    const auto [x, y] = centre_from(points, eye);
    middle.x = x, middle.y = y;
  }
  if (fit.distance) eye = middle.z + *fit.distance;
  eye = std::clamp(eye, -farthest, farthest);

  camera.target = axes[0] * middle.x + axes[1] * middle.y + axes[2] * middle.z;
  camera.position = axes[0] * middle.x + axes[1] * middle.y + axes[2] * eye;
  camera.up = axes[1];
  // A distance that was asked for may bring vertices behind the eye, or all of them.
  const double behind_all = std::max((eye - depth.least) * (1 + plane_gap), gap);
  const double before_all = std::max((eye - depth.most) * (1 - plane_gap), behind_all * closest_plane);
  constexpr double smallest = std::numeric_limits<double>::min();
  camera.near = fit.near.value_or(std::max(smallest, fit.far ? std::min(before_all, *fit.far / 2) : before_all));
  camera.far = fit.far.value_or(behind_all > camera.near ? behind_all : 2 * camera.near);
}

} // namespace

void place(Scene& scene, const SceneView& view, int width, int height) {
  if (view.fit) place_camera(scene, *view.fit, static_cast<double>(width) / height, scene.camera);
  const Double4x4 axes = view_from_world(scene.camera);
  const auto to_world = [&](const Double3& v) { // by the transposed rotation
    return Double3(dot(Double3(axes[0]), v), dot(Double3(axes[1]), v), dot(Double3(axes[2]), v));
  };
  for (const std::size_t i : view.moving_point_lights)
    scene.point_lights[i].position = scene.camera.position + to_world(scene.point_lights[i].position);
  for (const std::size_t i : view.moving_direction_lights)
    scene.direction_lights[i].direction = to_world(scene.direction_lights[i].direction);
}

} // namespace refraster
