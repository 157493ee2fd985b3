#pragma once
// A grid whose samples are known, for the laws of reading one.

#include "math/read_grid.h"

#include <array>
#include <cstdint>

namespace refraster {

/// A straight line between samples k^2 of a grid, as a filter reads it.
template <Number T>
T squares_at(const T& x, GridAxis axis) {
  return read_grid(std::array{x}, std::array{axis}, [&](const std::array<Cell<T>, 1>& cell) {
    const auto place = [&](IndexOf<T> k) {
      return axis.beyond == GridAxis::Beyond::repeated ? wrap_index(k, axis.count) : clamp_index(k, 0, axis.count - 1);
    };
    const auto value = [&](IndexOf<T> k) {
      const auto fetch = [](std::int32_t i, std::int32_t, std::int32_t) { return Rgb<double>(i * i, 0, 0); };
      return stored_value<T>(fetch, place(k), 0, 0).x;
    };
    const T low = value(cell[0].index), high = value(next_index(cell[0].index));
    return low + (high - low) * cell[0].fraction;
  });
}

} // namespace refraster
