// BRDFs with a formula, and the tables made from them.

#include "scenes/synthesis/merl_synthesis.h"
#include "shading/half_difference.h"
#include "shading/merl_lookup.h"
#include "tests/support/shading/directions.h"

#include <doctest/doctest.h>

using namespace refraster;

namespace {

constexpr double pi = std::numbers::pi;

Rgb<double> value(const AnalyticBrdf& brdf, const Double3& n, const Double3& i, const Double3& o) {
  return std::visit([&](const auto& formula) { return formula(n, i, o); }, brdf);
}

/// The integral of f cos(theta_o) over all o: midpoints of squared sines and azimuths, each cell pi / (steps)^2.
double albedo(const AnalyticBrdf& brdf, double theta_i, int steps) {
  const Double3 n(0, 0, 1), i(std::sin(theta_i), 0, std::cos(theta_i));
  double sum = 0;
  for (int r = 0; r < steps; ++r)
    for (int a = 0; a < steps; ++a) {
      const double sine = std::sqrt((r + 0.5) / steps), phi = 2 * pi * (a + 0.5) / steps;
      const Double3 o(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(1 - sine * sine));
      sum += value(brdf, n, i, o).x;
    }
  return sum * pi / (steps * steps);
}

} // namespace

TEST_CASE("reflection worked out by hand") {
  const Double3 n(0, 0, 1), slanted(0.6, 0, 0.8), mirror(-0.6, 0, 0.8);
  // albedo / pi.
  CHECK(Lambert{Double3(0.5)}(n, slanted, n).x == doctest::Approx(0.5 / pi));
  // All along n: D = 1 / (pi alpha^2), G / (4 n.i n.o) = 1 / 4, F = f0.
  CHECK(GgxConductor{0.5, Double3(0.8)}(n, n, n).x == doctest::Approx(0.8 / (4 * pi * 0.25)));
  // Mirror direction, n.i = n.o = i.h = 0.8: D = 1 / (pi a), a = 1/4; sqrt(a + (1 - a) 0.64) = sqrt(0.73);
  // visibility 1 / (4 * 0.8 * sqrt(0.73)); F = 0.8 + 0.2 * 0.2^5 = 0.800064.
  CHECK(GgxConductor{0.5, Double3(0.8)}(n, slanted, mirror).x ==
        doctest::Approx(0.800064 * 4 / pi / (3.2 * std::sqrt(0.73))));
  // Half vector at tan(theta_h) = 1/3 (i = slanted, o = n): cos^2 = 0.9, sin^2 = 0.1, D = a / (pi (0.9 a + 0.1)^2) with
  // a = 1/4 is 0.25 / (0.105625 pi); visibility 0.5 / (sqrt(0.25 + 0.75 * 0.64) + 0.8) = 0.5 / (sqrt(0.73) + 0.8);
  // i.h = sqrt(0.9); f0 = 1, so F = 1.
  CHECK(GgxConductor{0.5, Double3(1)}(n, slanted, n).x ==
        doctest::Approx(0.25 / (0.105625 * pi) * 0.5 / (std::sqrt(0.73) + 0.8)));
  // Normal incidence on glass, ior 1.5: F = (0.5 / 2.5)^2 = 0.04. The ground: 0.96^2 albedo / pi.
  CHECK(dielectric_fresnel(1.0, 1.5) == doctest::Approx(0.04));
  CHECK(dielectric_fresnel(0.0, 1.5) == doctest::Approx(1));
  CHECK(GgxDielectric{0.5, 1.5, Double3(0.5)}(n, n, n).x == doctest::Approx(0.04 / pi + 0.9216 * 0.5 / pi));
  // Brewster's angle, tan = ior: only one polarisation is reflected, F = ((ior^2 - 1) / (ior^2 + 1))^2 / 2.
  CHECK(dielectric_fresnel(1 / std::sqrt(1 + 2.25), 1.5) == doctest::Approx(0.5 * 1.25 * 1.25 / (3.25 * 3.25)));
}

TEST_CASE("no formula reflects more than arrives, and all are reciprocal to the last bit") {
  std::mt19937_64 random(1);
  for (const BrdfPreset& preset : brdf_presets()) {
    CAPTURE(preset.name);
    CHECK(find_brdf_preset(preset.name) == &preset);
    // The quadrature of a lobe of width alpha >= 0.05 with 400 steps errs by far less than what these lack to 1.
    for (const double degrees : {0.0, 30.0, 60.0, 80.0, 88.0}) CHECK(albedo(preset.brdf, degrees * pi / 180, 400) <= 1);
    for (int k = 0; k < 1000; ++k) {
      const auto [n, i, o] = random_pair(random);
      const Rgb<double> there = value(preset.brdf, n, i, o), back = value(preset.brdf, n, o, i);
      REQUIRE(there == back);
      REQUIRE(there.y >= 0);
    }
  }
  CHECK(find_brdf_preset("plutonium") == nullptr);
}

TEST_CASE("bin centres come back from their own directions") {
  const Double3 n(0, 0, 1);
  for (int h = 0; h < 90; h += 7)
    for (int d = 0; d < 90; d += 7)
      for (int p = 0; p < 180; p += 7) {
        const auto [i, o] = directions_at_centre(h, d, p);
        REQUIRE(length(i) == doctest::Approx(1).epsilon(1e-15));
        const MerlPoint<double> at = merl_point(half_difference(MerlAngles::closed, n, i, o));
        REQUIRE(std::abs(at.u - (h + 0.5)) < 1e-9);
        REQUIRE(std::abs(at.v - (d + 0.5)) < 1e-9);
        REQUIRE(std::abs(at.w - (p + 0.5)) < 1e-6); // sin(theta_h) >= 4.8e-5 in bin 0, so 1e-11 of a bin of 1 degree
      }
}

TEST_CASE("a table has its formula's values where both directions are above the horizon, and a rim below it") {
  const Double3 n(0, 0, 1);
  const GgxConductor brdf{0.3, {0.9, 0.5, 0.2}};
  const MerlTable table = merl_table_from(brdf);
  std::size_t measured = 0, asymmetric = 0;
  for (int h = 0; h < 90; ++h)
    for (int d = 0; d < 90; ++d)
      for (int p = 0; p < 180; ++p) {
        const auto [i, o] = directions_at_centre(h, d, p);
        const Rgb<double> f = table.sample(h, d, p);
        measured += f.x >= 0;
        asymmetric += (f.x >= 0) != (table.sample(h, d, 179 - p).x >= 0);
        const double lowest = std::min(i.z, o.z);
        if (lowest >= 0x1p-10) REQUIRE(f == brdf(n, i, o));
        else if (lowest < -rim_sine) REQUIRE(f == Rgb<double>(-1));
        else REQUIRE((f.x >= 0 && std::isfinite(f.x)));
      }
  CHECK(asymmetric == 0);
  CHECK(measured == 1152200); // the measured tables: 1,152,174
}

TEST_CASE("above the horizon a table made from a formula is read from measured samples only") {
  const MerlTable table = merl_table_from(Lambert{Double3(0.5)});
  const MerlReader<double> reader{table.values<double>()};
  std::mt19937_64 random(2);
  for (int k = 0; k < 20000; ++k)
    for (const auto& [n, i, o] : {random_pair(random), opposite_grazing_pair(random)}) {
      if (dot(n, i) <= 0 || dot(n, o) <= 0) continue;
      const MerlPoint<double> at = merl_point(half_difference(MerlAngles::closed, n, i, o));
      for (const MerlValue<double>& read : {reader.nearest(at), reader.trilinear(at, 0.5)}) {
        REQUIRE(read.f == Rgb<double>(0.5 / pi));
        REQUIRE_FALSE(read.unmeasured);
      }
      REQUIRE_FALSE(reader.trilinear(at, 0).unmeasured); // samples at the starts of bins reach further than the rim
    }
}
