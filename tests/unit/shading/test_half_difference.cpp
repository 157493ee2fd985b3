// Half and difference angles: three methods against each other, and against 50 digits.

#include "math/precisions.h"
#include "shading/half_difference.h"
#include "tests/support/shading/directions.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <doctest/doctest.h>

#include <initializer_list>

using namespace refraster;

namespace {

using Mpfr = boost::multiprecision::cpp_bin_float_50;
constexpr double pi = std::numbers::pi;
constexpr double degree = pi / 180;
constexpr MerlAngles all_methods[] = {MerlAngles::closed, MerlAngles::rotation, MerlAngles::frame};

struct Exact3 {
  Mpfr x, y, z;
};
Exact3 operator+(const Exact3& a, const Exact3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Exact3 operator-(const Exact3& a, const Exact3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Exact3 operator*(const Exact3& a, const Mpfr& s) {
  return {a.x * s, a.y * s, a.z * s};
}
Mpfr inner(const Exact3& a, const Exact3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Exact3 outer(const Exact3& a, const Exact3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Exact3 unit(const Exact3& a) {
  return a * (1 / sqrt(inner(a, a)));
}
Exact3 unit(const Double3& a) {
  return unit(Exact3{a.x, a.y, a.z});
}

/// The definition, word for word: half vector, arc cosines, and the azimuth of i in a frame whose pole is h.
HalfDifference<Mpfr> by_definition(const SurfacePair& pair) {
  const Exact3 n = unit(pair.n), i = unit(pair.i), o = unit(pair.o), h = unit(i + o);
  const Exact3 x = unit(h * inner(n, h) - n), y = outer(h, x);
  Mpfr phi = atan2(inner(i, y), inner(i, x));
  if (phi < 0) phi += boost::math::constants::pi<Mpfr>();
  return {acos(inner(n, h)), acos(inner(i, h)), phi};
}

double distance(double a, const Mpfr& b) {
  return static_cast<double>(abs(b - a));
}
/// On a circle of length pi.
double distance_mod_pi(double a, const Mpfr& b) {
  const Mpfr away = abs(b - a);
  const Mpfr around = boost::math::constants::pi<Mpfr>() - away;
  return static_cast<double>(away < around ? away : around);
}

HalfDifference<double> angles_of(MerlAngles method, const SurfacePair& at) {
  return half_difference(method, at.n, at.i, at.o);
}

using Family = SurfacePair (*)(std::mt19937_64&);

/// The largest |phi - phi'| sin(theta_h) sin(theta_d) between any two methods: the azimuth of a vector of length
/// sin(theta_d), counted from one of length sin(theta_h), is no better known than that. Where light and eye come to
/// oppose each other, a last bit in their lengths turns i + o by that bit over |i + o| = 2 cos(theta_d): counted
/// `per_half`, the disagreement is multiplied by that cosine too.
enum class Weight { per_angles, per_half };

double largest_disagreement(Family family, int pairs, Weight weighting = Weight::per_angles) {
  std::mt19937_64 random(1);
  double largest = 0;
  for (int k = 0; k < pairs; ++k) {
    const SurfacePair at = family(random);
    const HalfDifference<double> closed = angles_of(MerlAngles::closed, at);
    double weight = std::sin(closed.theta_h) * std::sin(closed.theta_d);
    if (weighting == Weight::per_half) weight *= std::cos(closed.theta_d);
    double phi[3];
    for (const MerlAngles method : all_methods) phi[static_cast<int>(method)] = angles_of(method, at).phi_d;
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      const double away = std::abs(phi[a] - phi[b]);
      largest = std::max(largest, std::min(away, pi - away) * weight);
    }
  }
  return largest;
}

} // namespace

TEST_CASE("half and difference angles worked out by hand") {
  const Double3 n(0, 0, 1);
  for (const MerlAngles method : all_methods) {
    CAPTURE(name_of(method));
    // s = (0.6, 0.28, 1.76), d = (0.6, -0.28, -0.16).
    // Then tan theta_h = |(0.6, 0.28)| / 1.76 = 0.662118 / 1.76, tan theta_d = |d| / |s| = 0.681175 / 1.880426,
    // phi_d = atan2(2 (0.6 * 0.28), -0.16 |s|) = atan2(0.336, -0.300868).
    const HalfDifference<double> skew = half_difference(method, n, Double3(0.6, 0, 0.8), Double3(0, 0.28, 0.96));
    CHECK(skew.theta_h == doctest::Approx(20.61647 * degree).epsilon(1e-5));
    CHECK(skew.theta_d == doctest::Approx(19.91269 * degree).epsilon(1e-5));
    CHECK(skew.phi_d == doctest::Approx(131.84256 * degree).epsilon(1e-5));
    // Eye at the normal: h halves the angle between them, 36.8699 degrees; light, eye and normal lie in one plane.
    const HalfDifference<double> flat = half_difference(method, n, Double3(0.6, 0, 0.8), n);
    CHECK(flat.theta_h == doctest::Approx(18.43495 * degree));
    CHECK(flat.theta_d == doctest::Approx(18.43495 * degree));
    CHECK(std::min(flat.phi_d, pi - flat.phi_d) < 1e-15);
  }
}

TEST_CASE("where no azimuth is defined it is a right angle") {
  const Double3 n(0, 0, 1), slanted(0.6, 0, 0.8);
  for (const MerlAngles method : all_methods) {
    CAPTURE(name_of(method));
    const auto check = [&](const Double3& i, const Double3& o, double theta_h, double theta_d) {
      const HalfDifference<double> angles = half_difference(method, n, i, o);
      CHECK(angles.theta_h == doctest::Approx(theta_h));
      CHECK(angles.theta_d == doctest::Approx(theta_d));
      CHECK(angles.phi_d == pi / 2);
    };
    check(n, n, 0, 0);                                      // h = n and i = o
    check(slanted, slanted, 36.8698976 * degree, 0);        // i = o
    check(slanted, {-0.6, 0, 0.8}, 0, 36.8698976 * degree); // h = n
    check({1, 0, 0}, {-1, 0, 0}, 0, pi / 2);                // i = -o, both grazing
    check(slanted, -slanted, 0, pi / 2);                    // i = -o
    check(Double3(0), Double3(0), 0, 0);                    // no directions at all
  }
}

TEST_CASE_TEMPLATE("all angles of all methods are finite and in range", F, double, float) {
  std::mt19937_64 random(2);
  const F special[] = {0, F(-0.0), 1, -1, F(1e-30), F(-1e-30), F(0.6), F(-0.8)};
  const auto component = [&] { return special[random() % std::size(special)]; };
  for (int k = 0; k < 20000; ++k) {
    const Vec3<F> n = normalize(Vec3<F>(component(), component(), component()));
    const Vec3<F> i = normalize(Vec3<F>(component(), component(), component()));
    const Vec3<F> o = normalize(Vec3<F>(component(), component(), component()));
    for (const MerlAngles method : all_methods) {
      const HalfDifference<F> angles = half_difference(method, n, i, o);
      REQUIRE((angles.theta_h >= 0 && angles.theta_h <= static_cast<F>(pi)));
      REQUIRE((angles.theta_d >= 0 && angles.theta_d <= static_cast<F>(pi / 2)));
      REQUIRE((angles.phi_d >= 0 && angles.phi_d < static_cast<F>(pi)));
    }
  }
}

TEST_CASE_TEMPLATE("swapping light and eye changes no bit of the closed form", F, double, float) {
  std::mt19937_64 random(3);
  for (const Family family : {random_pair, specular_pair, retro_reflective_pair, opposite_grazing_pair})
    for (int k = 0; k < 20000; ++k) {
      const SurfacePair at = family(random);
      const Vec3<F> n = as<F>(at.n), i = as<F>(at.i), o = as<F>(at.o);
      const HalfDifference<F> there = half_difference(MerlAngles::closed, n, i, o);
      const HalfDifference<F> back = half_difference(MerlAngles::closed, n, o, i);
      REQUIRE(there.theta_h == back.theta_h);
      REQUIRE(there.theta_d == back.theta_d);
      REQUIRE(there.phi_d == back.phi_d);
    }
}

// Rounding moves the two vectors whose angle phi_d is by some 20 u, u = 2^-53, and the angle by that over their
// lengths. 1e-12 is the promise of docs/merl.md, which leaves room for |i + o| down to 5e-3; per_half, 64 u is 3 times
// 20 u.
TEST_CASE("the three methods agree on phi_d") {
  CHECK(largest_disagreement(random_pair, 20000) <= 1e-12);
  CHECK(largest_disagreement(specular_pair, 20000) <= 1e-12);
  CHECK(largest_disagreement(retro_reflective_pair, 20000) <= 1e-12);
  CHECK(largest_disagreement(opposite_grazing_pair, 20000, Weight::per_half) <= 64 * 0x1p-53);
}

TEST_CASE("the closed form is right to a few roundings against 50 digits") {
  std::mt19937_64 random(4);
  for (const Family family : {random_pair, specular_pair, retro_reflective_pair, opposite_grazing_pair})
    for (int k = 0; k < 1000; ++k) {
      const SurfacePair at = family(random);
      const HalfDifference<double> angles = angles_of(MerlAngles::closed, at);
      const HalfDifference<Mpfr> exact = by_definition(at);
      const double sin_h = static_cast<double>(sin(exact.theta_h)), sin_d = static_cast<double>(sin(exact.theta_d));
      const double cos_d = static_cast<double>(cos(exact.theta_d));
      // Errors in units of u = 2^-53, for i, o and n whose lengths are known to 2 u, which moves s and d by 2 u.
      // theta_h: n x s errs by 3.5 u |s|, its length, n.s and |s| by 3 u each, atan2 by 2 u of at most pi: 2 + 2 +
      // 3.5 + 9 + 6 < 24, over |s| / 2 = cos theta_d where the lengths of i and o differ.
      // theta_d: the same without the cross product, and s and d perpendicular: 2 + 2 + 6 + 4 < 16.
      // phi_d: (x, y) has length 4 sin_h sin_d cos_d and errs by 2 (3 u |d| + 4 u) and 2 (3.5 + 3 + 6) u: < 45 / 4.
      constexpr double u = 0x1p-53;
      REQUIRE(distance(angles.theta_h, exact.theta_h) * cos_d <= 24 * u);
      REQUIRE(distance(angles.theta_d, exact.theta_d) <= 16 * u);
      REQUIRE(distance_mod_pi(angles.phi_d, exact.phi_d) * sin_h * sin_d * cos_d <= 16 * u);
    }
}

TEST_SUITE("slow") {
  TEST_CASE("the three methods agree on phi_d on a million pairs of each family") {
    CHECK(largest_disagreement(random_pair, 1'000'000) <= 1e-12);
    CHECK(largest_disagreement(specular_pair, 1'000'000) <= 1e-12);
    CHECK(largest_disagreement(retro_reflective_pair, 1'000'000) <= 1e-12);
    CHECK(largest_disagreement(opposite_grazing_pair, 1'000'000, Weight::per_half) <= 64 * 0x1p-53);
  }
}
