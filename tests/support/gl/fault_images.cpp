#include "tests/support/gl/fault_images.h"

#include "gl/render_gl.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/gl/device_images.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

constexpr int shown_pixels = 10;

Image<float> drawn(const Scene& scene) {
  GlOptions options;
  options.width = fault_image_size.width, options.height = fault_image_size.height;
  options.renderer = GlRenderer::llvmpipe;
  options.want_rgb8 = false, options.want_radiance = true;
  return render_gl(scene, options).radiance;
}

/// Pixels that differ by more than a level.
int different(const Image<float>& a, const Image<float>& b) {
  int count = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      bool differs = false;
      for (int c = 0; c < 3; ++c) differs |= !(std::abs(a.at(x, y)[c] - b.at(x, y)[c]) <= 1.0f / 255);
      count += differs;
    }
  return count;
}

} // namespace

std::vector<Image<float>> right_fault_images() {
  std::vector<Image<float>> right;
  for (const FaultScene& place : fault_scenes()) right.push_back(drawn(place.scene));
  return right;
}

std::optional<ShownFault> shown_fault(const SeededFault& fault, const std::vector<Image<float>>& right) {
  for (std::size_t i = 0; i < fault_scenes().size(); ++i) {
    const test::TemporaryFolder folder;
    const std::optional<Scene> scene = with_fault(fault_scenes()[i].scene, fault, fault_image_size, folder.path);
    if (!scene) continue;
    ShownFault shown{i, fault.image ? fault.image(right[i]) : drawn(*scene)};
    if (different(right[i], shown.image) >= shown_pixels) return shown;
  }
  return std::nullopt;
}

DeviceImage stored_image(const Image<float>& radiance, StoredAs as) {
  DeviceImage image;
  image.colour = radiance;
  image.full_scale = 1, image.precision = StoredPrecision::floats(float_rounding);
  if (as == StoredAs::floats) return image;
  for (float& value : image.colour.values)
    value = static_cast<float>(std::nearbyint(255 * std::clamp(static_cast<double>(value), 0.0, 1.0)));
  image.full_scale = 255, image.precision = StoredPrecision::integers(255);
  return image;
}

} // namespace refraster
