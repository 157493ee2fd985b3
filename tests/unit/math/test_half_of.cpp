// Rounding to half precision: once, from double.

#include "math/half_of.h"
#include "tests/support/for_all.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace refraster {
namespace {

/// IEEE 754-2008, 3.4: what the bits of a half that is not negative mean.
double meaning(int bits) {
  const int exponent = bits >> 10, fraction = bits & 1023;
  return exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
}

constexpr int finite_sizes = 31 << 10; // the patterns below infinity

/// By searching the halves, which are in the order of their bits.
int nearest_half(double size) {
  int low = 0, high = finite_sizes - 1;
  if (size >= meaning(high)) return high;
  while (high - low > 1) (meaning((low + high) / 2) <= size ? low : high) = (low + high) / 2;
  const double below = size - meaning(low), above = meaning(high) - size; // exact: both lie close
  return below < above ? low : below > above ? high : low % 2 == 0 ? low : high;
}

} // namespace

TEST_CASE("every half is the half of what it means") {
  for (int size = 0; size < finite_sizes; ++size) {
    REQUIRE(half_of(meaning(size)).bits == size);
    if (size > 0) REQUIRE(half_of(-meaning(size)).bits == (size | 0x8000));
  }
}

TEST_CASE("a number becomes the nearest half, the even one halfway") {
  for (int size = 0; size + 1 < finite_sizes; ++size) {
    const double low = meaning(size), high = meaning(size + 1), middle = (low + high) / 2;
    const int even = size % 2 ? size + 1 : size;
    REQUIRE(half_of(middle).bits == even);
    REQUIRE(half_of(-middle).bits == (even | 0x8000));
    REQUIRE(half_of(std::nextafter(middle, low)).bits == size);
    REQUIRE(half_of(std::nextafter(middle, high)).bits == size + 1);
  }
  for (const double beyond : {65505.0, 65520.0, 1e10, 1e300, HUGE_VAL}) {
    CHECK(half_of(beyond).bits == finite_sizes - 1);
    CHECK(half_of(-beyond).bits == (0x8000 | (finite_sizes - 1)));
  }
  for (const double nothing : {0.0, 0x1p-26, 1e-300, 4.9e-324}) {
    CHECK(half_of(nothing).bits == 0);
    CHECK(half_of(-nothing).bits == (nothing == 0 ? 0 : 0x8000));
  }
}

TEST_CASE("a double is rounded once, also where a float between would have come to lie halfway") {
  for_all(100000, [](Random& random) {
    // Near a middle between two halves, by less than a float can tell; or anywhere.
    const int at = random.below(finite_sizes - 1);
    const double middle = (meaning(at) + meaning(at + 1)) / 2;
    const double size = random.below(2) ? middle * (1 + random.sign() * random.log_uniform(0x1p-52, 0x1p-20))
                                        : random.log_uniform(0x1p-30, 0x1p17);
    REQUIRE(half_of(size).bits == nearest_half(size));
    REQUIRE(half_of(-size).bits == (nearest_half(size) | 0x8000));
  });
}

} // namespace refraster
