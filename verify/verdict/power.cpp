#include "verify/verdict/power.h"

#include "raster/parallel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace refraster {
namespace {

/// Of them, shares of causes are asked of every eighth: a cause costs as much as the bounds.
constexpr int wanted_pixels = 384, pixels_a_share = 8;

/// In levels: below it nearly all values that drift are rounded as they were, so that the others tell.
constexpr double narrow_half_width = 0.1;

} // namespace

SampledBounds sample_bounds(const DeviceFrame& frame, const StoredValue& stored, std::uint64_t seed,
                            const std::function<std::optional<std::uint32_t>(int x, int y)>& ours) {
  // One place in each cell of a grid of about as many cells, at random within it: spread, and the same every time.
  const double cell = std::max(1.0, std::sqrt(static_cast<double>(frame.width()) * frame.height() / wanted_pixels));
  std::mt19937_64 random(seed);
  std::vector<std::pair<PixelPlace, std::uint32_t>> places;
  for (double y = 0; y < frame.height(); y += cell)
    for (double x = 0; x < frame.width(); x += cell) {
      const auto within = [&](double from, int size) {
        const double share = static_cast<double>(random() >> 11) * 0x1p-53;
        return std::min(static_cast<int>(from + share * cell), size - 1);
      };
      const PixelPlace at{within(x, frame.width()), within(y, frame.height())};
      if (const auto number = ours(at.x, at.y)) places.emplace_back(at, *number);
    }
  SampledBounds sampled;
  sampled.pixels.resize(places.size());
  const int threads = frame.context().threads;
  std::vector<std::unique_ptr<PixelBounder>> bounders(static_cast<std::size_t>(threads));
  constexpr std::size_t block = 16;
  parallel_for(threads, (places.size() + block - 1) / block, [&](std::size_t b, int thread) {
    auto& bounder = bounders[static_cast<std::size_t>(thread)];
    if (!bounder) bounder = std::make_unique<PixelBounder>(frame);
    for (std::size_t i = b * block; i < std::min((b + 1) * block, places.size()); ++i) {
      const PixelPlace at = places[i].first;
      const DeviceTriangle triangle(frame, places[i].second);
      const auto width = [&](BoundCauses causes) {
        const ColourBox box = bounder->bounds(triangle, at.x, at.y, causes).colour;
        double widest = 0;
        for (int c = 0; c < 3; ++c) widest = std::max(widest, stored.of(box.hi[c]) - stored.of(box.lo[c]));
        return widest;
      };
      SampledBounds::Pixel& pixel = sampled.pixels[i];
      pixel.object = triangle.ref().object;
      pixel.width = width(BoundCauses::all());
      if (i % pixels_a_share == 0)
        for (std::size_t k = 0; k < pixel.cause.size(); ++k)
          pixel.cause[k] = width(BoundCauses::only(static_cast<BoundCause>(k)));
    }
  });
  return sampled;
}

JudgePower power_of(const SampledBounds& sampled) {
  JudgePower power;
  power.pixels = sampled.pixels.size();
  if (sampled.pixels.empty()) return power;
  std::vector<double> widths;
  for (const auto& pixel : sampled.pixels) widths.push_back(pixel.width);
  std::sort(widths.begin(), widths.end());
  const auto below = [&](double levels) {
    const auto end = std::lower_bound(widths.begin(), widths.end(), levels);
    return static_cast<double>(end - widths.begin()) / static_cast<double>(widths.size());
  };
  power.below_tenth = below(0.1), power.below_one = below(1), power.below_four = below(4);
  power.median = widths[widths.size() / 2];
  return power;
}

CauseShares shares_of(const SampledBounds& sampled) {
  CauseShares shares{};
  double sum = 0;
  for (const auto& pixel : sampled.pixels) {
    double all = 0;
    for (const double width : pixel.cause) all += width;
    if (!(all > 0) || !std::isfinite(all)) continue;
    // Each pixel counts as much as any other, however wide its bounds.
    for (std::size_t k = 0; k < shares.size(); ++k) shares[k] += pixel.cause[k] / all;
    sum += 1;
  }
  for (double& share : shares) share = sum > 0 ? share / sum : 0;
  return shares;
}

namespace {

/// A value of the reference, and how many levels the device stored beside its rounding.
struct LevelDifference {
  std::uint32_t reference = 0; // its bits
  int levels = 0;
};

/// Which values of a large image are looked at: about a hundred thousand tell all there is, and cost less than the
/// image.
class TakenValues {
public:
  explicit TakenValues(std::size_t pixels)
      : others_(pixels > 200'000 ? std::max(8u, std::bit_ceil(static_cast<std::uint32_t>(pixels / 50'000))) - 1 : 0) {}
  bool has(std::uint32_t bits) const { return (((bits * 0x9e3779b1u) >> 16) & others_) == 0; }

private:
  std::uint32_t others_; // how many are left out for one that is taken: a power of two less 1
};

} // namespace

std::vector<ObjectBias> biases_of(const Verdict& verdict, const DeviceImage& image, const StoredValue& stored,
                                  const SampledBounds& sampled, std::size_t objects, int threads) {
  if (!stored.is_integer() || stored.step() != 1) return {};
  std::vector<std::vector<double>> half_widths(objects);
  for (const auto& pixel : sampled.pixels) half_widths[pixel.object].push_back(pixel.width / 2);
  // By rows, and then in their order, so that the result does not depend on the threads.
  std::vector<std::vector<std::pair<std::size_t, LevelDifference>>> of_row(static_cast<std::size_t>(verdict.height));
  const TakenValues taken(verdict.classes.values.size());
  parallel_for(threads, of_row.size(), [&](std::size_t row, int) {
    const int y = static_cast<int>(row);
    const float* const references = verdict.reference.at(0, y);
    for (int i = 0; i < 3 * verdict.width; ++i) {
      const auto bits = std::bit_cast<std::uint32_t>(references[i]);
      if (bits == 0 || !taken.has(bits)) continue; // most of a background, at small cost
      const auto object = static_cast<std::size_t>(*verdict.object.at(i / 3, y));
      const auto found = static_cast<PixelClass>(*verdict.classes.at(i / 3, y));
      if (object == 0 || found > PixelClass::shading) continue;
      const double exact = stored.of(static_cast<double>(references[i]));
      if (exact <= 0.5 || exact >= 254.5) continue; // where levels end
      const double apart = stored.levels(image.colour.at(0, y)[i]) - std::nearbyint(exact);
      of_row[row].push_back({object - 1, {bits, static_cast<int>(apart)}});
    }
  });
  std::vector<std::vector<LevelDifference>> of_object(objects);
  for (const auto& row : of_row)
    for (const auto& [object, difference] : row) of_object[object].push_back(difference);
  std::vector<ObjectBias> biases;
  for (std::size_t i = 0; i < objects; ++i) {
    constexpr std::size_t enough_values = 1000, enough_widths = 16;
    if (half_widths[i].size() < enough_widths) continue;
    // A value counts once, however many pixels have it: then the values are spread within their levels.
    auto& values = of_object[i];
    std::sort(values.begin(), values.end(),
              [](const LevelDifference& a, const LevelDifference& b) { return a.reference < b.reference; });
    const auto same = [](const LevelDifference& a, const LevelDifference& b) { return a.reference == b.reference; };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
    if (values.size() < enough_values) continue;
    double sum = 0, squares = 0;
    for (const double width : half_widths[i]) sum += width, squares += width * width;
    const auto widths = static_cast<double>(half_widths[i].size());
    const double mean_width = sum / widths,
                 deviation = std::sqrt(std::max(squares / widths - mean_width * mean_width, 0.0));
    const double likely = mean_width + 3 * deviation / std::sqrt(widths);
    if (!(likely < narrow_half_width)) continue;
    const auto count = static_cast<double>(values.size());
    // Bernstein's inequality for a share with the probability p of each: p + 6 sqrt(p / n) + 12 / n is exceeded once in
    // 10^7 times.
    const auto most = [count](double p) { return p + 6 * std::sqrt(p / count) + 12 / count; };
    ObjectBias& bias = biases.emplace_back();
    bias.object = i, bias.values = values.size();
    double levels = 0, moved = 0;
    for (const LevelDifference& value : values) levels += value.levels, moved += value.levels != 0;
    bias.mean = levels / count, bias.allowed = most(likely);
    bias.moved = moved / count, bias.allowed_moved = most(2 * likely);
  }
  return biases;
}

} // namespace refraster
