#pragma once
// Four numbers that stand side by side in memory, read for each lane from a place of its own: four vectors, one for
// each of the numbers. A load of a whole row and a transposition cost a third of four gathers, which fetch number by
// number.

#include "math/lanes/wide.h"

#include <array>
#include <cstddef>
#include <cstring>

namespace refraster::inline REFRASTER_KIT {

namespace rows {

template <class F, int N>
Wide<F, N> load(const F* at) {
  Wide<F, N> x;
  std::memcpy(&x.v, at, sizeof x.v);
  return x;
}

/// Two of the four lanes of each group of a and b: lane k of a group comes from lane `pick`[k] of a and b together, in
/// each group by itself. These patterns are single instructions of every x86 vector unit.
template <int p0, int p1, int p2, int p3, class F, int N>
Wide<F, N> shuffled(const Wide<F, N>& a, const Wide<F, N>& b) {
  constexpr int pick[] = {p0, p1, p2, p3}; // 0 to 3: of a; 4 to 7: of b
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return Wide<F, N>(__builtin_shufflevector(a.v, b.v, (I / 4 * 4 + pick[I % 4] % 4 + (pick[I % 4] < 4 ? 0 : N))...));
  }
  (std::make_integer_sequence<int, N>{});
}

} // namespace rows

/// Lane 4 g + k of result i is lane 4 g + i of x[k]: a transposition of each group of four lanes.
template <class F, int N>
std::array<Wide<F, N>, 4> transposed(const std::array<Wide<F, N>, 4>& x) {
  using rows::shuffled;
  if constexpr (sizeof(F) == 4) {
    const Wide<F, N> a = shuffled<0, 4, 1, 5>(x[0], x[1]), b = shuffled<2, 6, 3, 7>(x[0], x[1]);
    const Wide<F, N> c = shuffled<0, 4, 1, 5>(x[2], x[3]), d = shuffled<2, 6, 3, 7>(x[2], x[3]);
    return {shuffled<0, 1, 4, 5>(a, c), shuffled<2, 3, 6, 7>(a, c), shuffled<0, 1, 4, 5>(b, d),
            shuffled<2, 3, 6, 7>(b, d)};
  } else {
    const Wide<F, N> a = shuffled<0, 4, 2, 6>(x[0], x[1]), b = shuffled<1, 5, 3, 7>(x[0], x[1]);
    const Wide<F, N> c = shuffled<0, 4, 2, 6>(x[2], x[3]), d = shuffled<1, 5, 3, 7>(x[2], x[3]);
    return {shuffled<0, 1, 4, 5>(a, c), shuffled<0, 1, 4, 5>(b, d), shuffled<2, 3, 6, 7>(a, c),
            shuffled<2, 3, 6, 7>(b, d)};
  }
}

/// Result i holds at(lane)[i] in each lane. at(lane) points to four numbers; it need not be aligned.
template <class F, int N, class Place>
std::array<Wide<F, N>, 4> gather_rows(const Place& at) {
  const auto row = [&](int lane) { return rows::load<F, 4>(at(lane)); };
  // x[k] takes the rows of lanes k, k + 4, k + 8 …, so that the lanes come out in order.
  if constexpr (N == 4) {
    return transposed<F, 4>({row(0), row(1), row(2), row(3)});
  } else if constexpr (N == 8) {
    const auto group = [&](int k) { return joined(row(k), row(k + 4)); };
    return transposed<F, 8>({group(0), group(1), group(2), group(3)});
  } else if constexpr (N == 16) {
    const auto group = [&](int k) { return joined(joined(row(k), row(k + 4)), joined(row(k + 8), row(k + 12))); };
    return transposed<F, 16>({group(0), group(1), group(2), group(3)});
  } else {
    std::array<Wide<F, N>, 4> result;
    for (int lane = 0; lane < N; ++lane) {
      for (int i = 0; i < 4; ++i) result[static_cast<std::size_t>(i)].set(lane, row(lane)[i]);
    }
    return result;
  }
}

} // namespace refraster::inline REFRASTER_KIT
