#include "math/elementary.h"
#include "tests/support/accuracy.h"

namespace refraster {
namespace {

TEST_CASE_TEMPLATE("log2 keeps its error bound at every magnitude", F, double, float) {
  check_error("log2", log2_error<F>, 20000, [](Random& random) {
    const F x = std::abs(random.any_finite<F>());
    return x == 0 ? 0 : ulp_error(log2(x), exact_log2(Mpfr(x)));
  });
}

TEST_CASE_TEMPLATE("log2 keeps its error bound near 1, where it is small", F, double, float) {
  check_error("log2", log2_error<F>, 20000, [](Random& random) {
    const F x = F(1) + F(random.sign() * random.log_uniform(epsilon_of<F>, 0.5));
    return ulp_error(log2(x), exact_log2(Mpfr(x)));
  });
}

TEST_CASE_TEMPLATE("exp2 keeps its error bound", F, double, float) {
  check_error("exp2", exp2_error<F>, 20000, [](Random& random) {
    const double end = random.below(2) ? 4 : -lowest_power<F>;
    const F x = F(random.uniform(-end, end));
    return ulp_error(exp2(x), exact_exp2(Mpfr(x)));
  });
}

TEST_CASE_TEMPLATE("log2 and exp2 are exact for whole powers of two", F, double, float) {
  for (int n = std::numeric_limits<F>::min_exponent; n < std::numeric_limits<F>::max_exponent; ++n) {
    CHECK(log2(std::ldexp(F(1), n)) == F(n));
    if (n >= lowest_power<F>) CHECK(exp2(F(n)) == std::ldexp(F(1), n));
  }
}

TEST_CASE_TEMPLATE("log2 and exp2 are finite for every argument", F, double, float) {
  using Limits = std::numeric_limits<F>;
  const F lowest = log2(Limits::denorm_min());
  CHECK(lowest == Limits::min_exponent - Limits::digits);
  for (const F x : {F(0), F(-0.0), F(-1), -Limits::infinity(), Limits::quiet_NaN()}) CHECK(log2(x) == lowest);
  CHECK(log2(Limits::infinity()) == log2(Limits::max()));

  CHECK(exp2(Limits::infinity()) == Limits::max());
  CHECK(exp2(Limits::max()) == Limits::max());
  CHECK(exp2(F(highest_power<F>)) == Limits::max());
  for (const F x : {-Limits::infinity(), -Limits::max(), Limits::quiet_NaN()}) CHECK(exp2(x) == 0);
}

TEST_CASE_TEMPLATE("exp2 is cut to 0 before it is subnormal", F, double, float) {
  const F cut = F(lowest_power<F>);
  CHECK(exp2(cut) == std::ldexp(F(1), static_cast<int>(cut)));
  CHECK(exp2(std::nextafter(cut, F(-1e6))) == 0);
}

} // namespace
} // namespace refraster
