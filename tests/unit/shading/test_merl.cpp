// Measured reflection: reading the table.

#include "math/precisions.h"
#include "scenes/synthesis/merl_synthesis.h"
#include "shading/merl.h"
#include "tests/support/shading/directions.h"
#include "tests/support/shading/merl_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>

using namespace refraster;

namespace {

constexpr MerlLookup all_lookups[] = {MerlLookup::nearest, MerlLookup::trilinear, MerlLookup::trilinear_edge,
                                      MerlLookup::trilinear_log, MerlLookup::tricubic_log};

/// Each sample holds its own index.
const MerlTable& index_table() {
  static const auto table = table_of([](int h, int d, int p) { return Rgb<double>(h, d, p); });
  return *table;
}

template <class T>
Rgb<T> read(const MerlTable& table, MerlLookup lookup, T u, T v, T w) {
  return merl_value(table, lookup, MerlPoint<T>{u, v, w}).f;
}

Rgb<double> reflected(const Merl& merl, const Double3& l, const Double3& v, UndefinedCounts* counts = nullptr) {
  UndefinedCounts unused;
  const UndefinedTally<double> tally(counts ? *counts : unused, true);
  const Fragment<double> at{Double3(0), Double3(0, 0, 1), v, Double3(1), &tally};
  return reflected(merl, at, Incident<double>{l, Double3(1, 10, 100)});
}

} // namespace

TEST_CASE_TEMPLATE("nearest takes the bin that holds the point", F, double, float) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 20000; ++k) {
    // The middle 98 % of a bin: a float near 180 is good to 2^-17.
    const int h = static_cast<int>(random() % 90), d = static_cast<int>(random() % 90),
              p = static_cast<int>(random() % 180);
    const auto inside = [&](int bin) { return static_cast<F>(bin + uniform(random, 0.01, 0.99)); };
    REQUIRE(read(index_table(), MerlLookup::nearest, inside(h), inside(d), inside(p)) == Rgb<F>(Double3(h, d, p)));
  }
  // A bin begins at its own number; theta_h = 90 degrees is in the last bin, and so is all beyond.
  CHECK(read<F>(index_table(), MerlLookup::nearest, 5, 6, 7) == Rgb<F>(5, 6, 7));
  CHECK(read<F>(index_table(), MerlLookup::nearest, 90, 90, 180) == Rgb<F>(89, 89, 179));
  CHECK(read<F>(index_table(), MerlLookup::nearest, 127, 90, 0) == Rgb<F>(89, 89, 0));
  CHECK(read<F>(index_table(), MerlLookup::nearest, 0, 0, 0) == Rgb<F>(0, 0, 0));
}

TEST_CASE("trilinear is exact on a table that is linear in u, v and w") {
  std::mt19937_64 random(2);
  for (int k = 0; k < 20000; ++k) {
    const double u = uniform(random, 0, 90), v = uniform(random, 0, 90), w = uniform(random, 0.5, 179.5);
    // Differences of neighbours are 1, so that only the subtraction of 0.5 and one sum round: by 180 * 2^-53 each.
    const Rgb<double> centre = read(index_table(), MerlLookup::trilinear, u, v, w);
    REQUIRE(std::abs(centre.x - std::clamp(u - 0.5, 0.0, 89.0)) <= 360 * 0x1p-53);
    REQUIRE(std::abs(centre.y - std::clamp(v - 0.5, 0.0, 89.0)) <= 360 * 0x1p-53);
    REQUIRE(std::abs(centre.z - (w - 0.5)) <= 360 * 0x1p-53);
    const Rgb<double> edge = read(index_table(), MerlLookup::trilinear_edge, u, v, w - 0.5);
    REQUIRE(std::abs(edge.x - std::min(u, 89.0)) <= 360 * 0x1p-53);
    REQUIRE(std::abs(edge.y - std::min(v, 89.0)) <= 360 * 0x1p-53);
    REQUIRE(std::abs(edge.z - (w - 0.5)) <= 360 * 0x1p-53);
  }
}

TEST_CASE("trilinear worked out by hand") {
  // u = 10.75 lies 0.25 from the centre of bin 10 to that of bin 11; v = 20.5 on a centre; w = 30 on a border.
  CHECK(read(index_table(), MerlLookup::trilinear, 10.75, 20.5, 30.0) == Rgb<double>(10.25, 20, 29.5));
  CHECK(read(index_table(), MerlLookup::trilinear_edge, 10.75, 20.5, 30.0) == Rgb<double>(10.75, 20.5, 30));
}

TEST_CASE("phi_d wraps and theta is clamped") {
  // Between the centres of bins 179 and 0: from 179 down to 0.
  CHECK(read(index_table(), MerlLookup::trilinear, 1.0, 1.0, 179.75).z == 0.75 * 179);
  CHECK(read(index_table(), MerlLookup::trilinear, 1.0, 1.0, 0.25).z == 0.25 * 179);
  CHECK(read(index_table(), MerlLookup::trilinear, 1.0, 1.0, 180.0).z == 0.5 * 179);
  CHECK(read(index_table(), MerlLookup::trilinear, 1.0, 1.0, 0.0).z == 0.5 * 179);
  CHECK(read(index_table(), MerlLookup::trilinear_edge, 1.0, 1.0, 179.5).z == 0.5 * 179);
  for (const MerlLookup lookup : all_lookups) {
    CAPTURE(name_of(lookup));
    const double first = lookup == MerlLookup::trilinear_edge ? 0 : 0.5;
    const Rgb<double> low = read(index_table(), lookup, first, first, 90.0);
    const Rgb<double> high = read(index_table(), lookup, 89 + first, 89 + first, 90.0);
    CHECK(std::abs(low.x) + std::abs(low.y) <= 1e-12);
    CHECK(high.x == doctest::Approx(89));
    CHECK(high.y == doctest::Approx(89));
    if (lookup == MerlLookup::tricubic_log) continue; // its outermost spline is not flat
    CHECK(read(index_table(), lookup, 0.0, 0.0, 90.0) == low);
    CHECK(read(index_table(), lookup, 140.0, 90.0, 90.0) == high);
  }
}

TEST_CASE_TEMPLATE("every lookup returns a sample at its own place", F, double, float) {
  const MerlTable& table = *ragged_table();
  std::mt19937_64 random(3);
  for (const MerlLookup lookup : all_lookups) {
    CAPTURE(name_of(lookup));
    const double first = lookup == MerlLookup::trilinear_edge ? 0 : 0.5;
    const bool logarithmic = lookup == MerlLookup::trilinear_log || lookup == MerlLookup::tricubic_log;
    for (int k = 0; k < 2000; ++k) {
      const int h = static_cast<int>(random() % 90), d = static_cast<int>(random() % 90),
                p = static_cast<int>(random() % 180);
      const Rgb<double> f = table.sample(h, d, p);
      if (f.x < 0) continue;
      const auto place = [&](int bin) { return static_cast<F>(bin + first); };
      const Rgb<F> at = read(table, lookup, place(h), place(d), place(p));
      for (int channel = 0; channel < 3; ++channel) {
        const double exact = f[channel], found = static_cast<double>(at[channel]);
        const double u = static_cast<double>(std::numeric_limits<F>::epsilon()) / 2;
        if (!logarithmic) {
          REQUIRE(found == static_cast<double>(static_cast<F>(exact)));
        } else {
          // g <= log2(1e4 / 1e-4) < 27 is rounded to 27 u, log2 and exp2 add an ulp or two of theirs: 2^g errs by
          // ln 2 (27 + 2 * 27) u + 2 u < 60 u of (f + epsilon), and the sum of f and epsilon by less.
          REQUIRE(std::abs(found - exact) <= 64 * u * (exact + MerlTable::log_epsilon));
        }
      }
    }
  }
}

TEST_CASE("samples that were never measured are left out and the others weigh more") {
  // Along u at the centre of v and w: sample 10 is 8, sample 11 was never measured, sample 12 is 2.
  const auto table = table_of([](int h, int, int) { return Rgb<double>(h == 10 ? 8 : h == 12 ? 2 : -1); });
  const auto along_u = [&](MerlLookup lookup, double u) {
    return merl_value(*table, lookup, MerlPoint<double>{u, 30.5, 60.5});
  };
  for (const MerlLookup lookup : {MerlLookup::trilinear, MerlLookup::trilinear_log, MerlLookup::tricubic_log}) {
    CAPTURE(name_of(lookup));
    for (const double u : {10.5, 10.75, 11.25, 11.49}) {
      CHECK(along_u(lookup, u).f.x == doctest::Approx(8)); // not a mean of 8 and -1
      CHECK(!along_u(lookup, u).unmeasured);
    }
    CHECK(along_u(lookup, 11.75).f.x == doctest::Approx(2));
    // On sample 11 itself the others have no weight.
    CHECK(along_u(lookup, 11.5).f.x == 0);
    CHECK(along_u(lookup, 11.5).unmeasured);
    CHECK(along_u(lookup, 40.5).f.x == 0);
    CHECK(along_u(lookup, 40.5).unmeasured);
  }
  CHECK(along_u(MerlLookup::nearest, 11.2).unmeasured);
  CHECK(along_u(MerlLookup::nearest, 11.2).f == Rgb<double>(0));
  CHECK(along_u(MerlLookup::nearest, 12.2).f.x == 2);
}

TEST_CASE("one negative channel marks the whole sample") {
  const auto table = table_of([](int h, int, int) { return h == 10 ? Rgb<double>(1, 2, -0.001) : Rgb<double>(4); });
  for (const MerlLookup lookup : all_lookups) {
    CAPTURE(name_of(lookup));
    const double u = lookup == MerlLookup::trilinear_edge ? 10.25 : 10.75;
    const MerlValue<double> at = merl_value(*table, lookup, MerlPoint<double>{u, 30.5, 60.5});
    CHECK(at.f.x == (lookup == MerlLookup::nearest ? 0 : doctest::Approx(4)));
    CHECK(at.unmeasured == (lookup == MerlLookup::nearest));
  }
}

TEST_CASE("a spline on logarithms follows an exponential exactly") {
  // f + epsilon = epsilon 2^(h / 4): the logarithm is a straight line, which Catmull-Rom splines reproduce.
  const auto table = table_of([](int h, int, int) { return Rgb<double>(1e-4 * (std::exp2(h / 4.0) - 1)); });
  for (const double u : {5.5, 5.75, 20.3, 70.9})
    for (const MerlLookup lookup : {MerlLookup::trilinear_log, MerlLookup::tricubic_log})
      CHECK(read(*table, lookup, u, 30.2, 60.7).x ==
            doctest::Approx(1e-4 * (std::exp2((u - 0.5) / 4) - 1)).epsilon(1e-12));
}

TEST_CASE("a spline through four values is the textbook's") {
  // Catmull-Rom half way: (-a + 9 b + 9 c - d) / 16.
  const auto grey = [](double x) { return Vec4<double>(x); };
  CHECK(mix_cubic(grey(1), grey(2), grey(7), grey(3), 0.5).x == doctest::Approx((-1 + 18 + 63 - 3) / 16.0));
  CHECK(mix_cubic(grey(1), grey(2), grey(7), grey(3), 0.0).x == 2);
  CHECK(mix_cubic(grey(1), grey(2), grey(7), grey(3), 1.0).x == doctest::Approx(7));
}

TEST_CASE("smoother lookups come closer to the material") {
  const GgxDielectric nylon{0.3, 1.53, Double3(0.6)};
  const MerlTable table = merl_table_from(nylon);
  std::mt19937_64 random(4);
  double error[5] = {};
  for (int k = 0; k < 20000; ++k) {
    const auto [n, i, o] = specular_pair(random);
    const MerlPoint<double> at = merl_point(half_difference(MerlAngles::closed, n, i, o));
    const Rgb<double> truth = nylon(n, i, o);
    for (const MerlLookup lookup : all_lookups)
      error[static_cast<int>(lookup)] += std::abs(merl_value(table, lookup, at).f.x - truth.x) / truth.x / 20000;
  }
  const auto of = [&](MerlLookup lookup) { return error[static_cast<int>(lookup)]; };
  CHECK(of(MerlLookup::tricubic_log) < of(MerlLookup::trilinear_log) / 10);
  CHECK(of(MerlLookup::trilinear_log) < of(MerlLookup::trilinear));
  CHECK(of(MerlLookup::trilinear) < of(MerlLookup::trilinear_edge) / 10);
  CHECK(of(MerlLookup::trilinear) < of(MerlLookup::nearest) / 10);
}

TEST_CASE("reflected light worked out by hand") {
  // The table holds bin numbers, the light's channels are 1, 10 and 100, the surface faces +z.
  const std::shared_ptr<const MerlTable> table(std::shared_ptr<void>(), &index_table());
  const Merl merl{table, MerlLookup::nearest, MerlAngles::closed};
  // test_half_difference.cpp: theta_h = 20.6165, theta_d = 19.9127, phi_d = 131.8426 degrees.
  // u = 90 sqrt(20.6165 / 90) = 43.08, v = 19.91, w = 131.84: f = (43, 19, 131); times n.l = 0.8 and the light.
  const Rgb<double> skew = reflected(merl, {0.6, 0, 0.8}, {0, 0.28, 0.96});
  CHECK(skew.x == doctest::Approx(0.8 * 43));
  CHECK(skew.y == doctest::Approx(0.8 * 190));
  CHECK(skew.z == doctest::Approx(0.8 * 13100));
  // The same by trilinear at bin centres: half a bin less.
  const Rgb<double> smooth =
      reflected({table, MerlLookup::trilinear, MerlAngles::closed}, {0.6, 0, 0.8}, {0, 0.28, 0.96});
  CHECK(smooth.x == doctest::Approx(0.8 * (90 * std::sqrt(20.6164655 / 90) - 0.5)).epsilon(1e-6));
  CHECK(smooth.y == doctest::Approx(8 * (19.9126856 - 0.5)).epsilon(1e-6));
  CHECK(smooth.z == doctest::Approx(80 * (131.8425599 - 0.5)).epsilon(1e-6));
  // Light, eye and normal along one line: theta_h = theta_d = 0 and phi_d is a right angle, in bin 90.
  CHECK(reflected(merl, {0, 0, 1}, {0, 0, 1}) == Rgb<double>(0, 0, 9000));
  // There is no ambient light, and no texture.
  CHECK(ambient(merl, Fragment<double>{}) == Rgb<double>(0));
}

TEST_CASE("a measured surface is black from behind and by light from behind") {
  const auto table = table_of([](int, int, int) { return Rgb<double>(1); });
  UndefinedCounts counts;
  for (const MerlLookup lookup : all_lookups)
    for (const MerlAngles angles : {MerlAngles::closed, MerlAngles::rotation, MerlAngles::frame}) {
      const Merl merl{table, lookup, angles};
      CHECK(reflected(merl, {0.6, 0, 0.8}, {0, 0.6, 0.8}, &counts).x == doctest::Approx(0.8));
      const Double3 black[][2] = {
          {{0.6, 0, -0.8}, {0, 0.6, 0.8}}, // light below the horizon
          {{0.6, 0, 0.8}, {0, 0.6, -0.8}}, // eye below it
          {{1, 0, 0}, {0, 0.6, 0.8}},      // light at the horizon
          {{0.6, 0, 0.8}, {0, 1, 0}},      // eye at it
          {{1, 0, 0}, {-1, 0, 0}},         // both, opposite: no half vector
          {{0, 0, 0}, {0, 0.6, 0.8}},      // light at the surface
          {{0.6, 0, 0.8}, {0, 0, 0}},      // eye at the surface
      };
      for (const auto& [l, v] : black) CHECK(reflected(merl, l, v, &counts) == Rgb<double>(0));
    }
  for (const std::uint64_t count : counts.counts) CHECK(count == 0);
}

TEST_CASE("what was never measured is black and counted, once a light and sample that could have been lit") {
  const auto table = table_of([](int, int, int) { return Rgb<double>(-1); });
  for (const MerlLookup lookup : all_lookups) {
    UndefinedCounts counts;
    CHECK(reflected({table, lookup, MerlAngles::closed}, {0.6, 0, 0.8}, {0, 0.6, 0.8}, &counts) == Rgb<double>(0));
    CHECK(counts[Undefined::unmeasured_brdf] == 1);
    CHECK(reflected({table, lookup, MerlAngles::closed}, {0.6, 0, -0.8}, {0, 0.6, 0.8}, &counts) == Rgb<double>(0));
    CHECK(counts[Undefined::unmeasured_brdf] == 1);
  }
}

TEST_CASE_TEMPLATE("a measured BRDF is reciprocal to the last bit", F, double, float) {
  std::mt19937_64 random(5);
  for (int k = 0; k < 20000; ++k) {
    const SurfacePair at = random_pair(random);
    const Vec3<F> n = as<F>(at.n), i = as<F>(at.i), o = as<F>(at.o);
    for (const MerlLookup lookup : all_lookups) {
      const Rgb<F> there =
          merl_value(*ragged_table(), lookup, merl_point(half_difference(MerlAngles::closed, n, i, o))).f;
      const Rgb<F> back =
          merl_value(*ragged_table(), lookup, merl_point(half_difference(MerlAngles::closed, n, o, i))).f;
      REQUIRE(there == back);
    }
  }
}

TEST_CASE_TEMPLATE("a precision makes only the copies of the table that it reads", F, double, float) {
  const auto table = table_of([](int h, int, int) { return Rgb<double>(h == 3 ? -0.5 : 1e300); });
  const F* const values = table->template values<F>();
  CHECK(values == table->template values<F>());
  CHECK(std::isfinite(values[0]));
  CHECK(values[MerlTable::offset(3, 0, 0)] < 0);
  const F* const logarithms = table->template log_values<F>();
  CHECK(logarithms == table->template log_values<F>());
  CHECK(logarithms[0] == doctest::Approx(std::log2(1e300 / 1e-4)));
  CHECK(logarithms[MerlTable::offset(3, 0, 0)] == -1);
}
