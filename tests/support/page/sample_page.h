#pragma once
// A page that has everything a page may have, to look at and to test the viewer with. Two renders of a scene are real;
// what is said of their pixels follows from their differences by rules that are easy to foresee, and is no verdict.

#include <refraster/scene.h>

#include "verify/page/report_page.h"

namespace refraster::test {

enum class SampleImages { rgb8, values };

/// The scene with Blinn-Phong and with Phong on its first object, which must have the former; the latter with another
/// level where rounding is close. Of the classes `unexplained` are the pixels that differ by more than one level.
ReportPage sample_page(const Scene& scene, int width, int height, SampleImages images);

} // namespace refraster::test
