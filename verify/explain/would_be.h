#pragma once
// Which single term would have to be what for another value of the pixel to be right.

#include "verify/explain/pixel_story.h"

#include <vector>

namespace refraster {

/// Of a story with an actual value that is not the same: every term and factor that alone would explain it, likeliest
/// first: factors that explain all channels with one number before those that need one for each; what is a well-known
/// mistake (left out, twice, not attenuated) before what is not. A value that no such term may have (a negative colour)
/// is none. The terms of the pixel are linear in all of them, so that what is found follows from the story's numbers.
std::vector<WouldBe> what_would_be(const PixelStory& story);

} // namespace refraster
