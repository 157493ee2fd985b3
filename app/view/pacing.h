#pragma once
// How fine the picture is while the camera moves.

#include <refraster/frame.h>

#include <array>
#include <cstddef>

namespace refraster {

/// What moves is drawn at least so often where it can be.
inline constexpr double moving_frames_a_second = 30;

/// Fractions of the window's width and height, the finest first. Each has about half of the pixels of the one before.
inline constexpr std::array moving_scales{1.0, 3.0 / 4, 1.0 / 2, 3.0 / 8, 1.0 / 4, 3.0 / 16, 1.0 / 8, 1.0 / 16};

/// Chooses the finest scale at which frames take no longer than a thirtieth of a second, from what the last ones took.
/// Of a frame's time, that of its tiles grows with the number of pixels; all else, vertices and bins, and showing it,
/// is the same at every scale. Where that alone takes nearly all of the time, or more, pixels may add a quarter to it:
/// fewer would hardly help.
class Pacing {
public:
  double scale() const { return moving_scales[step_]; }
  /// A frame at this scale took so long, and showing it as long again as `showing_seconds`.
  void add(const StageSeconds& frame, double showing_seconds);

private:
  std::size_t step_ = 2; // half: what is not known yet is neither slow nor coarse
  bool any_ = false;
  double fixed_seconds_ = 0, pixel_seconds_ = 0; // the latter for a frame of scale 1
};

} // namespace refraster
