#include "math/elementary.h"
#include "tests/support/accuracy.h"

#include <boost/math/constants/constants.hpp>

#include <limits>

namespace refraster {
namespace {

Mpfr exact_radians(double angle) {
  return Mpfr(std::fmod(angle, 360.0)) * boost::math::constants::pi<Mpfr>() / 180;
}
double some_angle(Random& random) {
  switch (random.below(3)) {
  case 0:
    return random.uniform(-360, 360);
  case 1:
    return 15 * (random.below(49) - 24) + random.sign() * random.log_uniform(1e-15, 1);
  default:
    return random.sign() * random.log_uniform(1e-10, 1e15);
  }
}

TEST_CASE("sine, cosine and tangent of degrees keep their error bounds") {
  check_error("sin_degrees", sin_degrees_error, 20000, [](Random& random) {
    const double angle = some_angle(random);
    return std::fmod(angle, 180) == 0 ? 0 : ulp_error(sin_degrees(angle), sin(exact_radians(angle)));
  });
  check_error("cos_degrees", cos_degrees_error, 20000, [](Random& random) {
    const double angle = some_angle(random);
    return std::fmod(angle, 90) == 0 ? 0 : ulp_error(cos_degrees(angle), cos(exact_radians(angle)));
  });
  check_error("tan_degrees", tan_degrees_error, 20000, [](Random& random) {
    const double angle = some_angle(random);
    return std::fmod(angle, 90) == 0 ? 0 : ulp_error(tan_degrees(angle), tan(exact_radians(angle)));
  });
}

TEST_CASE("whole turns change nothing, quarter turns swap sine and cosine, exactly") {
  for_all(5000, [](Random& random) {
    const double angle = std::ldexp(random.below(1 << 30), -22) - 128; // so that sums with multiples of 90 are exact
    const int quarters = random.below(2001) - 1000;
    const SineCosine start = sine_cosine_of_degrees(angle), turned = sine_cosine_of_degrees(angle + 90 * quarters);
    const double sine[] = {start.sine, start.cosine, -start.sine, -start.cosine};
    CHECK(turned.sine == sine[quarters & 3]);
    CHECK(turned.cosine == sine[(quarters + 1) & 3]);
    CHECK(sin_degrees(-angle) == -sin_degrees(angle));
    CHECK(cos_degrees(-angle) == cos_degrees(angle));
  });
}

TEST_CASE("sines of fractions of a turn are those of their angle, and as symmetrical as the fractions") {
  for_all(5000, [](Random& random) {
    const int whole = 1 + random.below(random.below(2) ? 1000 : 1 << 28), part = random.below(whole + 1);
    const SineCosine at = sine_cosine_of_turn(part, whole);
    const Mpfr angle = 2 * boost::math::constants::pi<Mpfr>() * part / whole;
    // Rounding the angle, which is pi/4 at most, moves either by less than 2^-53; rounding what they are, as well.
    CHECK(std::abs(at.sine - static_cast<double>(sin(angle))) <= 2 * 0x1p-53);
    CHECK(std::abs(at.cosine - static_cast<double>(cos(angle))) <= 2 * 0x1p-53);
    const SineCosine back = sine_cosine_of_turn(whole - part, whole);
    CHECK(back.sine == -at.sine);
    CHECK(back.cosine == at.cosine);
    const SineCosine doubled = sine_cosine_of_turn(2 * (part / 2), 2 * (whole / 2 + 1));
    const SineCosine reduced = sine_cosine_of_turn(part / 2, whole / 2 + 1);
    CHECK(doubled.sine == reduced.sine);
    CHECK(doubled.cosine == reduced.cosine);
    if (whole % 4 == 0 && part + whole / 4 <= whole) {
      const SineCosine turned = sine_cosine_of_turn(part + whole / 4, whole);
      CHECK(turned.sine == at.cosine);
      CHECK(turned.cosine == -at.sine);
    }
  });
}

TEST_CASE("angles that have simple sines have them exactly") {
  for (const double turn : {-720.0, -360.0, 0.0, 360.0, 360e9}) {
    CHECK(sin_degrees(turn) == 0);
    CHECK(sin_degrees(turn + 30) == 0.5);
    CHECK(sin_degrees(turn + 45) == cos_degrees(turn + 45));
    CHECK(sin_degrees(turn + 90) == 1);
    CHECK(sin_degrees(turn + 150) == 0.5);
    CHECK(sin_degrees(turn + 180) == 0);
    CHECK(sin_degrees(turn + 210) == -0.5);
    CHECK(sin_degrees(turn + 270) == -1);
    CHECK(cos_degrees(turn) == 1);
    CHECK(cos_degrees(turn + 60) == 0.5);
    CHECK(cos_degrees(turn + 90) == 0);
    CHECK(cos_degrees(turn + 120) == -0.5);
    CHECK(cos_degrees(turn + 180) == -1);
    CHECK(cos_degrees(turn + 300) == 0.5);
    CHECK(tan_degrees(turn) == 0);
    CHECK(tan_degrees(turn + 45) == 1);
    CHECK(tan_degrees(turn + 135) == -1);
    CHECK(tan_degrees(turn + 180) == 0);
  }
  CHECK(sin_degrees(60) == sin_degrees(120));
  CHECK(std::isinf(tan_degrees(90)));
}

TEST_CASE("an angle that is no number is no turn") {
  for (const double angle : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(sin_degrees(angle) == 0);
    CHECK(cos_degrees(angle) == 1);
  }
}

TEST_CASE("tiny angles keep their precision, down to subnormal ones") {
  CHECK(sin_degrees(1e-300) == doctest::Approx(radians(1e-300)));
  CHECK(ulp_error(sin_degrees(1e-200), exact_radians(1e-200)) <= sin_degrees_error.max);
  CHECK(cos_degrees(1e-200) == 1);
  CHECK(sin_degrees(std::numeric_limits<double>::denorm_min()) == 0);
}

} // namespace
} // namespace refraster
