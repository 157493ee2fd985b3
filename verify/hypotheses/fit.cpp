#include "verify/hypotheses/fit.h"

#include <algorithm>
#include <cmath>

namespace refraster::hypotheses {
namespace {

/// An arc cosine hangs on the last bits of its argument: any of so many on either side may have come out.
constexpr int max_angle_ulps = 3;
/// Of a colour that was computed in single precision, relative to 1 and to itself.
constexpr double float_noise = 0x1p-18;

Double3 in_range(Double3 value, StoredRange range) {
  if (range == StoredRange::unit)
    for (int c = 0; c < 3; ++c) value[c] = std::clamp(value[c], 0.0, 1.0);
  return value;
}

/// Of the channel that is farthest off; infinite for NaN.
double distance_of(const Double3& a, const Double3& b) {
  double most = 0;
  for (int c = 0; c < 3; ++c) {
    const double difference = std::abs(a[c] - b[c]);
    most = std::isnan(difference) ? HUGE_VAL : std::max(most, difference);
  }
  return most;
}

/// How far the cosine of a highlight is off that is computed from directions of any length: eight roundings.
constexpr double lobe_noise = 0x1p-21;

bool has_any_length(const Steps& steps) {
  return steps.normal_length != NormalLength::unit || steps.eye == Eye::not_normalised ||
         steps.light_direction == LightDirection::not_normalised || steps.lobe == Lobe::half_not_normalised;
}

bool within(const Double3& value, const JudgedPixel& pixel, const Double3& noise) {
  for (int c = 0; c < 3; ++c)
    if (!(std::abs(value[c] - pixel.actual[c]) <= pixel.half_width[c] + noise[c])) return false;
  return true;
}

/// Of one alternative, and what was nudged in it already.
Double3 noise_of(PixelColours& colours, const Double3& value, const Steps& steps, int alternative, const Nudge& nudge,
                 const RankRequest& request) {
  const DeviceProfile& device = request.device;
  Double3 noise;
  for (int c = 0; c < 3; ++c) noise[c] = float_noise * (1 + std::abs(value[c]));
  const auto add = [&](const Nudge& moved, double dx, double dy) {
    const Double3 there = in_range(colours.stored(steps, alternative, moved, dx, dy), request.range);
    for (int c = 0; c < 3; ++c) noise[c] += std::abs(there[c] - value[c]);
  };
  if (has_any_length(steps)) {
    Nudge lobe = nudge;
    lobe.lobe = lobe_noise;
    add(lobe, 0, 0);
  }
  // Both sides round a vertex to their lattice.
  const double shift = 0.5 + device.raster.lattice * device.raster.snap_steps * subpixels;
  add(nudge, shift, 0), add(nudge, 0, shift);
  Nudge texel = nudge;
  texel.texel += device.texture.filter_error + device.texture.place_error;
  if (texel.texel != nudge.texel) add(texel, 0, 0);
  if (colours.has_mip_levels(steps)) {
    Nudge coarser = nudge, finer = nudge;
    coarser.detail += device.texture.detail_above, finer.detail -= device.texture.detail_below;
    if (coarser.detail != nudge.detail) add(coarser, 0, 0);
    if (finer.detail != nudge.detail) add(finer, 0, 0);
    Nudge mip = nudge;
    mip.texel += device.texture.mip_error;
    add(mip, 0, 0);
  }
  return noise;
}

} // namespace

Double3 noise_of(PixelColours& colours, const Steps& steps, const RankRequest& request) {
  return noise_of(colours, in_range(colours.stored(steps, 0), request.range), steps, 0, {}, request);
}

Fit fit_of(PixelColours& colours, const JudgedPixel& pixel, const Double3& right_noise, const Steps& steps,
           const RankRequest& request) {
  struct Best {
    Double3 value{0};
    int alternative = 0;
    Nudge nudge;
    double distance = HUGE_VAL;
  } best;
  const int ulps = steps.table_angles == TableAngles::arc_cosine ? max_angle_ulps : 0;
  for (int alternative = 0; alternative < PixelColours::alternatives; ++alternative) {
    if (alternative > 0 && !colours.differs(steps, alternative)) continue;
    for (int k = -ulps; k <= ulps; ++k) {
      Nudge nudge;
      nudge.angle_ulps = k;
      const Double3 value = in_range(colours.stored(steps, alternative, nudge), request.range);
      const double distance = distance_of(value, pixel.actual);
      if (within(value, pixel, Double3(0))) return {true, distance};
      if (distance < best.distance) best = {value, alternative, nudge, distance};
    }
  }
  // Noise is dear to know, and no help far off.
  constexpr double hopeful = 0.1;
  const double size = std::max({1.0, std::abs(best.value.x), std::abs(best.value.y), std::abs(best.value.z)});
  if (!(best.distance <= hopeful * size)) return {false, best.distance};
  Double3 noise = noise_of(colours, best.value, steps, best.alternative, best.nudge, request);
  for (int c = 0; c < 3; ++c) noise[c] = std::max(noise[c] - right_noise[c], 0.0);
  return {within(best.value, pixel, noise), best.distance};
}

} // namespace refraster::hypotheses
