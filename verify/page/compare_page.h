#pragma once
// The page of a comparison of two images.

#include "verify/compare/compare_report.h"
#include "verify/images/image_pair.h"
#include "verify/page/report_page.h"

#include <optional>

namespace refraster {

/// All of a comparison, with the two images, each pixel's class (equal; within the limit; over it, or different where
/// there is none; without a difference) and, where a scene is known, objects and triangles. Provenance: the files'
/// names and digests, and this build. The images are those that were compared. Throws InputError if a file cannot be
/// read.
ReportPage comparison_page(const ComparisonReport& report, const ImagePair& images, const PixelScale& scale,
                           const std::optional<SeenObjects>& seen);

} // namespace refraster
