#pragma once
// What a fragment function of one's own is given across the border of the library: plain arrays, the same for every
// instruction set on either side.

#include <refraster/frame.h>

#include "shading/light_spans.h"

#include <cstdint>

namespace refraster {

/// The arithmetic that a batch is to be shaded in, and how its values are stored.
enum class BatchNumber {
  double_lanes,  // double
  float_lanes,   // float
  fast_lanes,    // float, with Arithmetic::fast
  exact,         // Exact::Value
  double_bounds, // two doubles: the ends of an Interval<DoubleArithmetic>
  float_bounds   // the same for FloatArithmetic
};

/// Fragments of one material. A row holds one component of all of them.
struct FragmentBatch {
  /// Rows of `values`: what Fragment<T> holds, component by component.
  enum Row { position = 0, normal = 3, to_eye = 6, texture = 9, rows = 12 };
  /// What is wanted.
  enum class Wanted {
    radiance, // toward the eye: the ambient term and all lights, each value finite
    albedo    // what the surface reflects of white light from the front, for the AOV of that name
  };
  /// Rows are padded to a multiple of so many: the widest register has as many lanes.
  static constexpr std::uint32_t padding = 16;

  BatchNumber number = BatchNumber::double_lanes;
  Wanted wanted = Wanted::radiance;
  std::uint32_t fragments = 0;  // in a row; those after them up to the stride may be computed, and count for nothing
  std::uint32_t stride = 0;     // values from one row to the next: a multiple of `padding`
  const void* values = nullptr; // `rows` rows
  void* rgb = nullptr;          // three rows: what is made
  LightSpans lights;
  UndefinedCounts* undefined = nullptr; // to be added to
  LightVisibility visibility = {};      // of its fragments; of scenes with shadows
};

} // namespace refraster
