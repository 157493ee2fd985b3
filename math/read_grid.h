#pragma once
// Reading a grid of stored values at a place that was computed in a Number: one operation, place in, value out.

#include "math/half.h"
#include "math/vec.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace refraster::inline REFRASTER_KIT {

/// Colours in memory, channels interleaved: red of (i, j, k) is values[i i_stride + j j_stride + k k_stride]. All
/// offsets fit 31 bits. Lanes load four values at a time: `values` are those of a PaddedVector.
template <class F, class Value>
struct RgbGrid {
  using Stored = Value;
  const Stored* values;
  std::int32_t i_stride, j_stride, k_stride;

  Rgb<F> operator()(std::int32_t i, std::int32_t j, std::int32_t k) const {
    const Stored* const at = values + (i * i_stride + j * j_stride + k * k_stride);
    return {static_cast<F>(at[0]), static_cast<F>(at[1]), static_cast<F>(at[2])};
  }
};

/// The value stored at (i, j, k), in each lane. fetch(i, j, k) takes plain integers and returns Rgb<RealOf<T>>; or it
/// is an RgbGrid. It enters a formula as a parameter does.
template <class T, class Fetch>
  requires(!NumberTraits<T>::has_lanes)
Rgb<T> stored_value(const Fetch& fetch, std::int32_t i, std::int32_t j, std::int32_t k) {
  return as<T>(fetch(i, j, k));
}

template <class T, class Fetch>
  requires(NumberTraits<T>::has_lanes)
Rgb<T> stored_value(const Fetch& fetch, IndexOf<T> i, IndexOf<T> j, IndexOf<T> k) {
  constexpr int lanes = NumberTraits<T>::lanes;
  if constexpr (requires { typename Fetch::Stored; }) { // a grid: a colour is one load, three times as fast as gathers
    const auto offset = i.i * fetch.i_stride + j.i * fetch.j_stride + k.i * fetch.k_stride;
    const auto stored =
        gather_rows<typename Fetch::Stored, lanes>([&](int lane) { return fetch.values + offset[lane]; });
    const auto channel = [&](std::size_t c) -> T { return __builtin_convertvector(stored[c].v, typename T::Lanes); };
    return {channel(0), channel(1), channel(2)};
  } else {
    Rgb<T> result;
    for (int lane = 0; lane < lanes; ++lane) {
      const Rgb<RealOf<T>> value = fetch(i.i[lane], j.i[lane], k.i[lane]);
      result.x.set(lane, value.x);
      result.y.set(lane, value.y);
      result.z.set(lane, value.z);
    }
    return result;
  }
}

/// How a grid goes on beyond its samples 0 to count - 1 along one axis. It tells a bounds number which cells are alike;
/// read() itself clamps or wraps its indices.
struct GridAxis {
  enum class Beyond { clamped, repeated } beyond = Beyond::clamped;
  std::int32_t count = 1;
};

/// A read that looks at more than eight samples of a cell, and at how many.
template <std::int64_t count, class Read>
struct ReadOfMany : Read {
  static constexpr std::int64_t samples = count;
};
template <std::int64_t count, class Read>
ReadOfMany<count, Read> read_of_many(Read read) {
  return {std::move(read)};
}

/// The value of a grid at a place, in cells: read(cells) interpolates within the cell that each coordinate lies in, by
/// the samples around it (clamp_index, wrap_index, next_index, stored_value) and the fractions.
/// A number that decides has one cell a lane. A bounds number reads every cell that it may lie in, each with the part
/// of its range that lies there, so that index and fraction stay together, and joins the values.
template <Number T, std::size_t dimensions, class Read>
auto read_grid(const std::array<T, dimensions>& place, const std::array<GridAxis, dimensions>& axes, const Read& read) {
  if constexpr (NumberTraits<T>::decides) {
    std::array<Cell<T>, dimensions> cells;
    for (std::size_t d = 0; d < dimensions; ++d) cells[d] = floor_and_fraction(place[d]);
    return read(cells);
  } else {
    return read_every_cell(place, axes, read); // of the number
  }
}

/// The same where read(cells) jumps from cell to cell: bounds that follow paths read one cell on each.
template <Number T, std::size_t dimensions, class Read>
auto read_nearest(const std::array<T, dimensions>& place, const std::array<GridAxis, dimensions>& axes,
                  const Read& read) {
  if constexpr (requires { read_one_cell(place, axes, read); }) return read_one_cell(place, axes, read);
  else return read_grid(place, axes, read);
}

} // namespace refraster::inline REFRASTER_KIT
