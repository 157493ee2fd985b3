// Cosines to a whole power: by squaring, against 60 digits.

#include "math/elementary.h"
#include "math/precisions.h"
#include "tests/support/accuracy.h"

#include <cmath>
#include <vector>

namespace refraster {
namespace {

/// cosine^n, by squaring.
template <class T>
T raised(const T& cosine, const T& q, const CosineExponent<RealOf<T>>& exponent) {
  T power[] = {cosine}, half_square[] = {q};
  raise_cosines(power, half_square, exponent);
  return power[0];
}

/// A cosine as cosine_power has it: near 1 by q, which is then 1 less it.
template <class F>
struct Angle {
  F cosine, q;

  static Angle from(F cosine) { return {cosine, F(0.5)}; } // a q that nobody shall look at
  static Angle near(F q) { return {F(1) - q, q}; }
  Mpfr exact() const { return cosine > F(0.75) ? Mpfr(1 - Mpfr(q)) : Mpfr(cosine); }
};

/// All exponents to 130, every power of two and its neighbours, and some of the others up to the last.
std::vector<std::uint32_t> some_exponents() {
  std::vector<std::uint32_t> exponents;
  for (std::uint32_t n = 1; n <= max_whole_exponent; ++n)
    if (n <= 130 || std::has_single_bit(n) || std::has_single_bit(n + 1) || n % 97 == 0 || n + 2 > max_whole_exponent)
      exponents.push_back(n);
  return exponents;
}

TEST_CASE_TEMPLATE("a whole power is off by its one rounding, down to where products are no longer exact", F, double,
                   float) {
  double worst = 0; // in units of the stated bound
  for (const std::uint32_t n : some_exponents()) {
    const auto exponent = cosine_exponent<F>(n);
    REQUIRE(exponent.whole == n);
    for_all(60, [&](Random& random) {
      const bool close = random.below(2) == 0;
      const double bits = random.log_uniform(1e-3, -lowest_power<F>); // the result is about 2^-bits
      const double cosine = std::exp2(-bits / n);
      const F q = F(1 - cosine);
      if (close && !(q > 0 && F(1) - q > F(0.75))) return;
      if (!close && !(F(cosine) <= F(0.75))) return;
      const auto angle = close ? Angle<F>::near(q) : Angle<F>::from(F(cosine));
      const Mpfr exact = pow(angle.exact(), static_cast<int>(n));
      const Mpfr error = abs(Mpfr(raised(angle.cosine, angle.q, exponent)) - exact) / exact;
      if (exact < Mpfr(smallest_result<F>) * Mpfr(1 + 1e-6)) return;
      const double lost = static_cast<double>(-exact_log2(exact));
      const double units =
          lost <= 959 ? whole_power_error<F>(n) : small_power_error_at_1 + small_power_error_per_bit * lost;
      const double ratio = (error / (units * epsilon_of<F> / 2)).template convert_to<double>();
      if (!(ratio <= 1)) CHECK_MESSAGE(ratio <= 1, "n = ", n, ", cosine = ", angle.cosine, ", q = ", angle.q);
      worst = std::max(worst, ratio);
    });
  }
  CAPTURE(worst);
  CHECK(worst <= 1);
  CHECK(worst > 0.9); // or the bound says too little
}

TEST_CASE_TEMPLATE("a whole power is 1 in the middle and 0 where it is cut, whatever else comes", F, double, float) {
  using Limits = std::numeric_limits<F>;
  const F smallest = F(smallest_result<F>);
  for (const std::uint32_t n : some_exponents()) {
    CAPTURE(n);
    const auto exponent = cosine_exponent<F>(n);
    CHECK(raised(F(1), F(0), exponent) == 1);
    CHECK(raised(F(1), Limits::denorm_min(), exponent) <= 1);
    CHECK(raised(F(1) - Limits::epsilon() / 2, Limits::epsilon() / 2, exponent) < 1);
    for (const F dark : {F(0), -F(0), F(-0.5), F(-1), -Limits::max(), -Limits::infinity(), Limits::quiet_NaN(),
                         Limits::denorm_min(), Limits::min(), std::nextafter(smallest, F(0))})
      CHECK(raised(dark, F(0.5), exponent) == 0);
    // On either side of the cosine whose power is the last that is not cut.
    const F edge = F(std::exp2(lowest_power<F> / n));
    if (edge > F(0.75)) continue;
    const F above = raised(edge * (1 + 2 * Limits::epsilon()), F(0.5), exponent);
    CHECK((above == 0 || above >= smallest));
    CHECK(raised(F(edge * F(1.001)), F(0.5), exponent) >= smallest);
    CHECK(raised(F(edge * F(0.999)), F(0.5), exponent) == 0);
  }
  CHECK(raised(smallest, F(0.5), cosine_exponent<F>(1)) == smallest);
  CHECK(raised(F(0.5), F(0.5), cosine_exponent<F>(-lowest_power<F>)) == smallest);
}

TEST_CASE_TEMPLATE("a whole power has the same bits in every lane, and beside others, as alone", T, Wide<float, 4>,
                   Wide<float, 8>, Wide<float, 16>, Wide<double, 2>, Wide<double, 4>, Wide<double, 8>) {
  using F = RealOf<T>;
  for_all(500, [](Random& random) {
    const std::vector<std::uint32_t> exponents = some_exponents();
    const auto n = exponents[static_cast<std::size_t>(random.below(static_cast<int>(exponents.size())))];
    const auto exponent = cosine_exponent<F>(n);
    constexpr std::size_t at_once = 3;
    T power[at_once], q[at_once];
    for (std::size_t i = 0; i < at_once; ++i)
      for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
        const F x = random.below(4) ? F(1) - F(random.log_uniform(1e-9, 1)) : random.hard<F>();
        power[i].set(lane, x), q[i].set(lane, random.below(4) ? F(1) - x : random.hard<F>());
      }
    T cosine[at_once], half_square[at_once];
    for (std::size_t i = 0; i < at_once; ++i) cosine[i] = power[i], half_square[i] = q[i];
    raise_cosines(power, q, exponent);
    for (std::size_t i = 0; i < at_once; ++i)
      for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
        const F alone = raised(cosine[i][lane], half_square[i][lane], exponent), together = power[i][lane];
        if (bits_of(alone) != bits_of(together))
          CHECK_MESSAGE(bits_of(alone) == bits_of(together), "n = ", n, ", cosine = ", cosine[i][lane]);
      }
  });
}

TEST_CASE("powers are made by squaring for whole exponents up to the last whose error is known") {
  for (const std::uint32_t n : some_exponents()) CHECK(cosine_exponent<double>(n).whole == n);
  for (const double s : {0.0, 5e-324, 0.5, 0.999, 1.5, 31.999999999, max_whole_exponent + 0.5, max_whole_exponent + 1.0,
                         4294967296.0, 4294967297.0, 1e300}) {
    CHECK(cosine_exponent<double>(s).whole == 0);
    CHECK(cosine_exponent<float>(s).whole == 0);
    CHECK(cosine_exponent<double>(s).s == s);
  }
}

TEST_CASE_TEMPLATE("a whole power and one by logarithm are as close as their errors allow", F, double, float) {
  for_all(5000, [](Random& random) {
    const auto n = static_cast<std::uint32_t>(random.log_uniform(1, max_whole_exponent));
    const auto angle = random.below(2) ? Angle<F>::near(F(random.log_uniform(1e-8, 0.24)))
                                       : Angle<F>::from(F(random.uniform(0.01, 0.75)));
    const F by_squaring = raised(angle.cosine, angle.q, cosine_exponent<F>(n));
    const F by_logarithm = any_cosine_power<F>(angle.cosine, angle.q, n);
    if (by_squaring < F(smallest_result<F>) * F(1.01)) return; // either may be cut
    const double bits = -std::log2(static_cast<double>(by_squaring));
    const double units = 2 * (small_power_error_at_1 + small_power_error_per_bit * bits);
    CHECK(std::abs(static_cast<double>(by_squaring) - static_cast<double>(by_logarithm)) <=
          units * static_cast<double>(by_squaring) * epsilon_of<F>);
  });
}

} // namespace
} // namespace refraster
