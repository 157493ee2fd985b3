#include "app/view/camera_motion.h"

#include "app/turntable/orbit.h"
#include "math/vec.h"
#include "raster/vertex/transform.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace refraster {
namespace {

/// At the poles there is no right and left.
constexpr double closest_to_up_degrees = 1;
constexpr double smallest_view_degrees = 1, largest_view_degrees = 170;
constexpr double narrower_a_notch = 0.95;
constexpr double halvings_a_second = 0.5, turn_degrees_a_second = 180;
/// As those of a fit (raster/vertex/scene_view.cpp): how far the planes lie from what they hold, and how near the near
/// one may come.
constexpr double plane_gap = 0.01, closest_plane = 0x1p-10;

double degrees_between(const Double3& a, const Double3& b) {
  const double cosine = dot(a, b) / (length(a) * length(b));
  return std::acos(std::clamp(cosine, -1.0, 1.0)) * (180 / std::numbers::pi);
}

/// A point turned around a centre about `up`, of length 1, and then up by so many degrees, as far as it goes.
Double3 swung(const Double3& point, const Double3& centre, const Double3& up, double around_degrees,
              double up_degrees) {
  const Double3 turned = rotated(point, centre, up, around_degrees), arm = turned - centre;
  const Double3 right = cross(arm, up);
  if (!(length(right) > 0)) return turned;
  const double now = degrees_between(arm, up);
  const double wanted = std::clamp(now - up_degrees, closest_to_up_degrees, 180 - closest_to_up_degrees);
  return rotated(turned, centre, normalize(right), now - wanted);
}

} // namespace

Ball ball_around(const Scene& scene) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Double3 least(infinity), most(-infinity);
  const auto for_each_point = [&](const auto& visit) {
    for (const Object& object : scene.objects) {
      const Double4x4 world = object_transform(object, Double4x4(1)).world_from_object;
      for (const Float3& position : object.mesh->positions) {
        const Double3 point(world * Double4(Double3(position), 1));
        if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) visit(point);
      }
    }
  };
  for_each_point([&](const Double3& point) { least = glm::min(least, point), most = glm::max(most, point); });
  if (!(least.x <= most.x)) return {}; // nothing to see
  Ball ball{least * 0.5 + most * 0.5, 0};
  for_each_point([&](const Double3& point) { ball.radius = std::max(ball.radius, length(point - ball.centre)); });
  return ball;
}

bool can_be_moved(const Camera& camera) {
  const double degrees = degrees_between(camera.target - camera.position, camera.up);
  return degrees >= closest_to_up_degrees && degrees <= 180 - closest_to_up_degrees;
}

Camera pushed(Camera camera, Motion motion, const Push& push, double seconds, const MotionRates& rates) {
  const Double3 arm = camera.position - camera.target, up = normalize(camera.up);
  if (motion == Motion::orbit) {
    camera.position = camera.target + arm * std::exp2(-push.forward * halvings_a_second * seconds);
    const double degrees = turn_degrees_a_second * seconds;
    camera.position = swung(camera.position, camera.target, up, push.right * degrees, push.up * degrees);
    return camera;
  }
  const Double3 ahead = normalize(-arm), right = normalize(cross(ahead, up));
  const Double3 step = (ahead * push.forward + right * push.right + up * push.up) * (rates.speed * seconds);
  camera.position += step, camera.target += step;
  return camera;
}

Camera dragged(Camera camera, Motion motion, double right_pixels, double down_pixels, const MotionRates& rates) {
  const Double3 up = normalize(camera.up);
  if (motion == Motion::orbit)
    camera.position =
        swung(camera.position, camera.target, up, -right_pixels * rates.turn_degrees, down_pixels * rates.turn_degrees);
  else
    camera.target = swung(camera.target, camera.position, up, -right_pixels * rates.look_degrees,
                          -down_pixels * rates.look_degrees);
  return camera;
}

Camera zoomed(Camera camera, double notches) {
  const double narrowed = camera.fov_y_degrees * std::pow(narrower_a_notch, notches);
  // A scene may have a wider or narrower one: it stays until it is changed to what is within.
  const double smallest = std::min(smallest_view_degrees, camera.fov_y_degrees);
  camera.fov_y_degrees = std::clamp(narrowed, smallest, std::max(largest_view_degrees, camera.fov_y_degrees));
  return camera;
}

void place_planes(Camera& camera, const Ball& ball) {
  const double depth = dot(ball.centre - camera.position, normalize(camera.target - camera.position));
  const double gap = ball.radius > 0 ? ball.radius : 1;
  camera.far = std::max((depth + ball.radius) * (1 + plane_gap), gap * plane_gap);
  camera.near = std::max((depth - ball.radius) * (1 - plane_gap), camera.far * closest_plane);
}

bool same_camera(const Camera& a, const Camera& b) {
  return a.position == b.position && a.target == b.target && a.up == b.up && a.fov_y_degrees == b.fov_y_degrees &&
         a.near == b.near && a.far == b.far;
}

} // namespace refraster
