#pragma once
// Whether a hypothesis explains a pixel.

#include "verify/hypotheses/pixel_colours.h"
#include "verify/hypotheses/rank.h"

namespace refraster::hypotheses {

struct Fit {
  bool fits = false;
  double distance = 0; // to the actual value: of the channel that is farthest off
};

/// How far a device may move a colour, to first order: as much as it moves when its inputs do.
Double3 noise_of(PixelColours& colours, const Steps& steps, const RankRequest& request);

/// A pixel is explained if each channel of the hypothetical value is no farther from the actual one than a right device
/// may be: the pixel's half width. Where the hypothesis' colour is noisier than the right one, whose noise is
/// `right_noise`, that much farther.
Fit fit_of(PixelColours& colours, const JudgedPixel& pixel, const Double3& right_noise, const Steps& steps,
           const RankRequest& request);

} // namespace refraster::hypotheses
