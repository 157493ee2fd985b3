// There is GLSL of ours for whatever a scene may name; drivers are not asked.

#include "gl/glsl/own_glsl.h"
#include "tests/support/shading/each_fragment_function.h"

#include <doctest/doctest.h>

using namespace refraster;

TEST_CASE("every fragment function has GLSL") {
  for (const FragmentFunction& function : each_fragment_function()) {
    Material material;
    material.fragment_function = function;
    CHECK_MESSAGE(has_own_glsl(material), name_of(function) << " has no GLSL: formulas_of in gl/glsl/own_glsl.cpp");
  }
}
