#pragma once
// The list of precision rungs. A rung is a number type for attribute interpolation and shading; which triangle a
// sample sees is decided before, once, for all of them.

#include "math/lanes/wide.h"

#include <string_view>
#include <tuple>

namespace refraster {

/// The number with as many lanes of F as a vector register of this build holds.
template <class F>
using Native = Wide<F, native_vector_bytes / static_cast<int>(sizeof(F))>;

struct DoubleRung {
  static constexpr std::string_view name = "double";
  static constexpr std::string_view purpose = "reference, default";
  using Number = Native<double>;
  static constexpr int lanes = NumberTraits<Number>::lanes; // fragments at once
};

struct FloatRung {
  static constexpr std::string_view name = "float";
  static constexpr std::string_view purpose = "speed, with GPU-like arithmetic";
  using Number = Native<float>;
  static constexpr int lanes = NumberTraits<Number>::lanes;
};

struct FastRung {
  static constexpr std::string_view name = "fast";
  static constexpr std::string_view purpose = "more speed, last bits of float given up";
  using Number = Wide<float, native_vector_bytes / 4, Arithmetic::quick>;
  static constexpr int lanes = NumberTraits<Number>::lanes;
};

class Exact; // math/exact.h

/// Samples one by one in 60 digits: slow. What the others are judged by. It starts from what the vertex stage stores.
struct ExactRung {
  static constexpr std::string_view name = "exact";
  static constexpr std::string_view purpose = "truth: the same formulas in 60 digits; slow";
  using Number = Exact;
  static constexpr int lanes = 1;
};

/// Those that shade a register of fragments at a time: what is measured for its speed.
using LaneRungs = std::tuple<DoubleRung, FloatRung, FastRung>;

/// Every rung a frame can be rendered in. The order is that of `refraster list rungs`; nothing else depends on it.
using Rungs = decltype(std::tuple_cat(LaneRungs{}, std::tuple<ExactRung>{}));

} // namespace refraster
