// The extremes (docs/extremes.md), rows S: shading.

#include "raster/resolve/rgb8.h"
#include "shading/fragment_functions.h"
#include "shading/light.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/window_scene.h"
#include "tests/system/extremes/exact_vector.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace refraster;
using namespace refraster::test;

namespace {

template <class SomeFunction>
SomeFunction shiny(double glossiness, SpecularGate gate = SpecularGate::open) {
  SomeFunction function;
  function.ka = Double3(0), function.kd = Double3(0.5, 0.25, 1), function.ks = Double3(1, 0.5, 0.25);
  function.glossiness = glossiness, function.specular_gate = gate;
  return function;
}

template <class T>
struct Shaded {
  Rgb<T> colour;
  UndefinedCounts counts;
};

/// What a fragment function makes of one light of radiance 1.
template <class T, class SomeFunction>
Shaded<T> shade(const SomeFunction& function, const Vec3<T>& n, const Vec3<T>& l, const Vec3<T>& v) {
  Shaded<T> result;
  const UndefinedTally<T> tally(result.counts, true);
  Fragment<T> at{};
  at.normal = n, at.to_eye = v, at.texture = Rgb<T>(T(1)), at.tally = &tally;
  result.colour = reflected(function, at, Incident<T>{l, Rgb<T>(T(1))});
  return result;
}

template <class T>
Incident<T> light_on_origin(const PointLight& light, UndefinedCounts& counts) {
  const UndefinedTally<T> tally(counts, true);
  Fragment<T> at{};
  at.tally = &tally;
  return arriving(light, at);
}

template <class T>
bool is_finite(const Rgb<T>& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

/// 1 - |a - b|^2 / 2, the cosine for unit a and b, exactly.
template <class T>
Mpfr exact_cosine(const Vec3<T>& a, const Vec3<T>& b) {
  Mpfr squared = 0;
  for (int c = 0; c < 3; ++c) squared += (Mpfr(a[c]) - Mpfr(b[c])) * (Mpfr(a[c]) - Mpfr(b[c]));
  return 1 - squared / 2;
}

/// A wall across the view, normal toward the eye.
Object& add_wall(WindowScene& window) {
  return window.add({window.place(-4, -4, 1), window.place(-4, 12, 1), window.place(12, -4, 1)});
}

} // namespace

TEST_CASE_TEMPLATE("S1: with light and eye on opposite sides there is no highlight; the diffuse term is what it is", F,
                   double, float) {
  const Vec3<F> n(0, 0, 1), l(F(0.8), 0, F(0.6));
  const auto shaded = shade(shiny<BlinnPhong>(32), n, l, -l);
  CHECK(shaded.colour == Rgb<F>(F(0.5) * F(0.6), F(0.25) * F(0.6), F(0.6)));
  CHECK(shaded.counts[Undefined::no_half_vector] == 1);
}

TEST_CASE_TEMPLATE("S2: in the middle of a highlight the specular factor is exactly 1, and never more", F, double,
                   float) {
  for_all(300, [](Random& random) {
    const Vec3<F> n = random_unit<F>(random);
    for (const double glossiness : {1e-3, 1.0, 8.0, 1e3, 1e6}) {
      BlinnPhong blinn = shiny<BlinnPhong>(glossiness);
      blinn.kd = Double3(0);
      Phong phong = shiny<Phong>(glossiness);
      phong.kd = Double3(0);
      CHECK(shade(blinn, n, n, n).colour == Rgb<F>(F(1), F(0.5), F(0.25)));
      // The reflected direction 2 (n.l) n - l is n to 8 roundings, also in length: that is 32 squares of a rounding in
      // 1 - cos, times the exponent.
      const F phong_factor = shade(phong, n, n, n).colour.x, u = std::numeric_limits<F>::epsilon() / 2;
      CHECK(phong_factor <= 1);
      CHECK(phong_factor >= 1 - u - static_cast<F>(glossiness) * 32 * u * u);
    }
  });
}

TEST_CASE_TEMPLATE("S3: with light, eye and half vector in one direction the highlight is 1 and the difference angle 0",
                   F, double, float) {
  for_all(300, [](Random& random) {
    const Vec3<F> n(0, 0, 1), v = random_unit<F>(random);
    const HalfDifference<F> angles = half_difference(MerlAngles::closed, n, v, v);
    CHECK(angles.theta_d == 0);
    CHECK(angles.phi_d == as<F>(std::numbers::pi / 2)); // the documented value where it is undefined
    BlinnPhong only_specular = shiny<BlinnPhong>(64);
    only_specular.kd = Double3(0);
    CHECK(shade(only_specular, v, v, v).colour.x == 1);
  });
}

TEST_CASE_TEMPLATE(
    "S4: at and below the horizon there is no diffuse light; the highlight stays unless the gate cuts it", F, double,
    float) {
  const F least = std::numeric_limits<F>::denorm_min();
  const Vec3<F> n(0, 0, 1);
  for (const F height : {F(0), least, -least, F(-0.0), F(-1e-3)}) {
    const Vec3<F> l(1, 0, height), v(-1, 0, F(0)); // the mirror direction of l, nearly
    const auto open = shade(shiny<Phong>(1), n, l, v),
               cut = shade(shiny<Phong>(1, SpecularGate::cut_below_horizon), n, l, v);
    CHECK(is_finite(open.colour));
    CHECK(cut.colour.x == (height > 0 ? open.colour.x : F(0)));
    CHECK(open.colour.x >= F(0.999)); // ks = 1; r.v = 1 but for the third case's 1e-6
    BlinnPhong matt = shiny<BlinnPhong>(1);
    matt.ks = Double3(0);
    CHECK(shade(matt, n, l, v).colour.z == (height > 0 ? height : F(0))); // kd = 1
  }
}

TEST_CASE_TEMPLATE("S5: a light exactly at the surface contributes nothing, and is counted", F, double, float) {
  for (const double quadratic : {0.0, 1.0}) {
    PointLight light;
    light.quadratic = quadratic, light.constant = 1 - quadratic;
    UndefinedCounts counts;
    const Incident<F> incident = light_on_origin<F>(light, counts);
    CHECK(incident.radiance == Rgb<F>(F(0)));
    CHECK(incident.direction == Vec3<F>(F(0)));
    CHECK(counts[Undefined::light_at_surface] == 1);
    for (const double glossiness : {0.0, 8.0})
      CHECK(is_finite(
          shade(shiny<BlinnPhong>(glossiness), Vec3<F>(0, 0, 1), incident.direction, Vec3<F>(0, 0, 1)).colour));
  }
}

TEST_CASE_TEMPLATE("S6: attenuation (0, 0, 0) is none", F, double, float) {
  UndefinedCounts counts;
  for (const double x : {1e-30, 1.0, 1e30}) {
    const PointLight light{{x, 0, 0}, {0.3, 7, 1e6}, 0, 0, 0};
    CHECK(light_on_origin<F>(light, counts).radiance == as<F>(light.radiance));
  }
}

TEST_CASE_TEMPLATE("S7: attenuation is finite from 1e-20 to 1e20, and right where the result is in range", F, double,
                   float) {
  const Mpfr largest(std::numeric_limits<F>::max()), least(std::numeric_limits<F>::min());
  for (const double d : {1e-20, 1e-10, 1e-3, 1.0, 1e3, 1e10, 1e20, 1e30})
    for (const auto& [constant, linear, quadratic] :
         {std::tuple(1.0, 0.0, 0.0), std::tuple(0.0, 1.0, 0.0), std::tuple(0.0, 0.0, 1.0), std::tuple(0.5, 0.25, 0.125),
          std::tuple(0.0, 1e-3, 1e10)}) {
      CAPTURE(d);
      UndefinedCounts counts;
      const PointLight light{{d, 0, 0}, Double3(3), constant, linear, quadratic};
      const F got = light_on_origin<F>(light, counts).radiance.x;
      CHECK(std::isfinite(got));
      CHECK(got >= 0);
      const Mpfr at(static_cast<F>(d)), divisor = Mpfr(static_cast<F>(constant)) + Mpfr(static_cast<F>(linear)) * at +
                                                  Mpfr(static_cast<F>(quadratic)) * at * at;
      const Mpfr expected = 3 / divisor;
      if (divisor < least || expected > largest) CHECK(got >= F(3) * (1 / std::numeric_limits<F>::min()) / 4); // huge
      else if (divisor > largest) CHECK(Mpfr(got) <= least);
      // d is good to 1 ulp (a root of a square), its square to 3.5, products and sums to 1 each, the quotient to 1.
      else CHECK(ulp_error(got, expected) <= 8);
    }
}

TEST_CASE_TEMPLATE("S8: to the exponent 0 every cosine is 1, also 0, and that is counted", F, double, float) {
  for (const F x : {F(0), std::numeric_limits<F>::denorm_min(), F(0.5), F(1)}) CHECK(refraster::pow(x, 0) == 1);
  BlinnPhong function = shiny<BlinnPhong>(0);
  function.kd = Double3(0);
  // n.h = 0: light and eye mirror each other about a direction in the surface.
  const auto shaded = shade(function, Vec3<F>(0, 0, 1), Vec3<F>(F(0.6), 0, F(0.8)), Vec3<F>(F(0.6), 0, F(-0.8)));
  CHECK(shaded.colour == Rgb<F>(F(1), F(0.5), F(0.25)));
  CHECK(shaded.counts[Undefined::zero_to_the_zero] == 1);
  CHECK(shade(function, Vec3<F>(0, 0, 1), Vec3<F>(0, 0, 1), Vec3<F>(0, 0, 1)).counts[Undefined::zero_to_the_zero] == 0);
}

TEST_CASE_TEMPLATE("S9: exponents from 1e-3 to 1e30 give the exact power to an ulp, and 0 far below it", F, double,
                   float) {
  CHECK(refraster::pow(F(0.99), 1e6) == 0); // 2^-14499.6
  CHECK(refraster::pow(F(0.5), 1e30) == 0);
  CHECK(refraster::pow(F(1), 1e30) == 1);
  double worst = 0;
  for (const double s : {1e-3, 0.5, 1.0, 2.2, 8.0, 1e3, 1e6, 1e9})
    for_all(200, [&](Random& random) {
      const F x = static_cast<F>(random.below(2) ? random.uniform(0, 1) : 1 - random.log_uniform(1e-15, 0.1));
      if (!(x > 0)) return;
      const Mpfr expected = exp(Mpfr(s) * log(Mpfr(x)));
      if (expected < Mpfr(std::ldexp(1.0, sizeof(F) == 4 ? -119 : -999))) return; // cut to 0 from there down
      const double error = ulp_error(refraster::pow(x, s), expected);
      worst = std::max(worst, error);
      CHECK(error <= 1);
    });
  MESSAGE("largest error of a power: " << worst << " ulp");

  // The lobe, near its top, where 1 - cos is all that counts: against the exact vectors.
  for (const double s : {1.0, 100.0, 1e6, 1e12})
    for (const double angle : {1e-9, 1e-6, 1e-4, 1e-3, 0.1, 0.6}) {
      const Vec3<F> a(0, 0, 1),
          b = normalize(Vec3<F>(static_cast<F>(std::sin(angle)), 0, static_cast<F>(std::cos(angle))));
      const Mpfr expected = exp(Mpfr(s) * log(exact_cosine(a, b)));
      // math/elementary/pow.h: an error of r q in q = |a - b|^2 / 2 changes the power by 1.4 r at most; r is 4
      // roundings.
      const Mpfr bound = Mpfr(5.6 + 1) * Mpfr(std::numeric_limits<F>::epsilon()) / 2 +
                         Mpfr(std::ldexp(1.0, sizeof(F) == 4 ? -120 : -1000));
      CHECK(abs(Mpfr(cosine_power(a, b, s)) - expected) <= bound);
    }
}

TEST_CASE("S10: an exponent does not magnify the rounding of the cosine") {
  // Given vectors in float, the highlight is good to a few of 2^-24 at every exponent. By way of the dot product it is
  // off by up to half the exponent times that: shown beside it.
  for (const double s : {32.0, 128.0, 1024.0, 16384.0, 1e6}) {
    double worst = 0, worst_by_dot = 0;
    for_all(400, [&](Random& random) {
      const Float3 a = random_unit<float>(random);
      const double angle = random.uniform(0, 4) / std::sqrt(s); // where the lobe has its slope
      const Float3 aside = normalize(cross(a, random_unit<float>(random)));
      const Float3 b = normalize(a * static_cast<float>(std::cos(angle)) + aside * static_cast<float>(std::sin(angle)));
      const Mpfr expected = exp(Mpfr(s) * log(exact_cosine(a, b)));
      const auto error = [&](float got) { return Mpfr(abs(Mpfr(got) - expected)).convert_to<double>() / 0x1p-24; };
      worst = std::max(worst, error(cosine_power(a, b, s)));
      worst_by_dot = std::max(worst_by_dot, error(refraster::pow(dot(a, b), s)));
    });
    MESSAGE("exponent " << s << ": " << worst << " units of 2^-24, by the dot product " << worst_by_dot);
    CHECK(worst <= 5.6 + 1); // as in S9
  }
}

TEST_CASE_TEMPLATE("S11: a base that rounding has made negative gives 0", F, double, float) {
  for (const double s : {1e-3, 1.0, 2.0, 32.0, 32.5, 1e6}) {
    CHECK(refraster::pow(F(-1e-8), s) == 0);
    CHECK(refraster::pow(-std::numeric_limits<F>::denorm_min(), s) == 0);
    CHECK(refraster::pow(F(-0.0), s) == 0);
    const F tiny = F(-1e-8);
    CHECK(cosine_power(Vec3<F>(1, 0, 0), Vec3<F>(tiny, 1, 0), s) == 0);
    BlinnPhong function = shiny<BlinnPhong>(s);
    CHECK(shade(function, Vec3<F>(0, 0, 1), Vec3<F>(1, 0, tiny), Vec3<F>(1, 0, tiny)).colour == Rgb<F>(F(0)));
  }
}

TEST_CASE("S12: float images keep values outside 0 to 1, levels clamp; NaN and infinity are made finite and counted") {
  constexpr float largest = std::numeric_limits<float>::max();
  constexpr double bright = std::numeric_limits<double>::max(); // and reflected twice over: infinite
  struct Case {
    double ambient;
    std::vector<double> lights; // radiance of each, reflected twice over
    float radiance;
    int level;
    std::uint64_t counted;
  };
  for (const Precision precision : {Precision::double_, Precision::float_})
    for (const Case& c : {Case{0.5, {}, 0.5f, 128, 0}, Case{2.5, {}, 2.5f, 255, 0}, Case{-1, {}, -1, 0, 0},
                          Case{1e30, {}, 1e30f, 255, 0}, Case{0, {bright, -bright}, 0, 0, 3},
                          Case{0, {bright}, largest, 255, 3}, Case{0, {-bright}, -largest, 0, 3}}) {
      CAPTURE(c.ambient);
      CAPTURE(c.lights.size());
      WindowScene window(1);
      Object& object =
          window.add({window.place(-4, -4, 1), window.place(-4, 12, 1), window.place(12, -4, 1)}, Double3(c.ambient));
      std::get<Phong>(object.material.fragment_function).kd = Double3(2);
      for (const double radiance : c.lights) window.scene.direction_lights.push_back({{0, 0, -1}, Double3(radiance)});
      RenderOptions options = window.options();
      options.precision = precision;
      const Frame frame = render(window.scene, options);
      CHECK(frame.radiance.values[0] == c.radiance);
      CHECK(frame.rgb8.values[0] == c.level); // 127.5 goes to the even 128
      CHECK(frame.counts.undefined[Undefined::not_finite] == c.counted);
    }
  // Finite in double and beyond float: the largest float.
  WindowScene window(1);
  window.add({window.place(-4, -4, 1), window.place(-4, 12, 1), window.place(12, -4, 1)}, Double3(1e300, -1e300, 1));
  const Frame frame = window.frame();
  CHECK(frame.radiance.values[0] == largest);
  CHECK(frame.radiance.values[1] == -largest);
  // Every level is reached, and the borders lie half way.
  const auto level_of = [](auto x) { return level_bits<Transfer::linear>(x); };
  for (int level = 0; level < 256; ++level) {
    CHECK(level_of(level / 255.0) == level);
    CHECK(level_of(static_cast<float>(level) / 255.f) == level);
    CHECK(level_of((level + 0.499) / 255.0) == level);
    CHECK(level_of((level - 0.499) / 255.0) == level);
  }
}

TEST_CASE("S13: lights are summed in the order of the scene: none, one, a thousand") {
  Random random(13);
  WindowScene window(4);
  Phong matt;
  matt.ka = Double3(0.1), matt.kd = Double3(1), matt.ks = Double3(0);
  add_wall(window).material.fragment_function = matt;
  Double3 sum(0.1);
  Mpfr expected_sum(0.1);
  for (int lights = 0; lights <= 1000; ++lights) {
    if (lights > 0) {
      const Double3 radiance(random.log_uniform(1e-6, 1), random.uniform(0, 1), random.log_uniform(1e-12, 1e3));
      window.scene.direction_lights.push_back({{0, 0, -1}, radiance}); // straight at the wall: n.l is exactly 1
      sum += radiance;
      expected_sum += Mpfr(radiance.x);
    }
    if (lights > 1 && lights < 1000) continue;
    const Frame frame = window.frame();
    for (int c = 0; c < 3; ++c) CHECK(frame.radiance.at(1, 1)[c] == static_cast<float>(sum[c]));
    CHECK(abs(Mpfr(frame.radiance.at(1, 1)[0]) - expected_sum) <=
          half_float_ulp(expected_sum) + expected_sum * lights * Mpfr(0x1p-53));
  }
  // In another order: within a rounding a light of the exact sum, so of each other too.
  std::reverse(window.scene.direction_lights.begin(), window.scene.direction_lights.end());
  CHECK(abs(Mpfr(window.frame().radiance.at(1, 1)[0]) - expected_sum) <=
        half_float_ulp(expected_sum) + expected_sum * 1000 * Mpfr(0x1p-53));
}
