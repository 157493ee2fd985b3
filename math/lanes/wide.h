#pragma once
// N numbers at once: a thin layer over the compilers' vector extensions (GCC and clang). Each lane holds the same
// bits as the scalar operation would give: only IEEE operations are used, and no estimate instructions.
// With N = 1 use the plain float or double: the formulas are the same.

#include "math/lanes/registers.h"
#include "math/number.h"

#include <array>
#include <bit>
#include <utility>

namespace refraster {
struct Half; // math/half.h
} // namespace refraster

namespace refraster::inline REFRASTER_KIT {

template <class F, int N>
using VectorOf [[gnu::vector_size(sizeof(F) * N)]] = F;

/// Bytes of the widest vector register the build may use.
#if defined(__AVX512F__)
inline constexpr int native_vector_bytes = 64;
#elif defined(__AVX2__)
inline constexpr int native_vector_bytes = 32;
#else
inline constexpr int native_vector_bytes = 16;
#endif

/// What comparing two Wide gives: all bits of a lane set, or none; or, where the machine has mask registers for vectors
/// of this size, a bit for each lane.
template <class F, int N>
struct WideMask {
  using Lanes = VectorOf<BitsOf<F>, N>;
  Lanes m;

  friend WideMask operator&(WideMask a, WideMask b) { return {a.m & b.m}; }
  friend WideMask operator|(WideMask a, WideMask b) { return {a.m | b.m}; }
  friend WideMask operator!(WideMask a) { return {~a.m}; }
};

template <class F, int N>
  requires(registers::has_mask<F, N>)
struct WideMask<F, N> {
  registers::LaneMask<N> m;

  friend WideMask operator&(WideMask a, WideMask b) { return {static_cast<registers::LaneMask<N>>(a.m & b.m)}; }
  friend WideMask operator|(WideMask a, WideMask b) { return {static_cast<registers::LaneMask<N>>(a.m | b.m)}; }
  friend WideMask operator!(WideMask a) { return {static_cast<registers::LaneMask<N>>(~a.m)}; }
};

/// N integers of 32 bits, for table look-ups.
template <int N>
struct WideIndex {
  using Lanes = VectorOf<std::int32_t, N>;
  Lanes i;
};

/// What an operation on lanes may do.
///   strict  IEEE operations only, each rounded once: the same bits in every lane as alone, and on every machine
///   fast    multiplications and additions fused, reciprocal roots estimated and refined, shorter polynomials: a number
///           type of its own, so that nothing strict can be compiled in a fast way. Last bits differ between machines.
enum class Arithmetic { strict, fast };

/// N lanes of F. Trivial, so that glm::vec can hold it; default construction leaves the lanes undefined.
template <class F, int N, Arithmetic A = Arithmetic::strict>
struct Wide {
  static_assert(N >= 2 && (N & (N - 1)) == 0);
  using Lanes = VectorOf<F, N>;
  Lanes v;

  Wide() = default;
  Wide(Lanes lanes) : v(lanes) {}
  template <class Plain>
    requires std::is_arithmetic_v<Plain>
  explicit(!std::same_as<Plain, F>) Wide(Plain x) : v(static_cast<F>(x) - Lanes{}) {} // x - 0 keeps the sign of zero

  F operator[](int lane) const { return v[lane]; }
  void set(int lane, F x) { v[lane] = x; }

  friend Wide operator+(Wide a, Wide b) { return a.v + b.v; }
  friend Wide operator-(Wide a, Wide b) { return a.v - b.v; }
  friend Wide operator*(Wide a, Wide b) { return a.v * b.v; }
  friend Wide operator/(Wide a, Wide b) { return a.v / b.v; }
  friend Wide operator-(Wide a) { return -a.v; }
  Wide& operator+=(Wide b) { return *this = *this + b; }
  Wide& operator-=(Wide b) { return *this = *this - b; }
  Wide& operator*=(Wide b) { return *this = *this * b; }
  Wide& operator/=(Wide b) { return *this = *this / b; }

  using Mask = WideMask<F, N>;
  friend Mask operator<(Wide a, Wide b) {
    if constexpr (registers::has_mask<F, N>) return {registers::less(a.v, b.v)};
    else return {a.v < b.v};
  }
  friend Mask operator>(Wide a, Wide b) {
    if constexpr (registers::has_mask<F, N>) return {registers::greater(a.v, b.v)};
    else return {a.v > b.v};
  }
  friend Mask operator<=(Wide a, Wide b) {
    if constexpr (registers::has_mask<F, N>) return {registers::less_equal(a.v, b.v)};
    else return {a.v <= b.v};
  }
  friend Mask operator>=(Wide a, Wide b) {
    if constexpr (registers::has_mask<F, N>) return {registers::greater_equal(a.v, b.v)};
    else return {a.v >= b.v};
  }
  friend Mask operator==(Wide a, Wide b) {
    if constexpr (registers::has_mask<F, N>) return {registers::equal(a.v, b.v)};
    else return {a.v == b.v};
  }
};

template <class F, int N>
inline constexpr bool is_fast<Wide<F, N, Arithmetic::fast>> = true;

template <class F, int N, Arithmetic A>
struct NumberTraits<Wide<F, N, A>> {
  using Real = F;
  using Mask = WideMask<F, N>;
  using Index = WideIndex<N>;
  static constexpr int lanes = N;
  static constexpr bool has_lanes = true, decides = true, is_ieee = true;
  static constexpr double largest = static_cast<double>(std::numeric_limits<F>::max());
};

template <int N>
struct NumberTraits<Wide<float, N, Arithmetic::fast>> : NumberTraits<Wide<float, N, Arithmetic::strict>> {
  using TableReal = Half;
};

template <class F, int N, Arithmetic A>
Wide<F, N, A> select(WideMask<F, N> m, Wide<F, N, A> x, Wide<F, N, A> y) {
  if constexpr (registers::has_mask<F, N>) return VectorOf<F, N>(registers::select(m.m, x.v, y.v));
  else return m.m ? x.v : y.v;
}
template <class F, int N, Arithmetic A>
Wide<F, N, A> max(Wide<F, N, A> x, Wide<F, N, A> y) {
  if constexpr (requires { registers::max(x.v, y.v); }) return VectorOf<F, N>(registers::max(x.v, y.v));
  else return x.v > y.v ? x.v : y.v;
}
template <class F, int N, Arithmetic A>
Wide<F, N, A> min(Wide<F, N, A> x, Wide<F, N, A> y) {
  if constexpr (requires { registers::min(x.v, y.v); }) return VectorOf<F, N>(registers::min(x.v, y.v));
  else return x.v < y.v ? x.v : y.v;
}
template <class F, int N, Arithmetic A>
Wide<F, N, A> square(Wide<F, N, A> x) {
  return x.v * x.v;
}

/// The bits of each lane as an integer, and back.
template <class F, int N, Arithmetic A>
VectorOf<BitsOf<F>, N> bits_of(Wide<F, N, A> x) {
  return reinterpret_cast<VectorOf<BitsOf<F>, N>>(x.v);
}
template <class F, int N, Arithmetic A = Arithmetic::strict>
Wide<F, N, A> from_bits(VectorOf<BitsOf<F>, N> bits) {
  return reinterpret_cast<VectorOf<F, N>>(bits);
}

template <class F, int N, Arithmetic A>
Wide<F, N, A> abs(Wide<F, N, A> x) {
  return from_bits<F, N, A>(bits_of(x) & std::numeric_limits<BitsOf<F>>::max());
}

template <class F, int N, Arithmetic A>
Wide<F, N, A> sqrt(Wide<F, N, A> x) {
  if constexpr (requires { registers::sqrt(x.v); }) return VectorOf<F, N>(registers::sqrt(x.v));
  Wide<F, N, A> result;
  for (int lane = 0; lane < N; ++lane) result.v[lane] = sqrt(x.v[lane]);
  return result;
}

/// a b + c in one rounding, where the machine can.
template <class F, int N>
Wide<F, N, Arithmetic::fast> multiply_add(Wide<F, N, Arithmetic::fast> a, Wide<F, N, Arithmetic::fast> b,
                                          Wide<F, N, Arithmetic::fast> c) {
  if constexpr (requires { registers::fused_sum(a.v, b.v, c.v); })
    return VectorOf<F, N>(registers::fused_sum(a.v, b.v, c.v));
  else return a * b + c;
}

/// 1 / sqrt(x) for 0 < x, neither tiny nor huge: an estimate of at least 11 bits, and one step of Newton's method.
template <int N>
Wide<float, N, Arithmetic::fast> reciprocal_root(Wide<float, N, Arithmetic::fast> x) {
  using T = Wide<float, N, Arithmetic::fast>;
  if constexpr (requires { registers::reciprocal_root_estimate(x.v); }) {
    const T y = VectorOf<float, N>(registers::reciprocal_root_estimate(x.v));
    return y * multiply_add(x * T(-0.5f) * y, y, T(1.5f));
  } else {
    return T(1) / sqrt(x);
  }
}

/// a b - c, rounded once: only where the machine has it.
template <class F, int N, Arithmetic A>
  requires(requires(VectorOf<F, N> v) { registers::fused_difference(v, v, v); })
Wide<F, N, A> fused_difference(Wide<F, N, A> a, Wide<F, N, A> b, Wide<F, N, A> c) {
  return VectorOf<F, N>(registers::fused_difference(a.v, b.v, c.v));
}

template <class F, int N, Arithmetic A>
Wide<F, N, A> exact_reciprocal(Wide<F, N, A> s) {
  using B = BitsOf<F>;
  constexpr B one_squared = B(2 * (std::numeric_limits<F>::max_exponent - 1)) << fraction_bits<F>;
  return from_bits<F, N, A>(one_squared - bits_of(s));
}

template <class F, int N, Arithmetic A>
Wide<F, N, A> reciprocal_binade(Wide<F, N, A> x) {
  using B = BitsOf<F>;
  constexpr B bias = std::numeric_limits<F>::max_exponent - 1;
  constexpr B exponent_mask = (2 * bias + 1) << fraction_bits<F>;
  constexpr F smallest = std::numeric_limits<F>::min();
  const Wide<F, N, A> binade = from_bits<F, N, A>(bits_of(x) & exponent_mask);
  const Wide<F, N, A> inside = min(max(binade, Wide<F, N, A>(smallest)), Wide<F, N, A>(1 / smallest));
  return from_bits<F, N, A>((2 * bias << fraction_bits<F>)-bits_of(inside));
}

/// |x| <= 2^30 rounded toward minus infinity; the argument is kept within that range.
template <class F, int N, Arithmetic A>
Cell<Wide<F, N, A>> floor_and_fraction(Wide<F, N, A> x) {
  using T = Wide<F, N, A>;
  const T limit(cell_limit);
  const T inside = min(max(x, -limit), limit);
  // Truncate, then step down where that went up: no rounding-mode instruction is needed, and the result is exact.
  const VectorOf<std::int32_t, N> toward_zero = __builtin_convertvector(inside.v, VectorOf<std::int32_t, N>);
  const T truncated(__builtin_convertvector(toward_zero, VectorOf<F, N>));
  const T below = select(truncated > inside, truncated - T(1), truncated);
  const T fraction = min(max(inside - below, T(F(0))), T(almost_one<F>)); // see the scalar
  return {{__builtin_convertvector(below.v, VectorOf<std::int32_t, N>)}, fraction};
}

template <class F, int N, Arithmetic A>
Wide<F, N, A> fraction(Wide<F, N, A> x) {
  return floor_and_fraction(x).fraction;
}

template <int N>
WideIndex<N> clamp_index(WideIndex<N> i, std::int32_t lo, std::int32_t hi) {
  const VectorOf<std::int32_t, N> low = lo - VectorOf<std::int32_t, N>{}, high = hi - VectorOf<std::int32_t, N>{};
  const VectorOf<std::int32_t, N> raised = i.i < low ? low : i.i;
  return {raised > high ? high : raised};
}

template <int N>
WideIndex<N> wrap_index(WideIndex<N> index, std::int32_t n) {
  using Ints = VectorOf<std::int32_t, N>;
  Ints i = index.i;
  if ((n & (n - 1)) == 0) return {i & (n - 1)}; // two's complement: right for negative i too
  if constexpr (N > 2 && N * static_cast<int>(sizeof(double)) > native_vector_bytes) {
    // By halves: doubles of all lanes are more than a register, which GCC 12 does not compile without optimisation.
    auto half = std::bit_cast<std::array<WideIndex<N / 2>, 2>>(i);
    for (WideIndex<N / 2>& h : half) h = wrap_index(h, n);
    return std::bit_cast<WideIndex<N>>(half);
  }
  // An estimate of the quotient in double (error < 1 for |i| < 2^31), then one step up or down.
  using Doubles = VectorOf<double, N>;
  const Doubles quotient = __builtin_convertvector(i, Doubles) * (1.0 / n);
  i = i - __builtin_convertvector(quotient, Ints) * n;
  i = i < 0 ? i + n : i;
  i = i >= n ? i - n : i;
  return {i};
}

template <int N>
WideIndex<N> next_index(WideIndex<N> i) {
  return {i.i + 1};
}

/// One bit a lane, lane 0 the lowest.
template <class F, int N>
std::uint32_t lane_set(WideMask<F, N> m) {
  if constexpr (registers::has_mask<F, N>) {
    return m.m;
  } else if constexpr (requires(VectorOf<F, N> v) { registers::sign_bits(v); }) {
    return registers::sign_bits(std::bit_cast<VectorOf<F, N>>(m.m));
  } else {
    std::uint32_t set = 0;
    for (int lane = 0; lane < N; ++lane) set |= static_cast<std::uint32_t>(m.m[lane] & 1) << lane;
    return set;
  }
}

/// All bits of an integer lane set where m is, and none elsewhere.
template <class F, int N>
VectorOf<BitsOf<F>, N> lane_bits(WideMask<F, N> m) {
  if constexpr (registers::has_mask<F, N>) {
    const VectorOf<BitsOf<F>, N> ones = ~VectorOf<BitsOf<F>, N>{};
    return std::bit_cast<VectorOf<BitsOf<F>, N>>(
        registers::select(m.m, std::bit_cast<VectorOf<F, N>>(ones), VectorOf<F, N>{}));
  } else {
    return m.m;
  }
}

/// The first and the last N / 2 lanes; and two such halves put together.
template <class F, int N, Arithmetic A>
Wide<F, N / 2, A> low_half(const Wide<F, N, A>& x) {
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return Wide<F, N / 2, A>(__builtin_shufflevector(x.v, x.v, I...));
  }
  (std::make_integer_sequence<int, N / 2>{});
}
template <class F, int N, Arithmetic A>
Wide<F, N / 2, A> high_half(const Wide<F, N, A>& x) {
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return Wide<F, N / 2, A>(__builtin_shufflevector(x.v, x.v, (I + N / 2)...));
  }
  (std::make_integer_sequence<int, N / 2>{});
}
template <class F, int N, Arithmetic A>
Wide<F, 2 * N, A> joined(const Wide<F, N, A>& low, const Wide<F, N, A>& high) {
  return [&]<int... I>(std::integer_sequence<int, I...>) {
    return Wide<F, 2 * N, A>(__builtin_shufflevector(low.v, high.v, I...));
  }
  (std::make_integer_sequence<int, 2 * N>{});
}

template <class F, int N>
int count_lanes(WideMask<F, N> m) {
  return std::popcount(lane_set(m));
}
template <class F, int N>
bool any(WideMask<F, N> m) {
  return lane_set(m) != 0;
}

/// The lanes [0, count) are set.
template <class F, int N>
WideMask<F, N> first_lanes(int count) {
  WideMask<F, N> result;
  if constexpr (registers::has_mask<F, N>) result.m = static_cast<registers::LaneMask<N>>((1u << count) - 1);
  else
    for (int lane = 0; lane < N; ++lane) result.m[lane] = lane < count ? -1 : 0;
  return result;
}

} // namespace refraster::inline REFRASTER_KIT
