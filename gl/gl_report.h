#pragma once
// The report of `refraster gl`, for programs.

#include "gl/render_gl.h"

#include <string>

namespace refraster {

/// Driver, times and counts as JSON, members always in the same order: docs/reports.md describes them.
std::string gl_report_json(const std::string& scene, const GlOptions& options, const GlFrame& frame);

} // namespace refraster
