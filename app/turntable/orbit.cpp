#include "app/turntable/orbit.h"

#include "math/elementary.h"
#include "math/vec.h"

namespace refraster {

std::vector<Camera> orbit(const Camera& start, int frames) {
  const Double3 axis = normalize(start.up), arm = start.position - start.target;
  const Double3 along = axis * dot(axis, arm), across = arm - along, side = cross(axis, arm);
  std::vector<Camera> cameras(static_cast<std::size_t>(frames), start); // the first as it is, bit for bit
  for (int i = 1; i < frames; ++i) {
    const double degrees = 360.0 * i / frames;
    // Rodrigues' rotation of the arm about the axis.
    cameras[static_cast<std::size_t>(i)].position =
        start.target + along + across * cos_degrees(degrees) + side * sin_degrees(degrees);
  }
  return cameras;
}

} // namespace refraster
