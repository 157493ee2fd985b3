#include "math/elementary.h"
#include "tests/support/accuracy.h"

#include <tuple>

namespace refraster {
namespace {

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
Mpfr exact_cosine(const Vec3<F>& a, const Vec3<F>& b) {
  const auto exact_dot = [](const Vec3<F>& u, const Vec3<F>& v) {
    return Mpfr(Mpfr(u.x) * v.x + Mpfr(u.y) * v.y + Mpfr(u.z) * v.z);
  };
  return exact_dot(a, b) / sqrt(Mpfr(exact_dot(a, a) * exact_dot(b, b)));
}

TEST_CASE_TEMPLATE("the power inside a highlight is off by a few roundings for each halving", F, double, float) {
  double worst = 0; // in units of the stated bound
  for_all(20000, [&](Random& random) {
    const F t = F(random.below(2) ? random.uniform(-0.29, 0.41) : -random.log_uniform(1e-30, 0.25));
    const F k = F(t > 0 ? -1 - random.below(20) : -random.below(20));
    const Mpfr log2_base = exact_log2(1 + Mpfr(t)) + k;
    const double bits = random.log_uniform(1e-3, -lowest_power<F> - 1); // the result is about 2^-bits
    const double s = bits / -log2_base.template convert_to<double>();
    if (s > 1e38) return;
    const Mpfr exact = exact_exp2(log2_base * s);
    const Mpfr error = abs(Mpfr(small_power(OnePlus<F>{t, k}, s)) - exact) / exact;
    const double bound = (small_power_error_at_1 + small_power_error_per_bit * bits) * epsilon_of<F> / 2;
    worst = std::max(worst, (error / bound).template convert_to<double>());
  });
  CAPTURE(worst);
  CHECK(worst <= 1);
}

TEST_CASE_TEMPLATE("the highlight of an angle keeps its absolute error bound for every exponent", F, double, float) {
  constexpr double bound{cosine_power_max_error<F>};
  double worst = 0;
  for_all(20000, [&](Random& random) {
    const double s = random.log_uniform(1, 1e7);
    const Vec3<F> a = direction<F>(random);
    const double highlight_radius = std::sqrt(2 / s); // there cos^s is about 1/e
    const Vec3<F> b = beside(a, highlight_radius * random.uniform(0, 3), random);
    const Mpfr cosine = exact_cosine(a, b);
    const Mpfr exact = cosine > 0 ? exact_exp2(exact_log2(cosine) * s) : Mpfr(0);
    const double error = Mpfr(abs(Mpfr(cosine_power(a, b, s)) - exact)).template convert_to<double>();
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
    const Mpfr exact = exact_exp2(exact_log2(exact_cosine(a, b)) * 1e6);
    const double error = Mpfr(abs(Mpfr(pow(dot(a, b), 1e6)) - exact)).convert_to<double>();
    worst = std::max(worst, error);
  });
  CHECK(worst > 1000 * cosine_power_max_error<float>);
}

TEST_CASE_TEMPLATE("a highlight is exactly 1 in its middle, and never brighter", F, double, float) {
  for_all(2000, [](Random& random) {
    const Vec3<F> a = direction<F>(random), b = beside(a, random.log_uniform(1e-9, 0.1), random);
    const double s = random.log_uniform(1e-3, 1e9);
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
    const F value = cosine_power(a, b, random.log_uniform(1e-3, 1e9));
    CHECK(value >= 0);
    CHECK(value <= 1);
  });
}

} // namespace
} // namespace refraster
