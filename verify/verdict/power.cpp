#include "verify/verdict/power.h"

#include "raster/parallel.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <random>

namespace refraster {
namespace {

/// Of them, shares of causes are asked of every eighth: a cause costs as much as the bounds.
constexpr int wanted_pixels = 384, pixels_a_share = 8;

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
      const auto& [at, number] = places[i];
      const DeviceTriangle triangle(frame, number);
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

std::vector<ObjectBias> biases_of(const Verdict& verdict, const DeviceImage& image, const StoredValue& stored,
                                  const SampledBounds& sampled, std::size_t objects) {
  if (!stored.is_integer() || stored.step() != 1) return {};
  struct Sums {
    double count = 0, sum = 0, squares = 0, width = 0, square_width = 0, widths = 0;
    std::bitset<256> levels;
  };
  std::vector<Sums> of_object(objects);
  for (const auto& pixel : sampled.pixels) {
    Sums& sums = of_object[pixel.object];
    sums.width += pixel.width / 2, sums.square_width += pixel.width * pixel.width / 4, sums.widths += 1;
  }
  for (int y = 0; y < verdict.height; ++y)
    for (int x = 0; x < verdict.width; ++x) {
      const auto object = static_cast<std::size_t>(*verdict.object.at(x, y));
      const auto found = static_cast<PixelClass>(*verdict.classes.at(x, y));
      if (object == 0 || found > PixelClass::shading) continue;
      Sums& sums = of_object[object - 1];
      for (int c = 0; c < 3; ++c) {
        const double exact = stored.of(static_cast<double>(verdict.reference.at(x, y)[c]));
        if (exact <= 0.5 || exact >= 254.5) continue; // where levels end
        const double error = stored.levels(image.colour.at(x, y)[c]) - exact;
        sums.count += 1, sums.sum += error, sums.squares += error * error;
        sums.levels.set(static_cast<std::size_t>(exact));
      }
    }
  std::vector<ObjectBias> biases;
  for (std::size_t i = 0; i < objects; ++i) {
    const Sums& s = of_object[i];
    constexpr double enough_values = 1000, enough_widths = 8, narrow = 0.1;
    constexpr std::size_t enough_levels = 8;
    if (s.count < enough_values || s.widths < enough_widths || s.levels.count() < enough_levels) continue;
    const double half_width = s.width / s.widths;
    if (!(half_width < narrow / 2)) continue;
    constexpr double rounding_square = 1.0 / 12, deviations = 6;
    // Of x^2, x spread evenly over [-1/2, 1/2]: its variance is 1/80 - 1/144.
    const double square_deviation = std::sqrt(1.0 / 80 - 1.0 / 144);
    ObjectBias& bias = biases.emplace_back();
    bias.object = i, bias.values = static_cast<std::uint64_t>(s.count);
    bias.mean = s.sum / s.count, bias.mean_square = s.squares / s.count;
    bias.allowed = half_width + deviations * std::sqrt(rounding_square / s.count);
    // (r + w)^2 = r^2 + 2 r w + w^2, and |r| has a mean of a quarter.
    bias.allowed_square = rounding_square + half_width / 2 + s.square_width / s.widths +
                          deviations * square_deviation / std::sqrt(s.count);
  }
  return biases;
}

} // namespace refraster
