#include "bench/precision/measure.h"

#include "math/elementary.h"
#include "tests/support/random.h"

namespace refraster::precision {

namespace {

Mpfr exact_log2(const Mpfr& x) {
  return log2(x);
}
Mpfr exact_exp2(const Mpfr& x) {
  return pow(Mpfr(2), x);
}

/// A trial says how far off it was and on what.
struct Trial {
  Mpfr ulp;
  std::string input;
};

template <class F, class Once>
Error errors(int trials, const Once& once) {
  Errors all;
  for (int k = 0; k < trials; ++k) {
    Random random(static_cast<std::uint64_t>(k));
    const Trial trial = once(random);
    all.add(trial.ulp, [&] { return trial.input; });
  }
  return all.summary();
}

template <class F>
Mpfr in_ulps(F computed, const Mpfr& exact, const Mpfr& scale) {
  return abs(Mpfr(Mpfr(computed) - exact)) / ulp_at<F>(scale);
}
template <class F>
Mpfr in_ulps(F computed, const Mpfr& exact) {
  return in_ulps(computed, exact, exact);
}

std::string input(std::initializer_list<double> arguments) {
  std::string all;
  for (const double x : arguments) all += (all.empty() ? "" : ", ") + hex(x);
  return all;
}
template <class F>
std::string input(const Vec3<F>& a) {
  return hex(Double3(a));
}

template <class F>
double wide(F x) {
  return static_cast<double>(x);
}

template <class F>
F positive_finite(Random& random) {
  for (;;)
    if (const F x = std::abs(random.any_finite<F>()); x > 0) return x;
}

/// 0 where the exact result is cut to 0 or overflows, or within a rounding of that.
template <class F>
Trial power_trial(F x, double s) {
  const Mpfr y = exact_log2(Mpfr(x)) * s;
  if (y <= lowest_power<F> + 1e-3 || y >= highest_power<F> - 1e-3) return {0, ""};
  return {in_ulps(pow(x, s), exact_exp2(y)), input({wide(x), s})};
}
template <class F>
Trial log2_trial(F x) {
  return {in_ulps(log2(x), exact_log2(Mpfr(x))), input({wide(x)})};
}
template <class F>
Trial exp2_trial(F x) {
  return {in_ulps(exp2(x), exact_exp2(Mpfr(x))), input({wide(x)})};
}
template <class F>
Trial atan2_trial(F y, F x) {
  return {in_ulps(atan2(y, x), atan2(Mpfr(y), Mpfr(x))), input({wide(y), wide(x)})};
}

template <class F>
Vec3<F> some_vector(Random& random, double decades) {
  const auto component = [&] {
    return F(random.sign() * random.uniform(0, 1) * std::pow(10, random.uniform(-decades, decades)));
  };
  return {component(), component(), component()};
}

template <class F>
Trial normalize_trial(const Vec3<F>& a) {
  const Vec3<F> computed = normalize(a);
  const Exact3 exactly = unit(exact(a));
  Mpfr worst = 0;
  for (int c = 0; c < 3; ++c) {
    const Mpfr ulp = in_ulps(computed[c], exactly[static_cast<std::size_t>(c)]);
    if (ulp > worst) worst = ulp;
  }
  return {worst, input(a)};
}

/// In ulps of 1: what the error of a highlight is against its peak.
template <class F>
Trial highlight_trial(Random& random, double s) {
  const double radius = std::min(std::sqrt(2 / s) * random.uniform(0, 3), 1.5);
  const Double3 a = normalize(some_vector<double>(random, 0));
  const Double3 across = normalize(cross(a, normalize(some_vector<double>(random, 0))));
  const Vec3<F> x = normalize(Vec3<F>(a)), y = normalize(Vec3<F>(a * std::cos(radius) + across * std::sin(radius)));
  const Mpfr cosine = inner(unit(exact(x)), unit(exact(y)));
  const Mpfr exactly = cosine > 0 ? pow(cosine, Mpfr(s)) : Mpfr(0);
  return {in_ulps(cosine_power(x, y, s), exactly, Mpfr(1)), input(x) + ", " + input(y) + ", " + hex(s)};
}

template <class Measure>
FunctionRow both(std::string_view function, std::string_view inputs, UlpBound double_bound, UlpBound float_bound,
                 int trials, const Measure& once) {
  const auto measured = [&]<class F>(F) {
    return errors<F>(trials, [&](Random& random) { return once(F(0), random); });
  };
  return {function, inputs, double_bound, float_bound, measured(0.0), measured(0.0f)};
}

template <class F>
constexpr UlpBound cosine_power_bound() {
  const double ulps = cosine_power_max_error<F> / epsilon_of<F>;
  return {ulps, ulps};
}

FunctionRow of_degrees(std::string_view function, UlpBound bound, int trials, double (*computed)(double),
                       Mpfr (*exactly)(const Mpfr&), double multiple_left_out) {
  const auto once = [&](Random& random) -> Trial {
    const double angle = random.below(2) ? random.uniform(-360, 360) : random.sign() * random.log_uniform(1e-10, 1e15);
    if (std::fmod(angle, multiple_left_out) == 0) return {0, ""}; // exact: see the tests
    const Mpfr radians = Mpfr(std::fmod(angle, 360.0)) * exact_pi() / 180;
    return {in_ulps(computed(angle), exactly(radians)), input({angle})};
  };
  return {function, "within a turn, and up to 1e15 degrees", bound, {}, errors<double>(trials, once), {}, false};
}

} // namespace

std::vector<FunctionRow> measure_functions(int trials) {
  const auto log2_bounds = [&](auto inputs, auto once) {
    return both("log2", inputs, log2_error<double>, log2_error<float>, trials, once);
  };
  const auto exp2_bounds = [&](auto inputs, auto once) {
    return both("exp2", inputs, exp2_error<double>, exp2_error<float>, trials, once);
  };
  const auto power_bounds = [&](auto inputs, auto once) {
    return both("pow", inputs, pow_error<double>, pow_error<float>, trials, once);
  };
  const auto atan2_bounds = [&](auto inputs, auto once) {
    return both("atan2", inputs, atan2_error<double>, atan2_error<float>, trials, once);
  };
  const auto highlight = [&](auto inputs, auto glossiness) {
    return both("cosine_power", inputs, cosine_power_bound<double>(), cosine_power_bound<float>(), trials,
                [=]<class F>(F, Random& random) { return highlight_trial<F>(random, glossiness(random)); });
  };
  const auto vectors = [&](auto function, auto inputs, UlpBound of_double, UlpBound of_float, double range,
                           auto trial) {
    return both(function, inputs, of_double, of_float, trials, [=]<class F>(F, Random& random) {
      return trial(some_vector<F>(random, range * (sizeof(F) == 4 ? 30 : 300)), random);
    });
  };
  const auto length_of = []<class F>(const Vec3<F>& a, Random&) -> Trial {
    return {in_ulps(length(a), norm(exact(a))), input(a)};
  };
  const auto unit_of = []<class F>(const Vec3<F>& a, Random&) { return normalize_trial(a); };
  const auto dot_of = []<class F>(const Vec3<F>& a, Random& random) -> Trial {
    const Vec3<F> b = some_vector<F>(random, 0);
    const Exact3 x = exact(a), y = exact(b);
    return {in_ulps(dot(a, b), inner(x, y), inner_magnitude(x, y)), input(a) + ", " + input(b)};
  };

  return {
      log2_bounds("every magnitude", []<class F>(F, Random& r) { return log2_trial(positive_finite<F>(r)); }),
      log2_bounds(
          "near 1",
          []<class F>(F, Random& r) { return log2_trial(F(1 + r.sign() * r.log_uniform(epsilon_of<F>, 0.5))); }),
      exp2_bounds("-4 to 4", []<class F>(F, Random& r) { return exp2_trial(F(r.uniform(-4, 4))); }),
      exp2_bounds(
          "whole range",
          []<class F>(F, Random& r) { return exp2_trial(F(r.uniform(lowest_power<F>, highest_power<F> - 1e-3))); }),
      power_bounds("cosines, exponents 0.1 to 1e4",
                   []<class F>(F, Random& r) {
                     const double s = r.log_uniform(0.1, 1e4);
                     return power_trial(F(std::exp2(r.uniform(lowest_power<F>, 0) / s)), s);
                   }),
      power_bounds("any base, exponents 1e-3 to 1e3",
                   []<class F>(F, Random& r) { return power_trial(positive_finite<F>(r), r.log_uniform(1e-3, 1e3)); }),
      power_bounds("bases next to 1, exponents to 1e17",
                   []<class F>(F, Random& r) {
                     const double distance = r.log_uniform(epsilon_of<F>, 1e-3);
                     return power_trial(F(1 - distance), r.log_uniform(1, 80) / distance);
                   }),
      highlight("glossiness 1 to 128", [](Random& random) { return random.log_uniform(1, 128); }),
      highlight("glossiness 128 to 1e7", [](Random& random) { return random.log_uniform(128, 1e7); }),
      highlight("whole glossiness 1 to 1921",
                [](Random& random) { return std::floor(random.log_uniform(1, max_whole_exponent + 1)); }),
      atan2_bounds("all directions",
                   []<class F>(F, Random& r) { return atan2_trial(F(r.uniform(-1, 1)), F(r.uniform(-1, 1))); }),
      atan2_bounds("every magnitude",
                   []<class F>(F, Random& r) -> Trial {
                     const F y = r.any_finite<F>(), x = r.any_finite<F>();
                     if (std::abs(atan2(y, x)) < F(4 * min_two_product<F>)) return {0, ""}; // 2 ulp there
                     return atan2_trial(y, x);
                   }),
      of_degrees(
          "sin_degrees", sin_degrees_error, trials, sin_degrees, [](const Mpfr& x) { return Mpfr(sin(x)); }, 180),
      of_degrees(
          "cos_degrees", cos_degrees_error, trials, cos_degrees, [](const Mpfr& x) { return Mpfr(cos(x)); }, 90),
      of_degrees(
          "tan_degrees", tan_degrees_error, trials, tan_degrees, [](const Mpfr& x) { return Mpfr(tan(x)); }, 90),
      vectors("length", "ordinary", length_error<double>, length_error<float>, 0, length_of),
      vectors("length", "every magnitude", length_error<double>, length_error<float>, 1, length_of),
      vectors("normalize", "ordinary", normalize_error<double>, normalize_error<float>, 0, unit_of),
      vectors("normalize", "every magnitude", normalize_error<double>, normalize_error<float>, 1, unit_of),
      vectors("dot", "ordinary", dot_error<double>, dot_error<float>, 0, dot_of),
  };
}

} // namespace refraster::precision
