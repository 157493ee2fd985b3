#pragma once
// Reading tables with indices that were computed in a Number.

#include "math/vec.h"
#include "math/wide.h"

namespace refraster {

/// The table value at (i, j, k). fetch(i, j, k) takes plain integers and returns Rgb<RealOf<T>>.
/// A bounds type overloads this: there an index is a range, and the result is the hull over it.
template <std::floating_point T, class Fetch>
Rgb<T> lookup(const Fetch& fetch, std::int32_t i, std::int32_t j, std::int32_t k) {
  return fetch(i, j, k);
}

template <class T, class Fetch>
  requires(NumberTraits<T>::lanes > 1)
Rgb<T> lookup(const Fetch& fetch, IndexOf<T> i, IndexOf<T> j, IndexOf<T> k) {
  Rgb<T> result;
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
    const Rgb<RealOf<T>> value = fetch(i.i[lane], j.i[lane], k.i[lane]);
    result.x.set(lane, value.x);
    result.y.set(lane, value.y);
    result.z.set(lane, value.z);
  }
  return result;
}

} // namespace refraster
