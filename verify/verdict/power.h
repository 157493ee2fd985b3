#pragma once
// What a verdict is worth: how narrow the bounds are, and drifts that no single pixel shows.

#include "verify/verdict/judge_pixel.h"

namespace refraster {

/// The bounds of pixels chosen at random among those that show a surface.
struct SampledBounds {
  struct Pixel {
    std::size_t object = 0; // in the scene, from 0
    double width = 0;       // levels; infinite where nothing is known
    CauseShares cause{};    // width by each cause alone
  };
  std::vector<Pixel> pixels;
};

/// About so many: `ours(x, y)` gives the triangle that is shown, if any.
SampledBounds sample_bounds(const DeviceFrame& frame, const StoredValue& stored, std::uint64_t seed,
                            const std::function<std::optional<std::uint32_t>(int x, int y)>& ours);

JudgePower power_of(const SampledBounds& sampled);
CauseShares shares_of(const SampledBounds& sampled);

/// Of each object's pixels that are exact, rounding or shading, in integer formats: whether the mean of
/// actual - reference is what roundings leave. With n values whose rounding is spread over a level, that mean is
/// within 6 standard deviations of chance, 0.289 / sqrt(n), and the mean of the bounds' half-widths; and the mean
/// square within 6 of its own, 1/12 and the mean square of half-widths. Only where bounds are below 0.1 levels in the
/// mean, and the reference runs through eight levels at least: else its rounding is not spread.
std::vector<ObjectBias> biases_of(const Verdict& verdict, const DeviceImage& image, const StoredValue& stored,
                                  const SampledBounds& sampled, std::size_t objects);

} // namespace refraster
