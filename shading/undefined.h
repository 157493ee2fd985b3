#pragma once
// What the mathematics leaves undefined, a fragment function defines and counts, so that a run report can say how
// often a pixel rests on a convention instead of a formula.

#include "math/lanes/wide.h"

#include <array>
#include <cstdint>
#include <string_view>

namespace refraster {

enum class Undefined {
  zero_normal,      // the interpolated normal is 0: the triangle's own normal is used
  no_normal,        // and that is 0 too: ambient light only
  eye_at_surface,   // the camera is at the surface point: no direction to the eye, v = 0
  light_at_surface, // the light is at the surface point: no direction to it, contributes 0
  no_half_vector,   // l = -v: no half vector, no lobe
  zero_to_the_zero, // glossiness 0 and a cosine of 0: 0^0 = 1
  unmeasured_brdf,  // every table sample around the direction is marked as never measured: 0
  not_finite,       // overflow in a channel: the largest finite number; NaN: 0
  bad_uv,           // a texture coordinate is NaN or infinite: taken as 0
  count_
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(Undefined::count_)> undefined_names = {
    "zero_normal",     "no_normal",  "eye_at_surface", "light_at_surface", "no_half_vector", "zero_to_the_zero",
    "unmeasured_brdf", "not_finite", "bad_uv"};

/// How often each case was met: per light and shaded sample where it concerns a light.
struct UndefinedCounts {
  std::array<std::uint64_t, static_cast<std::size_t>(Undefined::count_)> counts{};

  std::uint64_t& operator[](Undefined which) { return counts[static_cast<std::size_t>(which)]; }
  std::uint64_t operator[](Undefined which) const { return counts[static_cast<std::size_t>(which)]; }
  UndefinedCounts& operator+=(const UndefinedCounts& other) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
    return *this;
  }
};

/// Counts, in those lanes that hold a fragment.
template <class T>
class UndefinedTally {
public:
  UndefinedTally(UndefinedCounts& counts, const MaskOf<T>& in_use) : counts_(&counts), in_use_(in_use) {}

  void note(Undefined which, const MaskOf<T>& where) const {
    if (any(where)) (*counts_)[which] += static_cast<std::uint64_t>(count_lanes(where & in_use_));
  }

private:
  UndefinedCounts* counts_;
  MaskOf<T> in_use_;
};

} // namespace refraster
