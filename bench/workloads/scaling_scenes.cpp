#include "bench/workloads/scaling_scenes.h"

#include <refraster/mesh.h>

#include "bench/workloads/built_in.h"
#include "math/elementary/degrees.h"
#include "raster/vertex/subpixel.h"

#include <algorithm>
#include <cmath>

namespace refraster::bench {
namespace {

constexpr double sheet_distance = 4; // from the eye

/// A camera at the origin, and a light that every point before it sees.
Scene empty_scene() {
  Scene scene;
  scene.camera.fov_y_degrees = 60;
  scene.point_lights.push_back({.position = {1, 2, 3}, .radiance = Double3(1)});
  return scene;
}

/// A square at that distance, facing the eye, somewhat larger than any image sees of it.
Object sheet(std::shared_ptr<const Mesh> mesh, double distance, double aspect) {
  Object object;
  object.name = "sheet";
  object.mesh = std::move(mesh);
  object.position = {0, 0, -distance};
  object.rotate_degrees = {90, 0, 0};
  const double half = 1.01 * distance * tan_degrees(30) * std::max(aspect, 1.0);
  object.scale = {half, 1, half};
  Phong function;
  function.ka = Double3(0.05), function.kd = {0.7, 0.5, 0.3}, function.ks = Double3(0.4), function.glossiness = 20;
  object.material.fragment_function = function;
  return object;
}

double aspect_of(const ScalingPoint& point) {
  return static_cast<double>(point.width) / point.height;
}

int segments_for(double triangles) {
  return std::max(1, static_cast<int>(std::lround(std::sqrt(triangles / 2))));
}

Scene layers(const ScalingPoint& point) {
  Scene scene = empty_scene();
  const auto square = std::make_shared<Mesh>(plane_mesh(1));
  const int count = static_cast<int>(point.n);
  for (int i = 0; i < count; ++i) {
    const int place = point.order == LayerOrder::front_to_back ? i : count - 1 - i;
    scene.objects.push_back(sheet(square, sheet_distance + 0.1 * place, aspect_of(point)));
  }
  return scene;
}

/// Lights on a circle above the sphere, together as bright as one.
Scene ring_of_lights(int count) {
  Scene scene = built_in_scene();
  PointLight light = scene.point_lights.front();
  light.radiance = light.radiance * (1.0 / count);
  scene.point_lights.clear();
  for (int i = 0; i < count; ++i) {
    const double degrees = 360.0 * i / count;
    light.position = {2 * cos_degrees(degrees), 2 * sin_degrees(degrees), 2.5};
    scene.point_lights.push_back(light);
  }
  return scene;
}

/// 1, 2, 4 … up to the least of `most` and `end`.
std::vector<double> doublings(double most, double end) {
  std::vector<double> counts;
  for (double n = 1; n == 1 || n <= std::min(most, end); n *= 2) counts.push_back(n);
  return counts;
}

} // namespace

std::string_view name_of(Growth growth) {
  for (const auto& [value, name] : growth_names)
    if (value == growth) return name;
  return {};
}

std::vector<ScalingPoint> scaling_points(Growth growth, double most, const ImageSize& size, int threads, int cpus) {
  std::vector<ScalingPoint> points;
  const auto add = [&](double n) { points.push_back({n, size.width, size.height, threads}); };
  switch (growth) {
  case Growth::triangles:
    for (int step = 0; step <= 8; ++step) { // 1e3 to 1e7, two a decade
      const int segments = segments_for(std::pow(10, 3 + 0.5 * step));
      const double triangles = 2.0 * segments * segments;
      if (step == 0 || triangles <= most) add(triangles);
    }
    break;
  case Growth::pixels:
    for (int step = 0; step <= 9; ++step) { // 100^2 to 16384^2, two a decade
      const int side = step == 9 ? max_image_side : static_cast<int>(std::lround(std::pow(10, 2 + 0.25 * step)));
      const double pixels = static_cast<double>(side) * side;
      if (step == 0 || pixels <= most) points.push_back({pixels, side, side, threads});
    }
    break;
  case Growth::lights:
    for (const double n : doublings(most, 256)) add(n);
    break;
  case Growth::overdraw:
    for (const double n : doublings(most, 64)) add(n);
    break;
  case Growth::threads:
    for (int n = 1; n == 1 || (n <= cpus && n <= most); ++n) points.push_back({double(n), size.width, size.height, n});
    break;
  }
  return points;
}

Scene scaling_scene(Growth growth, const ScalingPoint& point) {
  switch (growth) {
  case Growth::triangles: {
    Scene scene = empty_scene();
    const auto mesh = std::make_shared<Mesh>(plane_mesh(segments_for(point.n)));
    scene.objects.push_back(sheet(mesh, sheet_distance, aspect_of(point)));
    return scene;
  }
  case Growth::lights:
    return ring_of_lights(static_cast<int>(point.n));
  case Growth::overdraw:
    return layers(point);
  case Growth::pixels:
  case Growth::threads:
    return built_in_scene();
  }
  return {};
}

} // namespace refraster::bench
