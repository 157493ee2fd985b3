#pragma once
// How far the fragment functions may be from exact arithmetic on the same inputs. docs/precision.md says what is
// measured, on what, and how; tests/system/precision measures again and compares.

#include "math/elementary/ulp_bound.h"

#include <string_view>

namespace refraster {

/// Bounds for one fragment function on one family of inputs. Units in the last place
///   of the terms   of the sum of the magnitudes of what the radiance is made from: sound where terms cancel
///   of the result  of the radiance itself; unbounded where it vanishes
struct PrecisionBound {
  std::string_view function, inputs; // of the fragment function; of the family: bench/precision/inputs.cpp
  UlpBound double_terms, float_terms, double_result, float_result;
  double float_from_double; // largest |difference| of the two precisions' radiance, for a light of radiance 1
};

/// A pixel of a frame in `double` is off by at most so many units of 2^-53, of 1 or of the pixel if that is brighter,
/// from the same frame in `exact`: interpolation, textures, lights and all. For scenes like those of the gallery: the
/// bound is a quarter more than what showed there.
inline constexpr double frame_error_units = 320;

inline constexpr PrecisionBound precision_bounds[] = {
    {"phong", "ordinary", {4, 1.6}, {11, 2.4}, {13, 4.1}, {22, 6.4}, 9.5e-07},
    {"phong", "highlight", {3.9, 1.7}, {70, 15}, {9.9, 4.3}, {180, 36}, 1.2e-05},
    {"phong", "sharp highlight", {2.7, 1.4}, {730, 200}, {7.8, 3.6}, {1900, 470}, 0.00019},
    {"phong", "whole glossiness", {4, 1.7}, {29, 7.4}, {11, 4.1}, {77, 18}, 6.1e-06},
    {"phong", "soft", {29, 1.9}, {350, 1.9}, {40, 3.2}, {350, 3.3}, 9e-05},
    {"phong", "grazing", {2.8, 1.3}, {5.5, 1.3}, {5.8e+05, 1.5e+05}, {6.1e+05, 1.6e+05}, 3.3e-07},
    {"phong", "opposite", {3, 1.5}, {4.1, 1.3}, {4.4, 1.9}, {13, 1.7}, 4.2e-07},
    {"phong", "retro", {3.3, 1.4}, {9.9, 2}, {2200, 13}, {4500, 16}, 9.4e-07},
    {"phong", "point light", {16, 2.9}, {13, 3.4}, {31, 7.2}, {26, 8.2}, 1.1e-05},
    {"phong", "direction light", {7, 2.4}, {13, 3.1}, {28, 6.6}, {26, 8}, 1.2e-05},
    {"phong", "huge", {12, 2.4}, {11, 3}, {26, 6.7}, {52, 7.9}, 1.2e-05},
    {"phong", "tiny", {11, 2.3}, {11, 2.9}, {21, 6.6}, {28, 7.8}, 2.1e-05},
    {"blinn_phong", "ordinary", {3.1, 1.6}, {4, 1.9}, {11, 4}, {22, 4.9}, 7.2e-07},
    {"blinn_phong", "highlight", {3.7, 1.6}, {30, 8.9}, {11, 3.8}, {120, 21}, 1.8e-05},
    {"blinn_phong", "sharp highlight", {3.3, 1.6}, {450, 120}, {11, 4.2}, {970, 260}, 0.00031},
    {"blinn_phong", "whole glossiness", {3.2, 1.6}, {18, 4.3}, {8.6, 3.6}, {39, 9}, 5.9e-06},
    {"blinn_phong", "soft", {3.1, 1.8}, {4.8, 1.8}, {3.8, 2}, {4.8, 2}, 4.2e-07},
    {"blinn_phong", "grazing", {1.6, 0.32}, {2.3, 0.35}, {6.2e+05, 1.8e+05}, {6.1e+05, 1.9e+05}, 3.7e-05},
    {"blinn_phong", "opposite", {2.5, 1.5}, {2.9, 1.5}, {3.8, 1.9}, {3.5, 1.9}, 0.75},
    {"blinn_phong", "retro", {2.9, 1.5}, {4.4, 1.8}, {2200, 13}, {4500, 16}, 4.3e-07},
    {"blinn_phong", "point light", {9.4, 2.9}, {11, 3.1}, {19, 6.6}, {22, 7.1}, 1.8e-05},
    {"blinn_phong", "direction light", {11, 2.1}, {11, 2.1}, {22, 6}, {21, 6.2}, 6.3e-06},
    {"blinn_phong", "huge", {15, 2.1}, {11, 2.3}, {30, 6}, {38, 6.5}, 1.6e-05},
    {"blinn_phong", "tiny", {12, 2.1}, {18, 2.4}, {38, 6.1}, {35, 6.7}, 1.9e-05},
    {"microfacet", "ordinary", {11, 3}, {9.4, 3.3}, {16, 6}, {15, 6.5}, 5.1e-06},
    {"microfacet", "highlight", {12, 4.6}, {52, 11}, {19, 8.7}, {120, 40}, 0.082},
    {"microfacet", "sharp highlight", {17, 4.8}, {540, 140}, {19, 9.7}, {1500, 490}, 78},
    {"microfacet", "whole glossiness", {17, 4.5}, {24, 6.2}, {20, 8.4}, {79, 19}, 0.0033},
    {"microfacet", "soft", {8.6, 4}, {14, 4.5}, {13, 5.7}, {15, 6.1}, 7.3e-08},
    {"microfacet", "grazing", {3, 0.21}, {2.6, 0.21}, {5.1e+05, 1.9e+05}, {6e+05, 1.9e+05}, 0.00081},
    {"microfacet", "opposite", {15, 1.3}, {34, 1.3}, {3.8e+05, 1.3e+05}, {1.8e+07, 1.3e+05}, 18},
    {"microfacet", "retro", {5.6, 2.2}, {7.3, 2.8}, {580, 9.6}, {590, 11}, 6.7e-07},
    {"microfacet", "point light", {13, 4.4}, {15, 4.6}, {31, 9.8}, {31, 11}, 6.2e-05},
    {"microfacet", "direction light", {17, 3.5}, {12, 4.1}, {23, 8.3}, {28, 9.3}, 4e-05},
    {"microfacet", "huge", {14, 3.8}, {15, 4.1}, {37, 9.5}, {40, 9.7}, 5.8e-05},
    {"microfacet", "tiny", {15, 3.6}, {13, 4.2}, {52, 9.3}, {57, 9.7}, 0.00016},
    {"merl nearest", "ordinary", {3.4, 1.9}, {3.6, 2.1}, {14, 3.1}, {8.5, 3.2}, 3e-07},
    {"merl nearest", "uniform", {3.2, 1.8}, {3.4, 2.1}, {1600, 14}, {6200, 16}, 5.6e-07},
    {"merl nearest", "specular", {3.1, 1.8}, {3.3, 2.1}, {8.4, 3}, {6.8, 3.2}, 1.4e-06},
    {"merl nearest", "retro", {3.1, 1.8}, {3.2, 2}, {1100, 13}, {5300, 14}, 1.9e-05},
    {"merl nearest", "grazing", {1.4, 0.77}, {1.6, 0.8}, {7.2e+05, 2e+05}, {7.6e+05, 2e+05}, 1.2e-05},
    {"merl nearest", "plane", {3.4, 1.9}, {3.3, 2.1}, {8.3, 3.1}, {11, 3.2}, 1.2e-06},
    {"merl nearest", "point light", {7.7, 4.2}, {8.6, 4.3}, {13, 5.8}, {13, 6.1}, 0.0015},
    {"merl nearest", "direction light", {4.8, 2.9}, {5.3, 2.7}, {14, 4.7}, {14, 4.5}, 6.3e-07},
    {"merl tricubic-log", "ordinary", {2.1, 1.2}, {2.3, 1.2}, {38, 18}, {38, 18}, 2.1e-06},
    {"merl tricubic-log", "uniform", {2.5, 1.2}, {2.2, 1.2}, {1200, 74}, {8100, 74}, 2.9e-06},
    {"merl tricubic-log", "specular", {2.2, 1.4}, {1.9, 1.1}, {70, 27}, {50, 24}, 6.7e-06},
    {"merl tricubic-log", "retro", {2.7, 1.4}, {3.5, 1.3}, {18000, 780}, {23000, 740}, 8.9e-06},
    {"merl tricubic-log", "grazing", {1.1, 0.05}, {1.2, 0.052}, {7.9e+05, 2e+05}, {7.9e+05, 2.1e+05}, 5.5e-05},
    {"merl tricubic-log", "plane", {2.2, 1.4}, {2.3, 1.3}, {51, 21}, {61, 21}, 7.6e-06},
    {"merl tricubic-log", "point light", {2.8, 1.3}, {2.7, 1.3}, {47, 20}, {50, 19}, 1.2e-05},
    {"merl tricubic-log", "direction light", {2.2, 1.2}, {2, 1.3}, {38, 19}, {40, 19}, 1.7e-05},
    {"merl trilinear", "ordinary", {2.2, 1.2}, {2.6, 1.2}, {40, 15}, {33, 14}, 1.7e-06},
    {"merl trilinear", "uniform", {2.5, 1.1}, {2.7, 1.2}, {1400, 67}, {9300, 65}, 3.3e-06},
    {"merl trilinear", "specular", {2.6, 1.4}, {3, 1.4}, {38, 21}, {46, 20}, 4.6e-06},
    {"merl trilinear", "retro", {6, 1.5}, {15, 1.8}, {21000, 1300}, {16000, 1300}, 1.9e-05},
    {"merl trilinear", "grazing", {0.96, 0.45}, {1.3, 0.47}, {6.9e+05, 2e+05}, {7.6e+05, 2e+05}, 5e-05},
    {"merl trilinear", "plane", {2.4, 1.3}, {2.9, 1.4}, {51, 17}, {57, 18}, 4.9e-06},
    {"merl trilinear", "point light", {5.8, 2.2}, {4.8, 2.2}, {37, 16}, {45, 15}, 1.3e-05},
    {"merl trilinear", "direction light", {3.9, 1.6}, {3.1, 1.5}, {35, 15}, {43, 15}, 1.7e-05},
    {"merl trilinear-edge", "ordinary", {2.3, 1.2}, {2.6, 1.3}, {43, 17}, {47, 17}, 1.9e-06},
    {"merl trilinear-edge", "uniform", {2.3, 1.1}, {2.3, 1.1}, {1600, 75}, {6200, 76}, 2.8e-06},
    {"merl trilinear-edge", "specular", {2.7, 1.5}, {2.7, 1.4}, {50, 22}, {46, 21}, 6.1e-06},
    {"merl trilinear-edge", "retro", {6.7, 1.5}, {9.4, 1.8}, {12000, 1400}, {17000, 1400}, 2.1e-05},
    {"merl trilinear-edge", "grazing", {0.98, 0.42}, {1.3, 0.42}, {7.3e+05, 2e+05}, {7.6e+05, 2e+05}, 5e-05},
    {"merl trilinear-edge", "plane", {2.5, 1.3}, {2.7, 1.4}, {99, 21}, {63, 22}, 7.6e-06},
    {"merl trilinear-edge", "point light", {5.2, 2.2}, {4.9, 2.3}, {52, 18}, {48, 17}, 1.4e-05},
    {"merl trilinear-edge", "direction light", {3.2, 1.6}, {3.1, 1.5}, {43, 18}, {53, 17}, 2e-05},
    {"merl trilinear-log", "ordinary", {2.2, 1.1}, {2.1, 1.1}, {50, 17}, {40, 17}, 2e-06},
    {"merl trilinear-log", "uniform", {2.2, 1.1}, {1.9, 1}, {1200, 70}, {8600, 70}, 2.4e-06},
    {"merl trilinear-log", "specular", {2, 1.1}, {1.8, 0.98}, {57, 25}, {44, 23}, 5e-06},
    {"merl trilinear-log", "retro", {4.3, 1.1}, {7.6, 1.2}, {21000, 1300}, {16000, 1300}, 1.9e-05},
    {"merl trilinear-log", "grazing", {0.67, 0.085}, {0.95, 0.086}, {6.9e+05, 2e+05}, {7.6e+05, 2e+05}, 5.1e-05},
    {"merl trilinear-log", "plane", {1.9, 1.1}, {2, 1.1}, {65, 19}, {74, 20}, 4.3e-06},
    {"merl trilinear-log", "point light", {2.2, 1.1}, {2, 1.2}, {41, 19}, {50, 18}, 1.2e-05},
    {"merl trilinear-log", "direction light", {2.2, 1.1}, {2.1, 1.1}, {47, 18}, {45, 18}, 1.7e-05},
};

/// The same for a coordinate of the MERL table, in bins.
struct BinBound {
  double max, mostly;
};
struct CoordinateBound {
  std::string_view coordinate, method, inputs;
  BinBound double_bins, float_bins;
};

// 90 is half of the circle that w lies on: any azimuth at all.
inline constexpr CoordinateBound coordinate_bounds[] = {
    {"u", "acos", "uniform", {4.5e-12, 1.4e-13}, {0.0043, 8.8e-05}},
    {"u", "acos", "specular", {0.00043, 0.00014}, {2.3, 1.9}},
    {"u", "acos", "retro", {6.7e-12, 9.4e-14}, {0.0031, 6.6e-05}},
    {"u", "acos", "grazing", {1.6e-12, 2e-14}, {0.00028, 1.2e-05}},
    {"u", "acos", "plane", {6.5e-07, 5.6e-12}, {1.6, 0.0035}},
    {"u", "closed", "uniform", {5.1e-14, 1.9e-14}, {6.6e-05, 1.1e-05}},
    {"u", "closed", "specular", {1.5e-10, 1.3e-11}, {0.044, 0.0094}},
    {"u", "closed", "retro", {2.7e-14, 1.9e-14}, {1.9e-05, 1.1e-05}},
    {"u", "closed", "grazing", {2.9e-13, 1.9e-14}, {4.3e-05, 1.2e-05}},
    {"u", "closed", "plane", {1.1e-11, 4.7e-14}, {0.0014, 3.2e-05}},
    {"v", "acos", "uniform", {9.6e-13, 1.2e-13}, {0.0018, 6.8e-05}},
    {"v", "acos", "specular", {4.6e-13, 6.9e-14}, {0.00048, 4.1e-05}},
    {"v", "acos", "retro", {5e-07, 2e-07}, {0.051, 0.031}},
    {"v", "acos", "grazing", {1.7e-11, 5.8e-13}, {0.032, 0.00031}},
    {"v", "acos", "plane", {6.2e-10, 1.1e-12}, {0.028, 0.00061}},
    {"v", "closed", "uniform", {2.3e-14, 1.5e-14}, {1.1e-05, 7.3e-06}},
    {"v", "closed", "specular", {2.4e-14, 1.7e-14}, {1.3e-05, 8.5e-06}},
    {"v", "closed", "retro", {1.3e-15, 4e-16}, {2.9e-06, 1.1e-06}},
    {"v", "closed", "grazing", {2.4e-14, 1.7e-14}, {1.3e-05, 8.3e-06}},
    {"v", "closed", "plane", {2.5e-14, 1.4e-14}, {1.1e-05, 7e-06}},
    {"w", "closed", "uniform", {7.8e-13, 5.1e-14}, {0.0031, 3.4e-05}},
    {"w", "closed", "specular", {7.8e-07, 3.8e-08}, {90, 24}},
    {"w", "closed", "retro", {5.8e-07, 4e-08}, {90, 27}},
    {"w", "closed", "grazing", {1.6e-12, 2.1e-14}, {0.00022, 1.1e-05}},
    {"w", "closed", "plane", {1.7e-10, 4.4e-13}, {0.021, 0.00025}},
    {"w", "frame", "uniform", {5.4e-13, 5.9e-14}, {0.0016, 3.8e-05}},
    {"w", "frame", "specular", {3.2e-07, 4.5e-08}, {90, 34}},
    {"w", "frame", "retro", {1.9e-07, 4.8e-08}, {90, 22}},
    {"w", "frame", "grazing", {1.2e-11, 1.7e-13}, {0.0085, 7.9e-05}},
    {"w", "frame", "plane", {2e-10, 4.9e-13}, {0.024, 0.00027}},
    {"w", "rotation", "uniform", {7.1e-13, 9.8e-14}, {0.0018, 6.3e-05}},
    {"w", "rotation", "specular", {3.3e-07, 6.7e-08}, {90, 48}},
    {"w", "rotation", "retro", {3.9e-07, 9.9e-08}, {90, 46}},
    {"w", "rotation", "grazing", {1.2e-11, 2e-13}, {0.013, 0.00011}},
    {"w", "rotation", "plane", {1.4e-09, 9.4e-13}, {0.086, 0.00055}},
    {"w sin θh sin θd", "closed", "uniform", {2.6e-14, 1.4e-14}, {1.5e-05, 7e-06}},
    {"w sin θh sin θd", "closed", "specular", {1.9e-14, 8.2e-15}, {8.9e-06, 4.6e-06}},
    {"w sin θh sin θd", "closed", "retro", {9.6e-15, 5.3e-15}, {5.3e-06, 3.3e-06}},
    {"w sin θh sin θd", "closed", "grazing", {3.5e-14, 1.7e-14}, {1.4e-05, 8.3e-06}},
    {"w sin θh sin θd", "closed", "plane", {1.8e-14, 6e-15}, {9.5e-06, 3e-06}},
    {"w sin θh sin θd", "frame", "uniform", {6.4e-14, 1.5e-14}, {5.3e-05, 9e-06}},
    {"w sin θh sin θd", "frame", "specular", {7.9e-14, 2.5e-14}, {6.1e-05, 2e-05}},
    {"w sin θh sin θd", "frame", "retro", {1.4e-14, 7e-15}, {6.2e-06, 3.5e-06}},
    {"w sin θh sin θd", "frame", "grazing", {5.1e-12, 2.4e-14}, {0.0066, 1.2e-05}},
    {"w sin θh sin θd", "frame", "plane", {1.5e-14, 6.4e-15}, {6.5e-06, 3.3e-06}},
    {"w sin θh sin θd", "rotation", "uniform", {7e-14, 1.9e-14}, {5.3e-05, 1.2e-05}},
    {"w sin θh sin θd", "rotation", "specular", {8e-14, 2.6e-14}, {5.8e-05, 2.1e-05}},
    {"w sin θh sin θd", "rotation", "retro", {2.5e-14, 1.3e-14}, {1.2e-05, 6.5e-06}},
    {"w sin θh sin θd", "rotation", "grazing", {5.1e-12, 2.2e-14}, {0.0066, 1.1e-05}},
    {"w sin θh sin θd", "rotation", "plane", {2.5e-14, 1.3e-14}, {2.1e-05, 8.3e-06}},
};

// Vectors (math/vec.h). The largest errors are derived, u = epsilon / 2 being at most one ulp: a square errs by u, a
// sum of three terms by 2 u, root, quotient and product by u each; a root halves what is under it.
/// Of |a|: 3/2 u + u.
template <class F>
inline constexpr UlpBound length_error = {2.5, 1.2};
/// Of a component of a / |a|: 3/2 u + 3 u.
template <class F>
inline constexpr UlpBound normalize_error = {4.5, 2.2};
/// Of a.b, in ulps of the sum of the magnitudes of its terms: 3 u.
template <class F>
inline constexpr UlpBound dot_error = {3, 1.3};

/// How far the precision fast may be from double on ordinary directions and highlights, for a light of radiance 1: of
/// the radiance where that is above 1. A quarter more than 40,000 inputs showed (tests/unit/shading/test_fast.cpp); the
/// exponents are 1 to 1000, the table is nylon-like.
struct FastBound {
  std::string_view function;
  double max, p99;
};
inline constexpr FastBound fast_bounds[] = {
    {"phong", 3.6e-06, 2.4e-06},
    {"blinn_phong", 3.7e-06, 2.5e-06},
    {"microfacet", 2.1e-06, 6.6e-07},
    {"merl trilinear", 0.00048, 0.00039},
    {"merl trilinear-log", 1.4e-05, 1.1e-05},
    {"merl tricubic-log", 1.5e-05, 1.1e-05},
};

} // namespace refraster
