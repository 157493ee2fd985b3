// Angles, there and back.

#include "brdf/angles.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace refraster;

TEST_CASE("a pair of directions has the angles that it was made of") {
  for (const double theta_in : {0.5, 30.0, 60.0, 89.0})
    for (const double theta_out : {0.25, 45.0, 90.0})
      for (const double dphi : {0.0, 30.0, 90.0, 179.0, 180.0}) {
        const InOutAngles back = in_out_angles(directions_of(InOutAngles{theta_in, theta_out, dphi}));
        CHECK(back.theta_in == doctest::Approx(theta_in).epsilon(1e-14));
        CHECK(back.theta_out == doctest::Approx(theta_out).epsilon(1e-14));
        CHECK(back.dphi == doctest::Approx(dphi).epsilon(1e-13));
      }
  for (const double theta_h : {0.001, 1.0, 45.0, 89.0})
    for (const double theta_d : {0.001, 30.0, 89.0})
      for (const double phi_d : {0.0, 1.0, 90.0, 179.0}) {
        const HalfDifferenceAngles back =
            half_difference_angles(directions_of(HalfDifferenceAngles{theta_h, theta_d, phi_d}));
        CHECK(back.theta_h == doctest::Approx(theta_h).epsilon(1e-11));
        CHECK(back.theta_d == doctest::Approx(theta_d).epsilon(1e-11));
        // phi_d is an angle around a small circle: what it may be off grows as that shrinks; 0 and 180 are one.
        const double off = std::abs(std::remainder(back.phi_d - phi_d, 180));
        CHECK(off * std::sin(theta_h / 57.3) * std::sin(theta_d / 57.3) < 1e-12);
      }
}

TEST_CASE("a mirror's pair has its half vector along the normal") {
  const DirectionPair mirror = directions_of(InOutAngles{30, 30, 180});
  CHECK(mirror.i.x == 0.5);
  CHECK(mirror.o.x == -0.5);
  CHECK(mirror.i.z == mirror.o.z);
  CHECK(half_difference_angles(mirror).theta_h == 0);
  CHECK(half_difference_angles(mirror).theta_d == doctest::Approx(30).epsilon(1e-15));
}

TEST_CASE("the centres of a table's bins are where its angles say") {
  const DirectionPair centre = directions_at_centre(10, 20, 30);
  const double root = 10.5 / 90;
  const DirectionPair same = directions_of(HalfDifferenceAngles{root * root * 90, 20.5, 30.5});
  CHECK(length(centre.i - same.i) < 1e-15);
  CHECK(length(centre.o - same.o) < 1e-15);
}
