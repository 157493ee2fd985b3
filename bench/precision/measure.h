#pragma once
// The measurements: one row each of docs/precision.md.

#include "bench/precision/errors.h"
#include "bench/precision/inputs.h"
#include "raster/vertex/error_bounds.h"
#include "shading/precision_bounds.h"

#include <string_view>
#include <vector>

namespace refraster::precision {

/// An elementary function on one family of arguments.
struct FunctionRow {
  std::string_view function, inputs;
  UlpBound double_bound, float_bound;
  Error double_ulp, float_ulp;
  bool has_float = true;
};
std::vector<FunctionRow> measure_functions(int trials);

/// A fragment function on one family of inputs.
struct ShadingRow {
  PrecisionBound bound;
  Error double_terms, float_terms, double_result, float_result, float_from_double;
  double double_other_bin = 0, float_other_bin = 0; // share of inputs that `nearest` reads from the neighbouring bin
};
std::vector<ShadingRow> measure_shading(int trials);

/// A coordinate of the MERL table by one method, on one family of inputs.
struct CoordinateRow {
  CoordinateBound bound;
  Error double_bins, float_bins;
};
std::vector<CoordinateRow> measure_coordinates(int trials);

/// A value that the vertex stage stores, over one kind of scenes.
struct VertexRow {
  VertexBound bound;
  Error units;
};
/// Over these scene files.
std::vector<VertexRow> measure_gallery_vertices(const std::vector<std::string>& paths);
/// Over the first so many scenes of the soak test's generator.
std::vector<VertexRow> measure_random_vertices(int scenes);

/// In float: |error| of u in bins against the angle from the normal to the half vector, by the arc cosine and by the
/// closed form; the largest and the median of many pairs at each angle.
struct HighlightPoint {
  double angle; // radians
  double acos_max, acos_median, closed_max, closed_median;
};
std::vector<HighlightPoint> measure_highlight(int pairs_each);

} // namespace refraster::precision
