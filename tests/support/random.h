#pragma once
// Random numbers for tests and measurements.

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace refraster {

/// The same numbers everywhere, unlike those of <random>'s distributions. Steele, Lea, Flood, "Fast splittable
/// pseudorandom number generators", 2014.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 0x6A09E667F3BCC909u) {}
  /// Takes the state of Steele et al. itself, as others write the generator, instead of a seed.
  static Random from_state(std::uint64_t state) {
    Random random(0);
    random.state_ = state;
    return random;
  }

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  /// In [0, n).
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }
  /// In [lo, hi).
  double uniform(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// In [lo, hi), lo > 0: every order of magnitude is as likely.
  double log_uniform(double lo, double hi) { return std::exp2(uniform(std::log2(lo), std::log2(hi))); }
  double sign() { return bits() & 1 ? 1 : -1; }
  /// Any number at all: every pattern of bits is as likely, but for NaN and infinities.
  template <class F>
  F any_finite() {
    using Bits = std::conditional_t<sizeof(F) == 4, std::uint32_t, std::uint64_t>;
    for (;;) {
      const F x = std::bit_cast<F>(static_cast<Bits>(bits()));
      if (std::isfinite(x)) return x;
    }
  }
  /// Mostly the cases that formulas stumble over: zeros, ones, the ends of the range, their neighbours, powers of two.
  template <class F>
  F hard() {
    using Limits = std::numeric_limits<F>;
    constexpr F cases[] = {
        0, -F(0), 1, -1, F(0.5), 2, Limits::min(), Limits::max(), Limits::denorm_min(), Limits::epsilon()};
    switch (below(4)) {
    case 0:
      return cases[below(10)];
    // In statements: in which order a compiler evaluates the arguments of a function, it chooses itself.
    case 1: {
      const F next = std::nextafter(cases[below(10)], F(0.75));
      return next * F(sign());
    }
    case 2: {
      const int exponent = below(2 * Limits::max_exponent) - Limits::max_exponent;
      return std::ldexp(F(sign()), exponent);
    }
    default:
      return any_finite<F>();
    }
  }

private:
  std::uint64_t state_;
};

/// The distance from 1 to the next number of F.
template <class F>
inline constexpr double epsilon_of = static_cast<double>(std::numeric_limits<F>::epsilon());

} // namespace refraster
