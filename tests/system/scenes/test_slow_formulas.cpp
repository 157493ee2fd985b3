// The second renderer has a formula of its own for whatever it may be asked.

#include "tests/support/shading/each_fragment_function.h"
#include "tests/support/slow/slow_shading.h"

#include <doctest/doctest.h>

using namespace refraster;

TEST_CASE("the slow renderer has a formula for every fragment function") {
  for (const FragmentFunction& function : each_fragment_function())
    CHECK_MESSAGE(slow::has_formula(function),
                  name_of(function) << " has no formula: shaded_by in tests/support/slow/slow_shading.cpp");
}
