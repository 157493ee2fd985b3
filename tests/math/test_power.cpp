#include "math/elementary.h"
#include "tests/support/accuracy.h"

#include <tuple>

namespace refraster {
namespace {

/// 0 for results that are cut to 0, and those within a rounding of the cut.
template <class F>
double error_of_power(F x, double s) {
  const Exact y = exact_log2(Exact(x)) * s;
  if (y <= lowest_power<F> + 1e-3 || y >= highest_power<F> - 1e-3) return 0;
  return ulp_error(power(x, s), exact_exp2(y));
}

TEST_CASE_TEMPLATE("a power keeps its error bound for cosines and glossinesses", F, double, float) {
  check_error("power", power_error<F>, 20000, [](Random& random) {
    const double s = random.magnitude(0.1, 1e4);
    return error_of_power(F(std::exp2(random.uniform(lowest_power<F>, 0) / s)), s);
  });
}

TEST_CASE_TEMPLATE("a power keeps its error bound for any base and exponent", F, double, float) {
  check_error("power", power_error<F>, 20000, [](Random& random) {
    const F x = std::abs(random.any_finite<F>());
    return x == 0 ? 0 : error_of_power(x, random.magnitude(1e-3, 1e3));
  });
}

TEST_CASE_TEMPLATE("a power keeps its error bound for bases next to 1 and huge exponents", F, double, float) {
  check_error("power", power_error<F>, 20000, [](Random& random) {
    const double distance = random.magnitude(epsilon_of<F>, 1e-3);
    return error_of_power(F(1 - distance), random.magnitude(1, 80) / distance);
  });
}

TEST_CASE_TEMPLATE("whatever is not positive counts as zero, and 0^0 is 1", F, double, float) {
  using Limits = std::numeric_limits<F>;
  for (const F x : {F(0), F(-0.0), F(-1), -Limits::infinity(), Limits::quiet_NaN(), -Limits::denorm_min()}) {
    CHECK(power(x, 0) == 1);
    for (const double s : {1e-300, 0.5, 1.0, 3.0, 1e308}) CHECK(power(x, s) == 0);
  }
}

TEST_CASE_TEMPLATE("1 to any power is 1, any number to the 0th is 1", F, double, float) {
  for (const double s : {0.0, 1e-300, 0.3, 1.0, 7.0, 1e6, 1e308}) CHECK(power(F(1), s) == 1);
  for_all(1000, [](Random& random) { CHECK(power(random.hard<F>(), 0) == 1); });
}

TEST_CASE_TEMPLATE("powers that are too small are 0, too large ones the largest number", F, double, float) {
  using Limits = std::numeric_limits<F>;
  CHECK(power(F(0.5), -lowest_power<F>) == std::ldexp(F(1), static_cast<int>(lowest_power<F>)));
  CHECK(power(F(0.5), -lowest_power<F> + 1) == 0);
  CHECK(power(F(0.999), 1e308) == 0);
  CHECK(power(F(1.001), 1e308) == Limits::max());
  CHECK(power(Limits::infinity(), 0.5) <= Limits::max());
  CHECK(power(Limits::infinity(), 1) == Limits::max());
  CHECK(power(Limits::denorm_min(), 0.25) == doctest::Approx(std::exp2((Limits::min_exponent - Limits::digits) / 4.0)));
}

TEST_CASE_TEMPLATE("no power of a number up to 1 is above 1", F, double, float) {
  F x = 1;
  for (int step = 0; step < 1000; ++step) {
    for (const double s : {1e-9, 0.5, 1.0, 20.0, 1e6, 1e9}) CHECK(power(x, s) <= 1);
    x = std::nextafter(x, F(0));
  }
}

// cosine_power

/// A unit vector, rounded to F.
template <class F>
Vec3<F> direction(Random& random) {
  const Double3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return normalize(Vec3<F>(v));
}

/// A unit vector at about the angle given, in radians, to a.
template <class F>
Vec3<F> beside(const Vec3<F>& a, double angle, Random& random) {
  const Double3 axis(a);
  const Double3 across = normalize(cross(axis, Double3(direction<double>(random))));
  return normalize(Vec3<F>(axis * std::cos(angle) + across * std::sin(angle)));
}

/// The cosine of the angle between two vectors of any length, exactly.
template <class F>
Exact exact_cosine(const Vec3<F>& a, const Vec3<F>& b) {
  const auto exact_dot = [](const Vec3<F>& u, const Vec3<F>& v) {
    return Exact(Exact(u.x) * v.x + Exact(u.y) * v.y + Exact(u.z) * v.z);
  };
  return exact_dot(a, b) / sqrt(Exact(exact_dot(a, a) * exact_dot(b, b)));
}

TEST_CASE_TEMPLATE("the highlight of an angle keeps its absolute error bound for every exponent", F, double, float) {
  constexpr double bound{cosine_power_max_error<F>};
  double worst = 0;
  for_all(20000, [&](Random& random) {
    const double s = random.magnitude(1, 1e7);
    const Vec3<F> a = direction<F>(random);
    const double highlight_radius = std::sqrt(2 / s); // there cos^s is about 1/e
    const Vec3<F> b = beside(a, highlight_radius * random.uniform(0, 3), random);
    const Exact cosine = exact_cosine(a, b);
    const Exact exact = cosine > 0 ? exact_exp2(exact_log2(cosine) * s) : Exact(0);
    const double error = Exact(abs(Exact(cosine_power(a, b, s)) - exact)).template convert_to<double>();
    worst = std::max(worst, error);
    if (!(error <= bound)) {
      CAPTURE(s);
      CHECK(error <= bound);
    }
  });
  CAPTURE(worst);
  CHECK(worst <= bound);
}

TEST_CASE("the plain power of a float dot product would not keep that bound") {
  double worst = 0;
  for_all(1000, [&](Random& random) {
    const Vec3<float> a = direction<float>(random), b = beside(a, 1e-3, random);
    const Exact exact = exact_exp2(exact_log2(exact_cosine(a, b)) * 1e6);
    const double error = Exact(abs(Exact(power(dot(a, b), 1e6)) - exact)).convert_to<double>();
    worst = std::max(worst, error);
  });
  CHECK(worst > 1000 * cosine_power_max_error<float>);
}

TEST_CASE_TEMPLATE("a highlight is exactly 1 in its middle, and never brighter", F, double, float) {
  for_all(2000, [](Random& random) {
    const Vec3<F> a = direction<F>(random), b = beside(a, random.magnitude(1e-9, 0.1), random);
    const double s = random.magnitude(1e-3, 1e9);
    CHECK(cosine_power(a, a, s) == 1);
    CHECK(cosine_power(a, b, s) <= 1);
    CHECK(cosine_power(a, b, 0) == 1);
  });
}

TEST_CASE_TEMPLATE("a highlight needs two directions less than a right angle apart", F, double, float) {
  const Vec3<F> none(F(0)), x(F(1), F(0), F(0)), y(F(0), F(1), F(0));
  const std::tuple<Vec3<F>, Vec3<F>> dark[] = {{none, none}, {none, x}, {x, none}, {x, y}, {x, -x}};
  for (const auto& [a, b] : dark) {
    CHECK(cosine_power(a, b, 0) == 1);
    for (const double s : {1e-300, 1.0, 1e6, 1e308}) CHECK(cosine_power(a, b, s) == 0);
  }
}

TEST_CASE_TEMPLATE("a highlight stays finite for vectors that are no directions", F, double, float) {
  for_all(5000, [](Random& random) {
    const Vec3<F> a(random.hard<F>(), random.hard<F>(), random.hard<F>());
    const Vec3<F> b(random.hard<F>(), random.hard<F>(), random.hard<F>());
    const F value = cosine_power(a, b, random.magnitude(1e-3, 1e9));
    CHECK(value >= 0);
    CHECK(value <= 1);
  });
}

} // namespace
} // namespace refraster
