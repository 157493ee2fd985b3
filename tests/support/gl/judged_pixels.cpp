#include "tests/support/gl/judged_pixels.h"

#include "tests/support/gl/colour_bound.h"
#include "verify/hypotheses/pixel_colours.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace refraster {
namespace {

using namespace hypotheses;

/// llvmpipe as tests/support/gl/colour_bound.h describes it.
DeviceProfile llvmpipe_profile(const DriverTolerances& tolerances) {
  DeviceProfile profile;
  profile.raster.lattice = tolerances.lattice;
  profile.texture.filter_error = tolerances.texel_error;
  profile.texture.mip_error = 0; // counted in the filter's
  profile.texture.detail_below = tolerances.detail_below, profile.texture.detail_above = tolerances.detail_above;
  return profile;
}

Double3 values_of(const Image<float>& image, int x, int y) {
  const float* const at = image.at(x, y);
  return {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
}

/// At most so many, which ones is chance.
void cut(std::vector<JudgedPixel>& pixels, std::mt19937_64& random) {
  std::shuffle(pixels.begin(), pixels.end(), random);
  if (pixels.size() > max_judged_pixels) pixels.resize(max_judged_pixels);
}

} // namespace

Image<float> stored(const Image<float>& radiance, StoredAs as) {
  if (as == StoredAs::floats) return radiance;
  Image<float> result = radiance;
  for (float& value : result.values) {
    const double x = std::clamp(static_cast<double>(value), 0.0, 1.0);
    value = static_cast<float>(std::nearbyint(255 * x) / 255);
  }
  return result;
}

PixelJudge::PixelJudge(const Scene& scene, int width, int height) : scene_(scene), width_(width), height_(height) {
  RenderOptions options;
  options.width = width, options.height = height;
  options.want_rgb8 = false, options.want_radiance_double = true;
  options.aovs = {Aov::object, Aov::triangle};
  const Frame right = render(scene, options);
  const ColourBound bound(scene, width, height, driver_profiles[0].tolerances);
  constexpr WindowPoint beside[] = {{0, 0}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
  std::vector<WindowPoint> points;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const WindowPoint& moved : beside)
        points.push_back({x * subpixels + subpixels / 2 + moved.x, y * subpixels + subpixels / 2 + moved.y});
  const auto covering = WindowGeometry(scene, width, height, 0).covering(points);
  auto next = covering.begin();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      bool edge = false;
      const std::optional<Covering> first = seen_of(*next, scene, {});
      for (std::size_t i = 0; i < std::size(beside); ++i, ++next) {
        const std::optional<Covering> seen = seen_of(*next, scene, {});
        edge |= first.has_value() != seen.has_value() || (first && first->triangle != seen->triangle);
      }
      if (edge) continue;
      JudgedPixel pixel{x, y};
      const double* const reference = right.radiance_double.at(x, y);
      pixel.reference = {reference[0], reference[1], reference[2]};
      pixel.half_width = Double3(0x1p-22);
      if (const float object = right.aovs[0].at(x, y)[0]; object > 0)
        pixel.half_width += bound
                                .at(static_cast<std::size_t>(object) - 1,
                                    static_cast<std::uint32_t>(right.aovs[1].at(x, y)[0]) - 1, x, y, BoundPart::whole)
                                .either_way;
      right_.push_back(pixel);
    }
}

RankRequest PixelJudge::request(const Image<float>& actual, StoredAs as, std::uint64_t seed) const {
  RankRequest request{scene_, width_, height_};
  request.range = as == StoredAs::rgb8 ? StoredRange::unit : StoredRange::any;
  request.device = llvmpipe_profile(driver_profiles[0].tolerances);
  request.actual = &actual;
  for (JudgedPixel pixel : right_) {
    pixel.actual = values_of(actual, pixel.x, pixel.y);
    bool explained = true;
    for (int c = 0; c < 3; ++c) {
      if (as == StoredAs::rgb8) {
        pixel.reference[c] = std::clamp(pixel.reference[c], 0.0, 1.0);
        pixel.half_width[c] += 0.6 / 255;
      }
      explained &= std::abs(pixel.actual[c] - pixel.reference[c]) <= pixel.half_width[c];
    }
    (explained ? request.explained : request.unexplained).push_back(pixel);
  }
  request.unexplained_in_image = request.unexplained.size();
  std::mt19937_64 random(seed);
  cut(request.unexplained, random), cut(request.explained, random);
  return request;
}

} // namespace refraster
