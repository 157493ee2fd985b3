// Elementary functions, over arguments as shading has them.

#include "math/elementary.h"
#include "bench/micro/micro.h"

namespace refraster::micro {
namespace {

template <class T, class Function>
void add_function(const std::string& name, double low, double high, const Function& f) {
  add(name, few, [f, x = random_values<RealOf<T>>(few, low, high, 1), y = random_values<RealOf<T>>(few, low, high, 2)] {
    for_each_packet_of<T>(few, [&](std::size_t i) { return f(loaded<T>(&x[i]), loaded<T>(&y[i])); });
  });
}

template <class F>
Vectors<F> unit_vectors(std::uint64_t seed) {
  const auto x = random_values<double>(few, -1, 1, seed), y = random_values<double>(few, -1, 1, seed + 1);
  Vectors<F> vectors(few);
  for (std::size_t i = 0; i < few; ++i) vectors.set(i, normalize(Double3(x[i], y[i], 1)));
  return vectors;
}

} // namespace

void add_elementary() {
  for_each_number([]<class T>(const std::string& number) {
    const auto named = [&](const char* function) { return std::string(function) + "/" + number; };
    add_function<T>(named("divide"), 0.5, 2, [](const T& x, const T& y) { return x / y; });
    add_function<T>(named("sqrt"), 0.5, 2, [](const T& x, const T&) { return sqrt(x); });
    add_function<T>(named("log2"), 1e-3, 1, [](const T& x, const T&) { return log2(x); });
    add_function<T>(named("exp2"), -30, 0, [](const T& x, const T&) { return exp2(x); });
    add_function<T>(named("pow"), 1e-3, 1, [](const T& x, const T&) { return pow(x, 32.0); });
    add_function<T>(named("atan2"), -1, 1, [](const T& y, const T& x) { return atan2(y, x); });
    add(named("normalize"), few, [a = unit_vectors<RealOf<T>>(1)] {
      for_each_packet_of<T>(few, [&](std::size_t i) { return normalize(a.template at<T>(i)); });
    });
    add(named("cosine_power"), few, [a = unit_vectors<RealOf<T>>(1), b = unit_vectors<RealOf<T>>(3)] {
      for_each_packet_of<T>(
          few, [&](std::size_t i) { return cosine_power(a.template at<T>(i), b.template at<T>(i), 32.0); });
    });
  });
}

} // namespace refraster::micro
