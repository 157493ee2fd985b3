#pragma once
// The picture of docs/precision.md.

#include "bench/precision/measure.h"

#include <span>
#include <string>

namespace refraster::precision {

/// An SVG document: error against angle, both logarithmic.
std::string highlight_plot(std::span<const HighlightPoint> points);

} // namespace refraster::precision
