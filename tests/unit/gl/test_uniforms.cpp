// What a shader is given of a fragment function that the library does not know.

#include <refraster/fragment_kit.h>

#include "gl/draw/uniforms.h"
#include "gl/glsl/own_glsl.h"
#include "shading/fragment_functions.h"

#include <doctest/doctest.h>

namespace own {
using namespace refraster;

struct Sheen : BlinnPhong {
  static constexpr std::string_view name = "gloss";
};
template <Number T>
Rgb<T> ambient(const Sheen& gloss, const Fragment<T>& at) {
  return refraster::ambient(static_cast<const BlinnPhong&>(gloss), at);
}
template <Number T>
Rgb<T> reflected(const Sheen& gloss, const Fragment<T>& at, const Incident<T>& light) {
  return refraster::reflected(static_cast<const BlinnPhong&>(gloss), at, light);
}

} // namespace own

using namespace refraster;

TEST_CASE("parameters of a fragment function of one's own are uniforms of their names, and it has no GLSL of ours") {
  own::Sheen gloss;
  gloss.kd = {0.25, 0.5, 0.75}, gloss.glossiness = 33, gloss.specular_gate = SpecularGate::cut_below_horizon;
  Object object;
  object.mesh = std::make_shared<const Mesh>(cube_mesh());
  object.material.user_function = user_function(gloss);
  const UniformValues values = object_uniforms(object, Double4x4(1.0));
  CHECK(std::get<Float3>(values.at("kd")) == Float3(0.25f, 0.5f, 0.75f));
  CHECK(std::get<float>(values.at("glossiness")) == 33.f);
  CHECK(std::get<int>(values.at("specular_gate")) == 1);
  CHECK(values.count("model") == 1);
  CHECK(!has_own_glsl(object.material));
}
