#pragma once
// What judge() found, as a page to look at.

#include "verify/page/report_page.h"
#include "verify/verdict/verdict_report.h"

namespace refraster {

/// With the story (verify/explain) of the worst pixel of each of the largest clusters. Takes the images' memory several
/// times. `scene` and `image` are those that were judged.
ReportPage verdict_page(const VerdictReport& report, const Scene& scene, const DeviceImage& image);

} // namespace refraster
