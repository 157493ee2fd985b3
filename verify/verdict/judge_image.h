#pragma once
// An image judged for a report.

#include "verify/verdict/verdict_report.h"

namespace refraster {

/// Whether it is known where an image's samples lie in a pixel, or they may be counted from the top or from the bottom.
enum class SampleOrder { known, either };

/// Notes what of a scene no verdict is given on.
void note_what_is_not_judged(VerdictReport& report, const Scene& scene);

/// Judges an image of the scene, by the report's profile and options, and puts the verdict into the report. A file does
/// not say which way its samples were counted: with SampleOrder::either it is the one, for the whole image, that leaves
/// fewer pixels unexplained; `image` then has its positions. Throws as judge() does.
void judge_image(VerdictReport& report, const Scene& scene, DeviceImage& image, SampleOrder order);

} // namespace refraster
