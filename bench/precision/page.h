#pragma once
// The generated parts of docs/precision.md.

#include "bench/precision/measure.h"

#include <string>

namespace refraster::precision {

struct Measurements {
  std::vector<FunctionRow> functions;
  std::vector<ShadingRow> shading;
  std::vector<CoordinateRow> coordinates;
};

/// The page with its tables replaced: everything between `<!-- refraster_precision NAME -->` and `<!-- end -->`.
std::string updated_page(std::string page, const Measurements& measured);
/// The same for the tables of the vertex stage, which are measured in seconds.
std::string updated_page(std::string page, const std::vector<VertexRow>& measured);

/// The initialisers of shading/precision_bounds.h for what was measured: a quarter more, rounded up to two digits.
std::string suggested_bounds(const Measurements& measured);
/// The same of raster/vertex/error_bounds.h.
std::string suggested_bounds(const std::vector<VertexRow>& measured);

/// "≤ 2.5 (1.5)": how a bound stands in the page.
std::string bound_text(double max, double mostly);
inline std::string bound_text(const UlpBound& bound) {
  return bound_text(bound.max, bound.mostly);
}
inline std::string bound_text(const BinBound& bound) {
  return bound_text(bound.max, bound.mostly);
}

/// The beginning of the line that shows a row: "| phong | ordinary |".
std::string row_name(std::string_view what, std::string_view inputs);

} // namespace refraster::precision
