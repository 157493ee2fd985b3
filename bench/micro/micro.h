#pragma once
// What the microbenchmarks share: the numbers that are measured, and loops over arrays of them.

#include "math/precisions.h"
#include "math/vec.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace refraster::micro {

// One for each file: each registers its benchmarks.
void add_elementary();
void add_fragment_functions();
void add_measured_brdf();
void add_textures();
void add_triangles();

/// body.operator()<T>(name) for one number of each precision, and for its lanes.
template <class Body>
void for_each_number(Body&& body) {
  body.template operator()<double>("double x1");
  body.template operator()<float>("float x1");
  const auto precision = [&]<class R>(R) {
    using T = typename R::Number;
    body.template operator()<T>(std::string(R::name) + " x" + std::to_string(NumberTraits<T>::lanes));
  };
  std::apply([&](auto... each) { (precision(each), ...); }, LanePrecisions{});
}

/// Benchmark `name`: work() does `values` of something.
template <class Work>
void add(const std::string& name, std::size_t values, Work work) {
  benchmark::RegisterBenchmark(name.c_str(), [work = std::move(work), values](benchmark::State& state) {
    work(); // what is made once, when it is first asked for
    for (auto _ : state) work();
    state.counters["each"] = benchmark::Counter(
        static_cast<double>(values), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  });
}

template <class T>
T loaded(const RealOf<T>* from) {
  static_assert(sizeof(T) == sizeof(RealOf<T>) * NumberTraits<T>::lanes);
  T x;
  std::memcpy(static_cast<void*>(&x), from, sizeof x);
  return x;
}

/// As many values as fit the first level of cache a few times over; a multiple of all numbers of lanes.
inline constexpr std::size_t few = 1024;
/// As many as a small image has pixels.
inline constexpr std::size_t many = 65536;

template <class F>
using Values = std::vector<F>;

/// Uniform in [low, high).
template <class F>
Values<F> random_values(std::size_t count, double low, double high, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> distribution(low, high);
  Values<F> values(count);
  for (F& x : values) x = static_cast<F>(distribution(random));
  return values;
}

/// Vectors, a component after the other.
template <class F>
struct Vectors {
  Values<F> x, y, z;

  explicit Vectors(std::size_t count = 0) : x(count), y(count), z(count) {}
  void set(std::size_t i, const Double3& a) {
    x[i] = static_cast<F>(a.x), y[i] = static_cast<F>(a.y), z[i] = static_cast<F>(a.z);
  }
  template <class T>
  Vec3<T> at(std::size_t i) const {
    return {loaded<T>(&x[i]), loaded<T>(&y[i]), loaded<T>(&z[i])};
  }
};

/// f(i) for the first value i of each T in [0, count). All that f calls is inlined, as it is in the renderer.
template <class T, class Function>
[[gnu::flatten, gnu::noinline]] void for_each_packet_of(std::size_t count, const Function& f) {
  for (std::size_t i = 0; i < count; i += NumberTraits<T>::lanes) {
    auto result = f(i);
    benchmark::DoNotOptimize(result);
  }
}

} // namespace refraster::micro
