#include "app/turntable/orbit.h"

#include "math/elementary.h"
#include "math/vec.h"

#include <algorithm>

namespace refraster {

Double3 rotated(const Double3& point, const Double3& centre, const Double3& axis, double degrees) {
  const Double3 arm = point - centre;
  const Double3 along = axis * dot(axis, arm), across = arm - along, side = cross(axis, arm);
  return centre + along + across * cos_degrees(degrees) + side * sin_degrees(degrees); // Rodrigues' rotation
}

std::vector<Camera> orbit(const Camera& start, int frames) {
  const Double3 axis = normalize(start.up);
  std::vector<Camera> cameras(static_cast<std::size_t>(frames), start); // the first as it is, bit for bit
  for (int i = 1; i < frames; ++i)
    cameras[static_cast<std::size_t>(i)].position = rotated(start.position, start.target, axis, 360.0 * i / frames);
  return cameras;
}

std::vector<Camera> fitted_orbit(const SceneSource& source, int width, int height, int frames) {
  Scene scene = source.scene;
  SceneView view = source.view;
  CameraFit& fit = view.fit.value();
  const double start = fit.azimuth_degrees;
  // Of a frame by itself, or of the fit as it is then.
  const auto camera_of = [&](int frame) {
    fit.azimuth_degrees = start + 360.0 * frame / frames;
    scene.camera = source.scene.camera;
    place(scene, view, width, height);
    return scene.camera;
  };
  fit.target = camera_of(0).target;
  double distance = 0;
  for (int i = 0; i < frames; ++i) {
    const Camera camera = camera_of(i);
    distance = std::max(distance, length(camera.position - camera.target));
  }
  fit.distance = distance;
  std::vector<Camera> cameras;
  for (int i = 0; i < frames; ++i) cameras.push_back(camera_of(i));
  return cameras;
}

} // namespace refraster
