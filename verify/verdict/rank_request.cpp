#include "verify/verdict/rank_request.h"

#include "raster/parallel.h"
#include "verify/bounds/candidates.h"
#include "verify/verdict/stored_value.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

namespace refraster::hypotheses {
namespace {

/// Explained ones cost bounds each; fewer tell as well what a hypothesis breaks.
constexpr std::size_t max_explained = 1024;

/// At most so many, which ones is chance; in the order they were in.
template <class Value>
void choose(std::vector<Value>& values, std::size_t most, std::mt19937_64& random) {
  if (values.size() <= most) return;
  for (std::size_t i = 0; i < most; ++i) std::swap(values[i], values[i + random() % (values.size() - i)]);
  values.resize(most);
}

Double3 values_at(const Image<float>& image, int x, int y) {
  const float* const at = image.at(x, y);
  return {static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])};
}

} // namespace

RankRequest rank_request(const Scene& scene, const DeviceImage& image, const DeviceProfile& profile,
                         const JudgeOptions& options, const Verdict& verdict, Image<float>& actual_values) {
  const StoredValue stored(image, profile);
  actual_values = image.colour;
  for (float& value : actual_values.values) value = static_cast<float>(static_cast<double>(value) / image.full_scale);
  RankRequest request{scene, verdict.width, verdict.height, options.samples, options.threads, image.transfer};
  request.range = stored.is_integer() ? StoredRange::unit : StoredRange::any;
  request.device = profile;
  request.actual = &actual_values;
  request.unexplained_in_image = verdict.count(PixelClass::unexplained);
  if (request.unexplained_in_image == 0) return request;

  std::mt19937_64 random(options.seed);
  std::vector<PixelPlace> places;
  for (const JudgedDetail& detail : verdict.details)
    if (detail.found == PixelClass::unexplained) places.push_back({detail.x, detail.y});
  choose(places, max_judged_pixels, random);
  const std::size_t unexplained = places.size();
  std::vector<PixelPlace> right;
  for (int y = 0; y < verdict.height; ++y)
    for (int x = 0; x < verdict.width; ++x)
      if (static_cast<PixelClass>(*verdict.classes.at(x, y)) <= PixelClass::texel) right.push_back({x, y});
  choose(right, std::min(max_explained, max_judged_pixels), random);
  places.insert(places.end(), right.begin(), right.end());

  RenderOptions render;
  render.width = verdict.width, render.height = verdict.height;
  render.samples = options.samples, render.threads = options.threads;
  const DeviceFrame device(scene, render, profile, options.matrices);
  const std::vector<VisibleSet> sets = find_candidates(device, places, {subpixels / 2, subpixels / 2});
  std::vector<std::optional<JudgedPixel>> pixels(places.size());
  const int threads = device.context().threads;
  std::vector<std::unique_ptr<PixelBounder>> bounders(static_cast<std::size_t>(threads));
  parallel_for(threads, places.size(), [&](std::size_t i, int thread) {
    const VisibleSet& set = sets[i];
    if (set.candidates.size() + (set.background ? 1 : 0) != 1) return;
    auto& bounder = bounders[static_cast<std::size_t>(thread)];
    if (!bounder) bounder = std::make_unique<PixelBounder>(device);
    const auto [x, y] = places[i];
    const Double3 radiance = values_at(verdict.reference, x, y);
    ColourBox box{radiance, radiance};
    if (!set.background) box = bounder->bounds(DeviceTriangle(device, set.candidates[0].number), x, y).colour;
    if (!box.is_finite()) return;
    JudgedPixel pixel{x, y};
    pixel.actual = values_at(actual_values, x, y);
    for (int c = 0; c < 3; ++c) {
      const double reference = stored.of(radiance[c]);
      pixel.reference[c] = reference / 255;
      pixel.half_width[c] = (std::max(stored.of(box.hi[c]) - reference, reference - stored.of(box.lo[c])) +
                             stored.tolerance(radiance[c])) /
                            255;
    }
    pixels[i] = pixel;
  });
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i]) (i < unexplained ? request.unexplained : request.explained).push_back(*pixels[i]);
  return request;
}

} // namespace refraster::hypotheses
