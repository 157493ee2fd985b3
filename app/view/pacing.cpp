#include "app/view/pacing.h"

#include <algorithm>

namespace refraster {
namespace {

constexpr double budget_seconds = 1 / moving_frames_a_second;
/// A finer scale is taken only where its pixels are thought to need no more than this part of what they may: times of
/// frames vary by some per cent, and a picture that goes from one scale to the other and back is worse than a coarse
/// one.
constexpr double part_for_finer = 0.8;
/// What pixels may add to the time that is the same at every scale, where little or nothing is left for them.
constexpr double pixels_of_fixed = 0.25;
/// Of a new time in the mean of those before: a single frame that was slow, as another program ran, changes nothing.
constexpr double weight_of_new = 0.25;

} // namespace

void Pacing::add(const StageSeconds& frame, double showing_seconds) {
  const double fixed = frame.total - frame.tiles + showing_seconds, pixels = frame.tiles / (scale() * scale());
  const double weight = any_ ? weight_of_new : 1;
  fixed_seconds_ += weight * (fixed - fixed_seconds_);
  pixel_seconds_ += weight * (pixels - pixel_seconds_);
  any_ = true;
  const double left_for_pixels = std::max(budget_seconds - fixed_seconds_, fixed_seconds_ * pixels_of_fixed);
  std::size_t finest = moving_scales.size() - 1;
  for (std::size_t step = finest; step-- > 0;) {
    const double predicted = pixel_seconds_ * moving_scales[step] * moving_scales[step];
    if (predicted <= left_for_pixels * (step < step_ ? part_for_finer : 1)) finest = step;
  }
  step_ = finest;
}

} // namespace refraster
