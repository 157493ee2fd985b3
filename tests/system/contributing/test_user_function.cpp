// A fragment function of one's own is shaded as one of the library is: bit for bit.

#include <refraster/fragment_kit.h>
#include <refraster/mesh.h>
#include <refraster/render.h>

#include "shading/fragment_functions.h"
#include "tests/support/scenes/same_shading.h"

#include <doctest/doctest.h>

#include <string>

namespace own {
using namespace refraster;

/// Blinn-Phong under another name, registered from outside.
struct Gloss : BlinnPhong {
  static constexpr std::string_view name = "gloss";
};
template <Number T>
Rgb<T> ambient(const Gloss& gloss, const Fragment<T>& at) {
  return refraster::ambient(static_cast<const BlinnPhong&>(gloss), at);
}
template <Number T>
Rgb<T> reflected(const Gloss& gloss, const Fragment<T>& at, const Incident<T>& light) {
  return refraster::reflected(static_cast<const BlinnPhong&>(gloss), at, light);
}

} // namespace own

namespace {

using namespace refraster;

/// The scene, with every Blinn-Phong by the user's function.
Scene by_user(Scene scene) {
  for (Object& object : scene.objects)
    if (const auto* const blinn = std::get_if<BlinnPhong>(&object.material.fragment_function))
      object.material.user_function = user_function(own::Gloss{*blinn});
  return scene;
}

Scene two_balls() {
  Scene scene;
  scene.camera.position = {0, 0, 5};
  scene.point_lights = {{.position = {2, 3, 4}, .radiance = Double3(3), .quadratic = 0.1}};
  scene.direction_lights = {{{-1, -1, -1}, Double3(0.5)}};
  for (const double x : {-0.8, 0.9}) {
    Object object;
    object.mesh = std::make_shared<const Mesh>(sphere_mesh(24, 12));
    object.position = {x, 0.1, 0};
    BlinnPhong blinn;
    blinn.glossiness = x < 0 ? 0 : 33; // 0^0 is counted
    object.material.fragment_function = blinn;
    scene.objects.push_back(object);
  }
  return scene;
}

} // namespace

TEST_CASE("a fragment function of one's own gives the library's bits in every precision, with AOVs and counts") {
  const Scene built_in = two_balls();
  test::check_same_frames(built_in, by_user(built_in),
                          [](const Frame& frame) { CHECK(frame.counts.undefined[Undefined::zero_to_the_zero] > 0); });
}

TEST_CASE("and the library's bounds") {
  const Scene built_in = two_balls();
  test::check_same_bounds(built_in, by_user(built_in));
}

TEST_CASE("its parameters are shown one by one, words by number, and may be changed") {
  struct Visitor final : FieldVisitor {
    std::string seen;
    void field(std::string_view name, double& value, const Range&, std::string_view) override {
      seen += std::string(name) + " ", value = 3;
    }
    void field(std::string_view name, Double3&, const Range&, std::string_view) override {
      seen += std::string(name) + " ";
    }
    void field(std::string_view name, NamedValue& value, const Range&, std::string_view) override {
      seen += std::string(name) + "=" + std::string(value.names.at(value.index)), value.index = 1;
    }
  };
  const auto function = user_function(own::Gloss{});
  const auto copy = function->copy();
  Visitor first, second, of_original;
  copy->fields(first);
  CHECK(first.seen == "ka kd ks glossiness specular_gate=false");
  copy->fields(second);
  CHECK(second.seen == "ka kd ks glossiness specular_gate=true");
  function->fields(of_original);
  CHECK(of_original.seen == first.seen); // a copy of its own
}
