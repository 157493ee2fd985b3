#pragma once
// How far the arithmetic of a device may be from exact, as the parameter of a bounds number.

#include "math/elementary/atan2.h"
#include "math/elementary/cosine_power.h"
#include "math/elementary/exp_log.h"
#include "math/elementary/pow.h"

#include <limits>

namespace refraster::inline REFRASTER_KIT {

enum class Sums { as_written, in_any_order };

/// By functions of their own (math/elementary.h); or x^s by exp2(s log2(x)), and a power of a cosine by that of
/// max(a.b, 0), as shaders have it.
enum class Powers { direct, by_logarithm };

/// A rounding budget is a type with these members. Each operation's computed result differs from the exact result of
/// its operands, as they were computed, by at most what is said here.
///   relative, absolute   + - * and the conversion of a parameter: |error| <= relative |exact| + absolute
///   quotient_relative, root_relative   instead of `relative`: of / and of the square root
///   largest              magnitudes above it may come out as infinity
///   smallest_normal      what is positive and below it may count as 0, or as it
///   cut_off              exp2, pow and cosine_power may be 0 where the exact result is below 2^cut_off
///   log2_units, exp2_units, pow_units, atan2_units   errors of these, in units of 2 relative |result|: at least as
///                        large as that many units in the last place
///   log2_absolute        what log2 may err beside that
///   exp2_units_by_exponent   what is added to exp2_units for each 1 of |x|
///   sums                 whether dot products may be added up in another order than the formula's, or fused
///   powers               how pow and cosine_power are computed

/// Strict arithmetic of the precision `double`.
struct DoubleArithmetic {
  static constexpr double relative = 0x1p-53, absolute = 0x1p-1074;
  static constexpr double quotient_relative = relative, root_relative = relative;
  static constexpr double smallest_normal = std::numeric_limits<double>::min();
  static constexpr double largest = std::numeric_limits<double>::max(), cut_off = lowest_power<double>;
  static constexpr double log2_units = log2_error<double>.max, exp2_units = exp2_error<double>.max,
                          pow_units = pow_error<double>.max, atan2_units = 2; // of tiny results; else atan2_error
  static constexpr double log2_absolute = 0, exp2_units_by_exponent = 0;
  static constexpr Sums sums = Sums::as_written;
  static constexpr Powers powers = Powers::direct;
};

/// Strict arithmetic of the precision `float`.
struct FloatArithmetic {
  static constexpr double relative = 0x1p-24, absolute = 0x1p-150;
  static constexpr double quotient_relative = relative, root_relative = relative;
  static constexpr double smallest_normal = static_cast<double>(std::numeric_limits<float>::min());
  static constexpr double largest = static_cast<double>(std::numeric_limits<float>::max()),
                          cut_off = lowest_power<float>;
  static constexpr double log2_units = log2_error<float>.max, exp2_units = exp2_error<float>.max,
                          pow_units = pow_error<float>.max, atan2_units = 2; // likewise
  static constexpr double log2_absolute = 0, exp2_units_by_exponent = 0;
  static constexpr Sums sums = Sums::as_written;
  static constexpr Powers powers = Powers::direct;
};

} // namespace refraster::inline REFRASTER_KIT
