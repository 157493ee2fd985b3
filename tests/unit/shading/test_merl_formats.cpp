// A table in its formats: double, float, half.

#include "math/precisions.h"
#include "scenes/synthesis/merl_synthesis.h"
#include "shading/merl_lookup.h"
#include "tests/support/shading/merl_tables.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace refraster;

namespace {

/// A metal sharp enough that its highlight is beyond the largest half.
const MerlTable& mirror_table() {
  static const MerlTable table = merl_table_from(GgxConductor{0.001, Double3(0.9, 0.8, 0.7)});
  return table;
}

/// The least power of two times the size of a half's last place, for a value of this size.
double half_ulp_of_half(double size) {
  return std::ldexp(1.0, std::max(std::ilogb(size), -14) - 11);
}

double greatest(const MerlTable& table) {
  const double* const values = table.values<double>();
  return *std::max_element(values, values + 3 * MerlTable::samples);
}

void check_halves(const MerlTable& table) {
  const double unit = table.unit<Half>();
  int exponent;
  CHECK(std::frexp(unit, &exponent) == 0.5); // a power of two
  CHECK(greatest(table) / unit <= Half::largest);
  CHECK(greatest(table) / unit > Half::largest / 2);
  const double* const values = table.values<double>();
  const Half* const halves = table.values<Half>();
  std::size_t wrong = 0, negative = 0;
  for (std::size_t i = 0; i < 3 * MerlTable::samples; ++i) {
    const double half = static_cast<double>(static_cast<float>(halves[i]));
    if (values[i] < 0) {
      ++negative;
      wrong += half != -1;
    } else {
      wrong += half < 0 || std::abs(half - values[i] / unit) > half_ulp_of_half(values[i] / unit);
    }
  }
  CHECK(wrong == 0);
  CHECK(negative > 0);
}

} // namespace

TEST_CASE("every half is the nearest one to its value, and what was never measured stays so") {
  check_halves(mirror_table());
  check_halves(*ragged_table());
  CHECK(greatest(mirror_table()) > Half::largest);
}

TEST_CASE("a black table, and one of huge or tiny values, have halves too") {
  for (const double value : {0.0, 1e-300, 1e-20, 65504.0, 65505.0, 1e20, 1e300}) {
    const auto table = table_of([&](int h, int, int) { return Rgb<double>(h == 3 ? -0.5 : value, 0, value); });
    CHECK(static_cast<float>(table->values<Half>()[0]) >= 0);
    CHECK(static_cast<float>(table->values<Half>()[MerlTable::offset(3, 0, 0)]) == -1);
    const double read = table->unit<Half>() * static_cast<double>(static_cast<float>(table->values<Half>()[0]));
    if (value >= 1e-20 && value <= 1e20) CHECK(std::abs(read - value) <= value * 0x1p-11);
    CHECK(static_cast<float>(read) <= std::numeric_limits<float>::max());
  }
}

TEST_CASE("lanes read halves with the bits of one number alone") {
  using T = Native<float>;
  constexpr int lanes = NumberTraits<T>::lanes;
  std::mt19937_64 random(8);
  for (int k = 0; k < 20000; ++k) {
    MerlPoint<T> at;
    for (int lane = 0; lane < lanes; ++lane) {
      at.u.set(lane, static_cast<float>(uniform(random, -1, 91)));
      at.v.set(lane, static_cast<float>(uniform(random, -1, 91)));
      at.w.set(lane, static_cast<float>(uniform(random, -1, 181)));
    }
    for (const MerlLookup lookup : {MerlLookup::nearest, MerlLookup::trilinear, MerlLookup::trilinear_edge}) {
      const auto all = merl_value<T, Half>(*ragged_table(), lookup, at);
      for (int lane = 0; lane < lanes; ++lane) {
        const auto alone =
            merl_value<float, Half>(*ragged_table(), lookup, MerlPoint<float>{at.u[lane], at.v[lane], at.w[lane]});
        REQUIRE(all.f.x[lane] == alone.f.x);
        REQUIRE(all.f.y[lane] == alone.f.y);
        REQUIRE(all.f.z[lane] == alone.f.z);
      }
    }
  }
}

TEST_CASE("a lookup in halves is as far from one in floats as halves are from floats") {
  std::mt19937_64 random(9);
  for (int k = 0; k < 100000; ++k) {
    const auto [n, i, o] = k % 2 ? specular_pair(random) : random_pair(random);
    const MerlPoint<float> at =
        merl_point(half_difference(MerlAngles::closed, as<float>(n), as<float>(i), as<float>(o)));
    for (const MerlLookup lookup : {MerlLookup::nearest, MerlLookup::trilinear}) {
      const Rgb<float> exact = merl_value<float, float>(mirror_table(), lookup, at).f;
      const Rgb<float> halves = merl_value<float, Half>(mirror_table(), lookup, at).f;
      for (int c = 0; c < 3; ++c) {
        // A mean with weights that are not negative: relative errors of 2^-11, or half the least subnormal. Computing
        // it rounds seven sums, seven products, a quotient and a product more, in either: 32 times 2^-24.
        const double bound =
            static_cast<double>(exact[c]) * (0x1p-11 + 32 * 0x1p-24) + 0x1p-25 * mirror_table().unit<Half>();
        REQUIRE(std::abs(static_cast<double>(halves[c]) - static_cast<double>(exact[c])) <= bound);
      }
    }
  }
}

// What a precision's number says, or leaves out.
struct NumberOfHalves {};
template <>
struct refraster::NumberTraits<NumberOfHalves> {
  using Real = float;
  using TableReal = Half;
};

TEST_CASE("the precision chooses the format of tables") {
  CHECK(std::is_same_v<TableRealOf<double>, double>);
  CHECK(std::is_same_v<TableRealOf<Native<float>>, float>);
  CHECK(std::is_same_v<TableRealOf<NumberOfHalves>, Half>);
}
