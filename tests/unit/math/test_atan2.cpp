#include "math/elementary.h"
#include "tests/support/accuracy.h"

#include <numbers>

namespace refraster {
namespace {

template <class F>
double error_of_atan2(F y, F x) {
  return ulp_error(atan2(y, x), atan2(Mpfr(y), Mpfr(x)));
}

/// There the quotient's rounding is not made up for, and scaling may have cost bits.
template <class F>
bool is_small(F angle) {
  return std::abs(angle) < F(4 * min_two_product<F>);
}

TEST_CASE_TEMPLATE("atan2 keeps its error bound in all directions", F, double, float) {
  check_error("atan2", atan2_error<F>, 40000,
              [](Random& random) { return error_of_atan2(F(random.uniform(-1, 1)), F(random.uniform(-1, 1))); });
}

TEST_CASE_TEMPLATE("atan2 keeps its error bound for lengths of any magnitude", F, double, float) {
  check_error("atan2", atan2_error<F>, 20000, [](Random& random) {
    const F y = random.any_finite<F>(), x = random.any_finite<F>();
    return is_small(atan2(y, x)) ? 0 : error_of_atan2(y, x);
  });
}

TEST_CASE_TEMPLATE("a tiny angle is off by at most 2 units in the last place", F, double, float) {
  for_all(20000, [](Random& random) {
    // From the smallest normal number to where it is no longer small.
    const int exponent = std::numeric_limits<F>::min_exponent + static_cast<int>(random.below(30));
    const F y = std::ldexp(random.any_finite<F>(), exponent), x = F(random.log_uniform(1, 1e30));
    if (is_small(atan2(y, x)) && y != 0) CHECK(error_of_atan2(y, x) <= 2);
  });
}

TEST_CASE_TEMPLATE("atan2 of a direction has the same bits at every length", F, double, float) {
  // Within the range that needs no scaling, at its borders, and far beyond.
  constexpr int farthest = sizeof(F) == 4 ? 90 : 950;
  for_all(20000, [](Random& random) {
    const F y = F(random.uniform(-1, 1)), x = F(random.uniform(-1, 1));
    const int e = static_cast<int>(random.uniform(-farthest, farthest));
    REQUIRE(atan2(std::ldexp(y, e), std::ldexp(x, e)) == atan2(y, x));
  });
}

TEST_CASE_TEMPLATE("atan2 keeps its error bound near the octants' borders", F, double, float) {
  check_error("atan2", atan2_error<F>, 20000, [](Random& random) {
    const double border = random.below(16) * std::numbers::pi / 8;
    const double angle = border + random.sign() * random.log_uniform(1e-17, 1e-2), r = random.log_uniform(1e-3, 1e3);
    return error_of_atan2(F(r * std::sin(angle)), F(r * std::cos(angle)));
  });
}

TEST_CASE_TEMPLATE("atan2 of the axes and diagonals is the rounded multiple of pi/4", F, double, float) {
  const F pi = F(std::numbers::pi), zero = 0;
  for (const F r : {F(1), F(0.3), std::numeric_limits<F>::min(), std::numeric_limits<F>::denorm_min(),
                    std::numeric_limits<F>::max(), std::numeric_limits<F>::infinity()}) {
    CHECK(atan2(zero, r) == 0);
    CHECK(atan2(r, r) == pi / 4);
    CHECK(atan2(r, zero) == pi / 2);
    CHECK(atan2(r, -r) == F(3 * std::numbers::pi_v<long double> / 4));
    CHECK(atan2(zero, -r) == pi);
    CHECK(atan2(-zero, -r) == -pi);
    CHECK(atan2(-r, -r) == -F(3 * std::numbers::pi_v<long double> / 4));
    CHECK(atan2(-r, zero) == -pi / 2);
    CHECK(atan2(-r, r) == -pi / 4);
  }
}

TEST_CASE_TEMPLATE("atan2 of nothing is 0, an infinite side outweighs a finite one, NaN counts as 0", F, double,
                   float) {
  const F zero = 0, infinity = std::numeric_limits<F>::infinity(), nan = std::numeric_limits<F>::quiet_NaN();
  for (const F x : {zero, -zero, nan}) {
    CHECK(atan2(zero, x) == 0);
    CHECK(atan2(nan, x) == 0);
  }
  CHECK(atan2(F(1), infinity) == 0);
  CHECK(atan2(infinity, F(-1)) == F(std::numbers::pi / 2));
  CHECK(atan2(F(1), -infinity) == F(std::numbers::pi));
  CHECK(atan2(F(1), nan) == F(std::numbers::pi / 2));
}

TEST_CASE_TEMPLATE("atan2 turns its sign with y, and is reflected with x", F, double, float) {
  for_all(5000, [](Random& random) {
    const F y = random.hard<F>(), x = random.hard<F>();
    CHECK(atan2(-y, x) == -atan2(y, x));
    if (x != 0) CHECK(atan2(std::abs(y), -std::abs(x)) >= F(std::numbers::pi / 2));
  });
}

} // namespace
} // namespace refraster
