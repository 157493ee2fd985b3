#pragma once
// Constants that no floating-point number holds. A formula names the constant; each number takes of it what it can:
// lanes the nearest number, bounds an enclosure, 60 digits 60 digits.

#include "math/number.h"

#include <numbers>

namespace refraster::inline REFRASTER_KIT {

/// A real number. `nearest` is the double nearest to it; `digits` are decimal digits enough for every number type.
struct RealConstant {
  double nearest;
  const char* digits;
};

namespace constants {
inline constexpr RealConstant pi = {std::numbers::pi,
                                    "3.14159265358979323846264338327950288419716939937510582097494459230781640628621"};
inline constexpr RealConstant half_pi = {
    std::numbers::pi / 2, "1.57079632679489661923132169163975144209858469968755291048747229615390820314310"};
inline constexpr RealConstant one_over_pi = {
    1 / std::numbers::pi, "0.318309886183790671537767526745028724068919291480912897495334688117793595268453"};
inline constexpr RealConstant two_over_pi = {
    2 / std::numbers::pi, "0.636619772367581343075535053490057448137838582961825794990669376235587190536906"};
inline constexpr RealConstant degrees_per_radian = {
    180 / std::numbers::pi, "57.2957795130823208767981548141051703324054724665643215491602438612028471483215"};
} // namespace constants

/// The constant as T has it: rounded once.
template <Number T>
T constant(const RealConstant& c) {
  if constexpr (requires { NumberTraits<T>::constant(c); }) return NumberTraits<T>::constant(c);
  else return as<T>(c.nearest);
}

} // namespace refraster::inline REFRASTER_KIT
