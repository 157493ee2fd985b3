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

/// Of each object's pixels that are exact, rounding or shading, in 8-bit images: whether values are rounded to another
/// level than the reference's more often than chance has it. What the device computes is within half the bounds' width
/// h of the reference, so that a value may be rounded up where it lies within h below the middle between two levels,
/// and down within h above it. Of values that are spread within their levels that is a share h of them each. Every
/// value of the reference counts once, so that areas of one colour do not count at all. Only where h is small in the
/// mean.
std::vector<ObjectBias> biases_of(const Verdict& verdict, const DeviceImage& image, const StoredValue& stored,
                                  const SampledBounds& sampled, std::size_t objects, int threads);

} // namespace refraster
