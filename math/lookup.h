#pragma once
// Reading tables with indices that were computed in a Number.

#include "math/half.h"
#include "math/vec.h"

namespace refraster {

/// Colours in memory, channels interleaved: red of (i, j, k) is values[i i_stride + j j_stride + k k_stride]. All
/// offsets fit 31 bits. Reads as Rgb<F>. Lanes load four values at a time: `values` are those of a PaddedVector.
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

/// The table value at (i, j, k). fetch(i, j, k) takes plain integers and returns Rgb<RealOf<T>>; or it is an RgbGrid.
/// A bounds type overloads this: there an index is a range, and the result is the hull over it.
template <std::floating_point T, class Fetch>
Rgb<T> lookup(const Fetch& fetch, std::int32_t i, std::int32_t j, std::int32_t k) {
  return fetch(i, j, k);
}

template <class T, class Fetch>
  requires(NumberTraits<T>::lanes > 1)
Rgb<T> lookup(const Fetch& fetch, IndexOf<T> i, IndexOf<T> j, IndexOf<T> k) {
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

} // namespace refraster
