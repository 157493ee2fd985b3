#include "math/vec.h"

#include <doctest/doctest.h>

#include <cmath>

namespace refraster {
namespace {

// GCC 12 drops the rounding to float from double > float > double where its SLP pass finds two or more of them side by
// side. These functions offer it that chance: if the flag that keeps the pass out is lost, values come back unrounded.
struct Pair {
  double x, y;
};
[[gnu::noinline]] Pair narrow_pair(Pair from) {
  return {static_cast<double>(static_cast<float>(from.x)), static_cast<double>(static_cast<float>(from.y))};
}
[[gnu::noinline]] Double3 narrow_triple(Double3 from) {
  return Double3(Float3(from));
}
[[gnu::noinline]] void narrow_in_memory(const double* from, double* to) {
  to[0] = static_cast<double>(static_cast<float>(from[0]));
  to[1] = static_cast<double>(static_cast<float>(from[1]));
}

/// Rounded to float by hand: no conversion for the compiler to drop.
double nearest_float(double x) {
  int exponent = 0;
  const double significand = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(significand, 24)), exponent - 24);
}

TEST_CASE("narrowing is kept: a double that was rounded to float stays rounded") {
  const volatile double unknown_to_the_compiler[] = {1.0 / 3, 2.0 / 3, 1e10 / 3};
  const double thirds[] = {unknown_to_the_compiler[0], unknown_to_the_compiler[1], unknown_to_the_compiler[2]};
  const Pair pair = narrow_pair({thirds[0], thirds[1]});
  const Double3 triple = narrow_triple(Double3(thirds[0], thirds[1], thirds[2]));
  double stored[2];
  narrow_in_memory(thirds, stored);
  for (const double third : thirds) REQUIRE(nearest_float(third) != third);
  CHECK(pair.x == nearest_float(thirds[0]));
  CHECK(pair.y == nearest_float(thirds[1]));
  for (int i = 0; i < 2; ++i) CHECK(stored[i] == nearest_float(thirds[i]));
  for (int i = 0; i < 3; ++i) CHECK(triple[i] == nearest_float(thirds[i]));
}

} // namespace
} // namespace refraster
