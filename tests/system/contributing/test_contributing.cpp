// The worked example of CONTRIBUTING.md does what that page says.

#include "math/bounds/interval_functions.h"
#include "shading/fragment_functions.h"
#include "shading/minnaert.h"

#include <doctest/doctest.h>

#include <fstream>
#include <string>

namespace refraster {

#include "worked_by_hand.inc"

TEST_CASE("the example runs over every number") {
  const auto shaded = []<class T>(T) {
    const Vec3<T> up(T(0), T(0), T(1));
    return Minnaert{}(Fragment<T>{up, up, up, Rgb<T>(T(1)), nullptr}, Incident<T>{up, Rgb<T>(T(1))});
  };
  CHECK(shaded(0.0).x == 1);
  CHECK(shaded(0.0f).x == 1);
  CHECK(shaded(Wide<float, 8>(0)).x[7] == 1);
  CHECK(shaded(Wide<double, 4>(0)).x[3] == 1);
  using Bounds = Interval<DoubleArithmetic>;
  CHECK(shaded(Bounds(0)).x.lo <= 1);
  CHECK(shaded(Bounds(0)).x.hi >= 1);
}

TEST_CASE("the example has fewer than 40 lines of header") {
  std::ifstream header(REFRASTER_BUILD_DIR "/tests/system/contributing/shading/minnaert.h");
  int lines = 0;
  for (std::string line; std::getline(header, line);) ++lines;
  CHECK(lines > 0);
  CHECK(lines < 40);
}

} // namespace refraster
