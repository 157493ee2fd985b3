#pragma once
// How far the fragment functions may be from exact arithmetic on the same inputs. docs/precision.md says what is
// measured, on what, and how; tests/precision measures again and compares.

#include "math/ulp_bound.h"

#include <string_view>

namespace refraster {

/// Bounds for one fragment function on one family of inputs. Units in the last place
///   of the terms   of the sum of the magnitudes of what the radiance is made from: sound where terms cancel
///   of the result  of the radiance itself; unbounded where it vanishes
struct PrecisionBound {
  std::string_view model, inputs;
  UlpBound double_terms, float_terms, double_result, float_result;
  double float_from_double; // largest |difference| of the two rungs' radiance, for a light of radiance 1
};

inline constexpr PrecisionBound precision_bounds[] = {
    {"phong", "ordinary", {}, {}, {}, {}, 0},
};

/// The same for a coordinate of the MERL table, in bins.
struct BinBound {
  double max, mostly;
};
struct CoordinateBound {
  std::string_view coordinate, method, inputs;
  BinBound double_bins, float_bins;
};

inline constexpr CoordinateBound coordinate_bounds[] = {
    {"u", "closed", "uniform", {}, {}},
};

/// Vectors: the largest error of a component of a / |a|, and of |a|.
template <class F>
inline constexpr UlpBound normalize_error = {3, 2};
template <class F>
inline constexpr UlpBound length_error = {3, 2};
/// In ulps of the sum of the magnitudes of the terms.
template <class F>
inline constexpr UlpBound dot_error = {2, 1};

} // namespace refraster
