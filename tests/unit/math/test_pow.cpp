#include "math/elementary.h"
#include "tests/support/accuracy.h"

namespace refraster {
namespace {

/// 0 for results that are cut to 0, and those within a rounding of the cut.
template <class F>
double error_of_power(F x, double s) {
  const Mpfr y = exact_log2(Mpfr(x)) * s;
  if (y <= lowest_power<F> + 1e-3 || y >= highest_power<F> - 1e-3) return 0;
  return ulp_error(pow(x, s), exact_exp2(y));
}

TEST_CASE_TEMPLATE("a power keeps its error bound for cosines and glossinesses", F, double, float) {
  check_error("pow", pow_error<F>, 20000, [](Random& random) {
    const double s = random.log_uniform(0.1, 1e4);
    return error_of_power(F(std::exp2(random.uniform(lowest_power<F>, 0) / s)), s);
  });
}

TEST_CASE_TEMPLATE("a power keeps its error bound for any base and exponent", F, double, float) {
  check_error("pow", pow_error<F>, 20000, [](Random& random) {
    const F x = std::abs(random.any_finite<F>());
    return x == 0 ? 0 : error_of_power(x, random.log_uniform(1e-3, 1e3));
  });
}

TEST_CASE_TEMPLATE("a power keeps its error bound for bases next to 1 and huge exponents", F, double, float) {
  check_error("pow", pow_error<F>, 20000, [](Random& random) {
    const double distance = random.log_uniform(epsilon_of<F>, 1e-3);
    return error_of_power(F(1 - distance), random.log_uniform(1, 80) / distance);
  });
}

TEST_CASE_TEMPLATE("whatever is not positive counts as zero, and 0^0 is 1", F, double, float) {
  using Limits = std::numeric_limits<F>;
  for (const F x : {F(0), F(-0.0), F(-1), -Limits::infinity(), Limits::quiet_NaN(), -Limits::denorm_min()}) {
    CHECK(pow(x, 0) == 1);
    for (const double s : {1e-300, 0.5, 1.0, 3.0, 1e308}) CHECK(pow(x, s) == 0);
  }
}

TEST_CASE_TEMPLATE("1 to any power is 1, any number to the 0th is 1", F, double, float) {
  for (const double s : {0.0, 1e-300, 0.3, 1.0, 7.0, 1e6, 1e308}) CHECK(pow(F(1), s) == 1);
  for_all(1000, [](Random& random) { CHECK(pow(random.hard<F>(), 0) == 1); });
}

TEST_CASE_TEMPLATE("powers that are too small are 0, too large ones the largest number", F, double, float) {
  using Limits = std::numeric_limits<F>;
  CHECK(pow(F(0.5), -lowest_power<F>) == std::ldexp(F(1), static_cast<int>(lowest_power<F>)));
  CHECK(pow(F(0.5), -lowest_power<F> + 1) == 0);
  CHECK(pow(F(0.999), 1e308) == 0);
  CHECK(pow(F(1.001), 1e308) == Limits::max());
  CHECK(pow(Limits::infinity(), 0.5) <= Limits::max());
  CHECK(pow(Limits::infinity(), 1) == Limits::max());
  CHECK(pow(Limits::denorm_min(), 0.25) == doctest::Approx(std::exp2((Limits::min_exponent - Limits::digits) / 4.0)));
}

TEST_CASE_TEMPLATE("no power of a number up to 1 is above 1", F, double, float) {
  F x = 1;
  for (int step = 0; step < 1000; ++step) {
    for (const double s : {1e-9, 0.5, 1.0, 20.0, 1e6, 1e9}) CHECK(pow(x, s) <= 1);
    x = std::nextafter(x, F(0));
  }
}

} // namespace
} // namespace refraster
