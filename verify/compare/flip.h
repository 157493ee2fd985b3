#pragma once
// How different two images look to a person who flips between them. Information beside the numbers, never a verdict: it
// sees no fault that an eye would not.

#include <refraster/image.h>

namespace refraster {

/// A common viewing distance: 0.7 m before a screen of 3840 pixels on 0.7 m. Pixels per degree of visual angle.
inline constexpr double flip_pixels_per_degree = 0.7 * (3840 / 0.7) * 3.14159265358979323846 / 180;

/// LDR-FLIP, the mean over all pixels: 0 for equal images, at most 1. Andersson, Nilsson, Akenine-Möller, Oskarsson,
/// Åström, Fairchild, "FLIP: A difference evaluator for alternating images", 2020, in double.
/// Both images have 3 channels, in levels 0 to 255 which are taken as sRGB, as a screen shows them.
double mean_flip(const Image<float>& reference, const Image<float>& test);

} // namespace refraster
