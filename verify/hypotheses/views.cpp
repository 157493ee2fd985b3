#include "verify/hypotheses/views.h"

#include "math/constants.h"
#include "raster/samples.h"

#include <cmath>

namespace refraster::hypotheses {
namespace {

constexpr double degrees_per_radian = constants::degrees_per_radian.nearest;

/// Half the height of the image in the plane at distance 1. Negative: the image is turned round.
double half_height(View view, const Scene& scene, const ImageKind& image) {
  const double degrees = scene.camera.fov_y_degrees, right = std::tan(degrees / 2 / degrees_per_radian);
  switch (view) {
  case View::fov_in_radians:
    return std::tan(degrees / 2);
  case View::fov_horizontal:
    return right * image.height / image.width;
  case View::fov_half:
    return std::tan(degrees / 4 / degrees_per_radian);
  case View::fov_twice:
    return std::tan(degrees / degrees_per_radian);
  default:
    return right;
  }
}

/// Where the centre of pixel (x, y) of the image is taken from, in pixels of an image of the same size.
struct Place {
  double x = 0, y = 0;
};
Place centre_of(View view, const ImageKind& image, const ImageShift& shift, int x, int y) {
  const Place centre{x + 0.5, y + 0.5};
  switch (view) {
  // What is moved to the left shows what lies to the right.
  case View::half_pixel_left_up:
    return {centre.x + 0.5, centre.y + 0.5};
  case View::half_pixel_left_down:
    return {centre.x + 0.5, centre.y - 0.5};
  case View::half_pixel_right_up:
    return {centre.x - 0.5, centre.y + 0.5};
  case View::half_pixel_right_down:
    return {centre.x - 0.5, centre.y - 0.5};
  case View::upside_down:
    return {centre.x, image.height - centre.y};
  case View::mirrored:
    return {image.width - centre.x, centre.y};
  case View::shifted:
    return {centre.x - shift.x, centre.y - shift.y};
  case View::half_size:
    return {x / 2 * 2 + 1.0, y / 2 * 2 + 1.0};
  case View::every_second_pixel:
    return {x / 2 * 2 + 0.5, y / 2 * 2 + 0.5};
  default:
    return centre;
  }
}

} // namespace

bool Projection::operator==(const Projection& other) const {
  const Camera &a = camera, &b = other.camera;
  return width == other.width && height == other.height && a.position == b.position && a.target == b.target &&
         a.up == b.up && a.fov_y_degrees == b.fov_y_degrees && a.near == b.near && a.far == b.far;
}

Projection projection_of(View view, const Scene& scene, const ImageKind& image) {
  Projection result{scene.camera, image.width, image.height};
  const double half = half_height(view, scene, image);
  if (half != half_height(View::right, scene, image)) {
    // Within what a camera may have; beyond it, nothing like the image is seen.
    const double angle = 2 * std::atan(std::abs(half)) * degrees_per_radian;
    result.camera.fov_y_degrees = std::min(std::max(angle, 1e-6), 180 - 1e-6);
  }
  // An image of another shape, which is then stretched to this one.
  if (view == View::aspect_one) result.width = image.height;
  if (view == View::aspect_inverted) result.width = image.height, result.height = image.width;
  return result;
}

std::vector<Tap> taps_of(View view, const Scene& scene, const ImageKind& image, const ImageShift& shift, int x, int y) {
  const Projection projection = projection_of(view, scene, image);
  const double scale_x = static_cast<double>(projection.width) / image.width,
               scale_y = static_cast<double>(projection.height) / image.height;
  const bool turned = half_height(view, scene, image) < 0;
  const Place centre = centre_of(view, image, shift, x, y);
  // dx and dy from the centre, in subpixels.
  const auto tap = [&](double dx, double dy, double shaded_dx, double shaded_dy) {
    const auto place = [&](double at, double offset, double scale, int side) {
      const double there = (at * subpixels + offset) * scale;
      return turned ? side * double{subpixels} - there : there;
    };
    Tap result;
    result.seen.x = static_cast<std::int32_t>(std::nearbyint(place(centre.x, dx, scale_x, projection.width)));
    result.seen.y = static_cast<std::int32_t>(std::nearbyint(place(centre.y, dy, scale_y, projection.height)));
    result.shaded_x = place(centre.x, shaded_dx, scale_x, projection.width);
    result.shaded_y = place(centre.y, shaded_dy, scale_y, projection.height);
    return result;
  };
  constexpr double quarter = subpixels / 4.0, half = subpixels / 2.0;
  if (view == View::double_size)
    return {tap(-quarter, -quarter, -quarter, -quarter), tap(quarter, -quarter, quarter, -quarter),
            tap(-quarter, quarter, -quarter, quarter), tap(quarter, quarter, quarter, quarter)};
  std::vector<Tap> taps;
  for (const SamplePosition& sample : sample_pattern(image.samples))
    taps.push_back(tap(sample.x - half, sample.y - half, 0, 0));
  return taps;
}

} // namespace refraster::hypotheses
