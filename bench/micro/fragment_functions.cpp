// Fragment functions and what arrives of a light: a fragment and a light each.

#include "shading/fragment_functions.h"
#include "bench/micro/micro.h"
#include "bench/micro/table.h"
#include "shading/light.h"

#include <variant>

namespace refraster::micro {
namespace {

/// Normals about +z, light and eye above them.
template <class F>
struct Fragments {
  Vectors<F> normal{few}, to_light{few}, to_eye{few};

  Fragments() {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> slope(-0.7, 0.7);
    const auto leaning = [&] { return normalize(Double3(slope(random), slope(random), 1)); };
    for (std::size_t i = 0; i < few; ++i)
      normal.set(i, leaning()), to_light.set(i, leaning()), to_eye.set(i, leaning());
  }
  template <class T>
  Fragment<T> at(std::size_t i) const {
    return {to_light.template at<T>(i), normal.template at<T>(i), to_eye.template at<T>(i), Rgb<T>(T(1)), nullptr};
  }
};

template <class T, class Light>
void add_light(const std::string& name, const Light& light) {
  add(name, few, [light, fragments = Fragments<RealOf<T>>()] {
    for_each_packet_of<T>(few, [&](std::size_t i) { return arriving(light, fragments.template at<T>(i)); });
  });
}

template <class T, class M>
void add_fragment_function(const std::string& number, M function) {
  if constexpr (requires { function.table; }) function.table = synthetic_table();
  if constexpr (requires { function.glossiness; }) function.glossiness = 32;
  add("fragment/" + std::string(M::name) + "/" + number, few, [function, fragments = Fragments<RealOf<T>>()] {
    for_each_packet_of<T>(few, [&](std::size_t i) {
      return reflected(function, fragments.template at<T>(i),
                       Incident<T>{fragments.to_light.template at<T>(i), Rgb<T>(as<T>(0.8))});
    });
  });
}

template <class T, class... Functions>
void add_fragment_functions(const std::string& number, const std::variant<Functions...>*) {
  (add_fragment_function<T>(number, Functions{}), ...);
}

} // namespace

void add_fragment_functions() {
  for_each_number([]<class T>(const std::string& number) {
    add_light<T>("light/point/" + number, PointLight{{1.5, 2, 2.5}, Double3(1), 1, 0.09, 0.032});
    add_light<T>("light/direction/" + number, DirectionLight{{-1, -1, -1}, Double3(1)});
    add_fragment_functions<T>(number, static_cast<const FragmentFunction*>(nullptr));
  });
}

} // namespace refraster::micro
