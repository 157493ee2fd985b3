// Phong, Blinn-Phong and lights: numbers worked out by hand.

#include "math/precisions.h"
#include "shading/fragment_functions.h"
#include "shading/light.h"

#include <doctest/doctest.h>

#include <limits>

using namespace refraster;

namespace {

const Double3 up(0, 0, 1), slanted(0.6, 0, 0.8);

/// All channels differ, so that a channel in the wrong place shows.
const PhongParameters parameters{{0.1, 0.2, 0.3}, {0.5, 0.25, 0.125}, {1, 2, 4}, 2, SpecularGate::open};
const Double3 texture(1, 0.5, 0.25), light_colour(1, 2, 3);

struct Lit {
  Rgb<double> colour;
  UndefinedCounts counts;
};

template <class SomeFunction>
Lit lit(const SomeFunction& function, const Double3& n, const Double3& l, const Double3& v) {
  Lit result;
  const UndefinedTally<double> tally(result.counts, true);
  const Fragment<double> at{Double3(0), n, v, texture, &tally};
  result.colour = reflected(function, at, Incident<double>{l, light_colour});
  return result;
}

Fragment<double> fragment_at(const Double3& position, const UndefinedTally<double>* tally = nullptr) {
  return {position, up, up, Double3(1), tally};
}

void check_close(const Rgb<double>& a, const Rgb<double>& b) {
  CHECK(a.x == doctest::Approx(b.x));
  CHECK(a.y == doctest::Approx(b.y));
  CHECK(a.z == doctest::Approx(b.z));
}

} // namespace

TEST_CASE("Phong worked out by hand") {
  // n.l = 0.8; r = 2 0.8 n - l = (-0.6, 0, 0.8); r.v = 0.8 for v = n; 0.8^2 = 0.64.
  // Red: (0.5 * 1 * 0.8 + 1 * 0.64) * 1 = 1.04. Green: (0.25 * 0.5 * 0.8 + 2 * 0.64) * 2 = 2.76.
  // Blue: (0.125 * 0.25 * 0.8 + 4 * 0.64) * 3 = 7.755. The highlight takes no colour from the texture.
  check_close(lit(Phong{parameters}, up, slanted, up).colour, {1.04, 2.76, 7.755});
  // Looking along r: the highlight is ks itself.
  check_close(lit(Phong{parameters}, up, slanted, {-0.6, 0, 0.8}).colour, {1.4, 4.2, 12.075});
  // Ambient light is ka times the texture.
  check_close(ambient(Phong{parameters}, Fragment<double>{{}, up, up, texture, nullptr}), {0.1, 0.1, 0.075});
}

TEST_CASE("Blinn-Phong worked out by hand") {
  // n.l = 0.8; l + v = (0.6, 0, 1.8), h = (1, 0, 3) / sqrt(10), n.h = 3 / sqrt(10), squared 0.9.
  // Red: (0.4 + 0.9) * 1. Green: (0.1 + 1.8) * 2. Blue: (0.025 + 3.6) * 3.
  check_close(lit(BlinnPhong{parameters}, up, slanted, up).colour, {1.3, 3.8, 10.875});
  // Mirror direction: h = n.
  check_close(lit(BlinnPhong{parameters}, up, slanted, {-0.6, 0, 0.8}).colour, {1.4, 4.2, 12.075});
}

TEST_CASE("light from below the horizon makes a highlight unless the gate is shut") {
  // n.l = -0.28. Phong: r = 2 (-0.28) n - l = (-0.96, 0, -0.28); v = (-0.6, 0, 0.8): r.v = 0.352, squared 0.123904.
  // Blinn-Phong: l + v = (0.36, 0, 0.52), squared length 0.4, n.h^2 = 0.52^2 / 0.4 = 0.676.
  const Double3 below(0.96, 0, -0.28), eye(-0.6, 0, 0.8);
  check_close(lit(Phong{parameters}, up, below, eye).colour, Double3(1, 4, 12) * 0.123904);
  check_close(lit(BlinnPhong{parameters}, up, below, eye).colour, Double3(1, 4, 12) * 0.676);
  PhongParameters gated = parameters;
  gated.specular_gate = SpecularGate::cut_below_horizon;
  for (const Double3& l : {below, Double3(1, 0, 0)}) {
    CHECK(lit(Phong{gated}, up, l, eye).colour == Double3(0));
    CHECK(lit(BlinnPhong{gated}, up, l, eye).colour == Double3(0));
  }
  // Above the horizon the gate changes nothing.
  CHECK(lit(Phong{gated}, up, slanted, up).colour == lit(Phong{parameters}, up, slanted, up).colour);
}

TEST_CASE("a glossiness of 0 is a highlight everywhere, counted where the cosine is 0") {
  PhongParameters dull = parameters;
  dull.glossiness = 0;
  // n.l = 0.8, r = (-0.6, 0, 0.8): v = (0.8, 0, 0.6) is perpendicular to r. 0^0 = 1: (0.4 + 1) * 1 in red.
  const Lit phong = lit(Phong{dull}, up, slanted, {0.8, 0, 0.6});
  CHECK(phong.colour.x == doctest::Approx(1.4));
  CHECK(phong.counts[Undefined::zero_to_the_zero] == 1);
  const Lit ordinary = lit(Phong{dull}, up, slanted, up);
  CHECK(ordinary.colour.x == doctest::Approx(1.4));
  CHECK(ordinary.counts[Undefined::zero_to_the_zero] == 0);
}

TEST_CASE("without a half vector Blinn-Phong has no highlight, and counts it") {
  const Lit opposite = lit(BlinnPhong{parameters}, up, slanted, -slanted);
  check_close(opposite.colour, {0.4, 0.2, 0.075}); // kd t n.l C
  CHECK(opposite.counts[Undefined::no_half_vector] == 1);
  CHECK(lit(BlinnPhong{parameters}, up, slanted, up).counts[Undefined::no_half_vector] == 0);
}

TEST_CASE("without a normal there is neither diffuse light nor a highlight") {
  CHECK(lit(Phong{parameters}, Double3(0), slanted, -slanted).colour == Double3(0));
  CHECK(lit(BlinnPhong{parameters}, Double3(0), slanted, slanted).colour == Double3(0));
  PhongParameters dull = parameters;
  dull.glossiness = 0;
  CHECK(lit(BlinnPhong{dull}, Double3(0), slanted, slanted).colour == Double3(0));
}

TEST_CASE("a highlight that nothing reflects is not computed, nor counted") {
  PhongParameters matt = parameters;
  matt.ks = Double3(0);
  matt.glossiness = 0;
  const Lit phong = lit(Phong{matt}, up, slanted, {0.8, 0, 0.6});
  check_close(phong.colour, {0.4, 0.2, 0.075});
  CHECK(phong.counts[Undefined::zero_to_the_zero] == 0);
}

TEST_CASE("a point light weakens with distance as its three factors say") {
  // d = 5: 1 / (1 + 0.5 * 5 + 0.1 * 25) = 1 / 6.
  const PointLight light{{3, 4, 1}, {6, 12, 18}, 1, 0.5, 0.1};
  const Incident<double> incident = arriving(light, fragment_at({0, 0, 1}));
  check_close(incident.radiance, {1, 2, 3});
  check_close(incident.direction, {0.6, 0.8, 0});
  // All three 0: not attenuated.
  check_close(arriving(PointLight{{3, 4, 1}, {6, 12, 18}, 0, 0, 0}, fragment_at({0, 0, 1})).radiance, {6, 12, 18});
}

TEST_CASE("a direction light points back to where it comes from, at any length") {
  for (const double length : {1.0, 1e-30, 1e30}) {
    const Incident<double> incident =
        arriving(DirectionLight{Double3(0, -0.6, -0.8) * length, {1, 2, 3}}, fragment_at({}));
    check_close(incident.direction, {0, 0.6, 0.8});
    CHECK(incident.radiance == Double3(1, 2, 3));
  }
}

TEST_CASE("a light at the surface sends nothing and is counted") {
  UndefinedCounts counts;
  const UndefinedTally<double> tally(counts, true);
  for (const double quadratic : {0.0, 1.0}) {
    const Incident<double> incident =
        arriving(PointLight{{1, 2, 3}, {1, 1, 1}, 0, 0, quadratic}, fragment_at({1, 2, 3}, &tally));
    CHECK(incident.radiance == Double3(0));
    CHECK(incident.direction == Double3(0));
  }
  CHECK(counts[Undefined::light_at_surface] == 2);
}

TEST_CASE_TEMPLATE("a light very near or very far stays finite", F, double, float) {
  const PointLight light{{0, 0, 0}, {1, 0, 1e-3}, 0, 0, 1};
  for (const double d : {1e-300, 1e-38, 1e-25, 1e-10, 1e10, 1e30, 1e300}) {
    Fragment<F> at{};
    at.position = Vec3<F>(0, 0, static_cast<F>(d));
    if (!std::isfinite(at.position.z)) continue;
    const Incident<F> incident = arriving(light, at);
    CHECK((std::isfinite(incident.radiance.x) && incident.radiance.x >= 0));
    CHECK(incident.radiance.y == 0);
    // normalize multiplies by 1 / sqrt(x^2): three roundings.
    constexpr F three_roundings = F(1.5) * std::numeric_limits<F>::epsilon();
    CHECK((at.position.z == 0 || std::abs(incident.direction.z + 1) <= three_roundings));
  }
}

TEST_CASE_TEMPLATE("beyond the largest distance there is, attenuation is what it is at the largest", F, double, float) {
  constexpr double largest = static_cast<double>(std::numeric_limits<F>::max()),
                   far = largest * 0.9; // in x and in y: their distance overflows
  const auto red = [&](double constant, double linear, double quadratic) {
    const PointLight light{{far, far, 0}, {1, 0, 0}, constant, linear, quadratic};
    return arriving(light, Fragment<F>{}).radiance.x;
  };
  CHECK(red(1, 0, 0) == 1);
  CHECK(red(0.5, 0, 0) == 2);
  CHECK(red(1, 1, 0) <= F(1 / largest));
  CHECK(red(1, 0, 1) <= F(1 / largest));
}
