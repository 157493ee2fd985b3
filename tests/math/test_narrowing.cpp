#include "math/vec.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster {
namespace {

// GCC 12 drops the rounding to float from double > float > double where its SLP pass finds two or more of them side by
// side. These functions offer it that chance: if the flag that keeps the pass out is lost, values come back unrounded.
[[gnu::noinline]] void narrow_pair(const double* from, double* to) {
  to[0] = static_cast<double>(static_cast<float>(from[0]));
  to[1] = static_cast<double>(static_cast<float>(from[1]));
}
[[gnu::noinline]] Double3 narrow_triple(const Double3& from) {
  return Double3(Float3(from));
}
[[gnu::noinline]] void narrow_sums(const double* a, const double* b, double* to) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<double>(static_cast<float>(a[i] + b[i]));
}

/// Rounded to float by hand: no conversion for the compiler to drop.
double nearest_float(double x) {
  int exponent = 0;
  const double significand = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(significand, 24)), exponent - 24);
}

TEST_CASE("narrowing is kept: a double that was rounded to float stays rounded") {
  const double thirds[] = {1.0 / 3, 2.0 / 3, 1e10 / 3, 1e-10 / 3}, zeros[] = {0, 0, 0, 0};
  double pair[2], sums[4];
  narrow_pair(thirds, pair);
  narrow_sums(thirds, zeros, sums);
  const Double3 triple = narrow_triple(Double3(thirds[0], thirds[1], thirds[2]));
  for (int i = 0; i < 4; ++i) {
    const double expected = nearest_float(thirds[i]);
    REQUIRE(expected != thirds[i]);
    CHECK(sums[i] == expected);
    if (i < 3) CHECK(triple[i] == expected);
    if (i < 2) CHECK(pair[i] == expected);
  }
}

} // namespace
} // namespace refraster
