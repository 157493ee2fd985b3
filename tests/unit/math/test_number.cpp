#include "math/elementary.h"
#include "math/precisions.h"
#include "math/read_grid.h"
#include "tests/support/for_all.h"

namespace refraster {
namespace {

static_assert(Number<double> && Number<float>);
static_assert(Number<Wide<double, 2>> && Number<Wide<double, 8>> && Number<Wide<float, 4>> && Number<Wide<float, 16>>);
static_assert(
    std::is_trivial_v<Wide<float, 8>>); // glm::vec holds it in a union-free struct, copied by moves of registers

TEST_CASE_TEMPLATE("a cell is the integer below and the way from there", F, double, float) {
  for_all(5000, [](Random& random) {
    const F x = F(random.sign() * random.log_uniform(1e-3, 1e6));
    const Cell<F> at = floor_and_fraction(x);
    CHECK(F(at.index) <= x);
    CHECK(at.fraction >= 0);
    CHECK(at.fraction < 1);
    const double rounding = epsilon_of<F> / 2; // of a fraction, at most
    CHECK(std::abs(at.index + static_cast<double>(at.fraction) - static_cast<double>(x)) <= rounding);
  });
  CHECK(floor_and_fraction(F(-0.25)).index == -1);
  CHECK(floor_and_fraction(F(-0.25)).fraction == F(0.75));
  CHECK(floor_and_fraction(F(-3)).index == -3);
  CHECK(floor_and_fraction(F(-3)).fraction == 0);
}

TEST_CASE_TEMPLATE("a cell far away is the last that an index can name", F, double, float) {
  using Limits = std::numeric_limits<F>;
  constexpr std::int32_t limit = 1 << 30;
  for (const F x : {F(1e30), Limits::max(), Limits::infinity()}) {
    CHECK(floor_and_fraction(x).index == limit);
    CHECK(floor_and_fraction(-x).index == -limit);
    CHECK(floor_and_fraction(x).fraction == 0);
  }
  CHECK(floor_and_fraction(Limits::quiet_NaN()).index == -limit);
}

TEST_CASE_TEMPLATE("the fraction just below an integer does not round up to 1", F, double, float) {
  const F tiny = std::numeric_limits<F>::denorm_min();
  CHECK(floor_and_fraction(-tiny).index == -1);
  CHECK(floor_and_fraction(-tiny).fraction < 1);
  CHECK(floor_and_fraction(std::nextafter(F(1), F(0))).fraction < 1);
}

TEST_CASE("an index wraps as the mathematical remainder") {
  for_all(5000, [](Random& random) {
    const std::int32_t n = 1 + random.below(1 << random.below(17)), i = random.below(n),
                       turns = random.below(2001) - 1000;
    CHECK(wrap_index(i + n * turns, n) == i);
  });
}

TEST_CASE_TEMPLATE("scaling by the reciprocal binade brings every normal number into [1, 2)", F, double, float) {
  using Limits = std::numeric_limits<F>;
  for_all(5000, [](Random& random) {
    const F x = random.any_finite<F>();
    const F scale = reciprocal_binade(x);
    CHECK(std::isnormal(scale));
    if (std::isnormal(x) && std::abs(x) < Limits::max() / 2) {
      CHECK(std::abs(x) * scale >= 1);
      CHECK(std::abs(x) * scale < 2);
    }
  });
  for (const F x : {F(0), Limits::denorm_min(), Limits::max(), Limits::infinity(), Limits::quiet_NaN()}) {
    const F scale = reciprocal_binade(x);
    CHECK(std::isnormal(scale));
    int exponent = 0;
    CHECK(std::frexp(scale, &exponent) == F(0.5)); // a power of two
    CHECK((x * scale == 0) == (x == 0));
  }
  CHECK(std::isfinite(Limits::max() * reciprocal_binade(Limits::max())));
}

TEST_CASE_TEMPLATE("length and direction survive components at the ends of the range", F, double, float) {
  using Limits = std::numeric_limits<F>;
  for (const F size : {F(1e30), F(1e-30), Limits::max() / 2, Limits::min(), Limits::denorm_min()}) {
    const Vec3<F> along = normalize(Vec3<F>(size, F(0), F(0)));
    CHECK(std::abs(along.x - 1) <= Limits::epsilon());
    CHECK(length(Vec3<F>(F(0), -size, F(0))) == size);
    const Vec3<F> diagonal = normalize(Vec3<F>(size, size, size));
    CHECK(std::abs(diagonal.y - F(0.57735026918962576)) <= 2 * Limits::epsilon());
  }
  if constexpr (sizeof(F) == 8) CHECK(length(Vec3<F>(F(3e300), F(4e300), F(0))) == doctest::Approx(5e300));
  CHECK(normalize(Vec3<F>(F(0))) == Vec3<F>(F(0)));
  CHECK(length(Vec3<F>(F(0))) == 0);
}

TEST_CASE_TEMPLATE("normalised vectors are as long as highlights assume", F, double, float) {
  for_all(20000, [](Random& random) {
    const Vec3<F> v(F(random.uniform(-1, 1)), F(random.uniform(-1, 1)), F(random.uniform(-1, 1)));
    const Vec3<long double> n(normalize(v));
    const long double squared = n.x * n.x + n.y * n.y + n.z * n.z;
    CHECK(std::abs(std::sqrt(squared) - 1) <= 2.25 * epsilon_of<F>); // 4.5 u in the derivation of cosine_power
  });
}

TEST_CASE("a lookup takes each lane's own value") {
  const auto fetch = [](std::int32_t i, std::int32_t j, std::int32_t k) {
    return Rgb<float>(static_cast<float>(i), static_cast<float>(j), static_cast<float>(k));
  };
  WideIndex<4> i = {{1, 2, 3, 4}}, j = {{5, 6, 7, 8}}, k = {{9, 10, 11, 12}};
  const auto rgb = stored_value<Wide<float, 4>>(fetch, i, j, k);
  for (int lane = 0; lane < 4; ++lane) {
    CHECK(rgb.x[lane] == static_cast<float>(1 + lane));
    CHECK(rgb.y[lane] == static_cast<float>(5 + lane));
    CHECK(rgb.z[lane] == static_cast<float>(9 + lane));
  }
}

} // namespace
} // namespace refraster
