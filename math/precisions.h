#pragma once
// The number behind each precision.

#include <refraster/frame.h>

#include "math/lanes/wide.h"

#include <string_view>
#include <tuple>

namespace refraster::inline REFRASTER_KIT {

/// The number with as many lanes of F as a vector register of this build holds.
template <class F>
using Native = Wide<F, native_vector_bytes / static_cast<int>(sizeof(F))>;

struct DoublePrecision {
  static constexpr Precision id = Precision::double_;
  static constexpr std::string_view name = name_of(id);
  static constexpr std::string_view purpose = "reference, default";
  using Number = Native<double>;
  static constexpr int lanes = NumberTraits<Number>::lanes; // fragments at once
};

struct FloatPrecision {
  static constexpr Precision id = Precision::float_;
  static constexpr std::string_view name = name_of(id);
  static constexpr std::string_view purpose = "speed, with GPU-like arithmetic";
  using Number = Native<float>;
  static constexpr int lanes = NumberTraits<Number>::lanes;
};

struct FastPrecision {
  static constexpr Precision id = Precision::fast;
  static constexpr std::string_view name = name_of(id);
  static constexpr std::string_view purpose = "more speed, last bits of float given up";
  using Number = Wide<float, native_vector_bytes / 4, Arithmetic::fast>;
  static constexpr int lanes = NumberTraits<Number>::lanes;
};

class Exact; // math/exact.h

/// Samples one by one in 60 digits: slow. What the others are judged by. It starts from what the vertex stage stores.
struct ExactPrecision {
  static constexpr Precision id = Precision::exact;
  static constexpr std::string_view name = name_of(id);
  static constexpr std::string_view purpose = "truth: the same formulas in 60 digits; slow";
  using Number = Exact;
  static constexpr int lanes = 1;
};

/// Those that shade a register of fragments at a time: what is measured for its speed.
using LanePrecisions = std::tuple<DoublePrecision, FloatPrecision, FastPrecision>;

/// Every precision a frame can be rendered in. The order is that of `refraster list precisions`; nothing else depends
/// on it.
using Precisions = decltype(std::tuple_cat(LanePrecisions{}, std::tuple<ExactPrecision>{}));

} // namespace refraster::inline REFRASTER_KIT
