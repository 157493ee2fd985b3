#include "app/sanitizer.h"
#include "bench/machine/memory.h"
#include "bench/measure/scaling.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace refraster;
using namespace refraster::bench;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Points at 1, 10, 100 … with these times.
ScalingCurve curve_of(const std::vector<double>& times_ms, Growth growth = Growth::lights) {
  ScalingCurve curve;
  curve.growth = growth;
  double n = 1;
  for (const double ms : times_ms) {
    MeasuredPoint& point = curve.points.emplace_back();
    point.point.n = n;
    point.frame_ms = spread_of({ms});
    n *= 10;
  }
  return curve;
}

std::vector<double> numbers(Growth growth, double most) {
  std::vector<double> ns;
  for (const ScalingPoint& point : scaling_points(growth, most, {}, 1, 4)) ns.push_back(point.n);
  return ns;
}

std::size_t triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Object& object : scene.objects) count += object.mesh->triangles.size();
  return count;
}

ScalingTask small_task(Growth growth, double most) {
  return {.growth = growth, .most = most, .size = {96, 54}, .precisions = {"double", "float"}};
}

std::vector<ScalingCurve> quickly(const ScalingTask& task) {
  const PinnedThreadPool thread_pool;
  return measure_scaling(task, {.least = 2, .seconds = 0}, thread_pool);
}

} // namespace

TEST_CASE("what grows linearly, or slower, grows no faster than linearly; what grows with a higher power does") {
  CHECK(*curve_of({5, 5, 50, 500, 5000}).no_faster_than_linear());
  CHECK(*curve_of({100, 101, 110, 200, 1100}).no_faster_than_linear());
  CHECK_FALSE(*curve_of({1, 20, 400, 8000, 160000}).no_faster_than_linear()); // n^1.3
  // Steep only where it does not count yet: the lower half takes no part; but it is reported.
  const ScalingCurve late = curve_of({1, 100, 1000, 10000, 100000});
  CHECK(*late.no_faster_than_linear());
  CHECK(late.steepest()->slope == doctest::Approx(2));
  CHECK(late.steepest()->from == 1);
}

TEST_CASE("a few points, or threads, say nothing about linear growth") {
  CHECK_FALSE(curve_of({1}).slope());
  CHECK_FALSE(curve_of({1}).steepest());
  CHECK_FALSE(curve_of({1, 2}).no_faster_than_linear());
  CHECK_FALSE(curve_of({4, 3, 2}, Growth::threads).no_faster_than_linear());
}

TEST_CASE("curves reach as far as is promised, and stop where they are told to") {
  const std::vector<double> counts = numbers(Growth::triangles, no_limit);
  CHECK(counts.front() == doctest::Approx(1e3).epsilon(0.05));
  CHECK(counts.back() == doctest::Approx(1e7).epsilon(0.05));
  CHECK(numbers(Growth::pixels, no_limit).front() == 1e4);
  CHECK(numbers(Growth::pixels, no_limit).back() == 16384.0 * 16384.0);
  CHECK(numbers(Growth::lights, no_limit).back() == 256);
  CHECK(numbers(Growth::overdraw, no_limit).back() == 64);
  CHECK(numbers(Growth::threads, no_limit) == std::vector<double>{1, 2, 3, 4});
  CHECK(numbers(Growth::lights, 5) == std::vector<double>{1, 2, 4});
  for (const auto& [growth, name] : growth_names) CHECK(numbers(growth, 1).size() == 1);
}

TEST_CASE("scenes have as many triangles, lights and layers as their point says") {
  for (const ScalingPoint& point : scaling_points(Growth::triangles, 1e5, {}, 1, 1))
    CHECK(static_cast<double>(triangles(scaling_scene(Growth::triangles, point))) == point.n);
  for (const ScalingPoint& point : scaling_points(Growth::lights, 16, {}, 1, 1))
    CHECK(static_cast<double>(scaling_scene(Growth::lights, point).point_lights.size()) == point.n);
  ScalingPoint layers{.n = 3, .width = 96, .height = 54};
  const Scene back_to_front = scaling_scene(Growth::overdraw, layers);
  layers.order = LayerOrder::front_to_back;
  const Scene front_to_back = scaling_scene(Growth::overdraw, layers);
  REQUIRE(back_to_front.objects.size() == 3);
  CHECK(back_to_front.objects.front().position.z < back_to_front.objects.back().position.z);
  CHECK(front_to_back.objects.front().position == back_to_front.objects.back().position);
}

TEST_CASE("each image is full: every pixel is shaded once, however many triangles, layers, lights and threads") {
  for (const auto& named : growth_names) {
    const Growth growth = named.first;
    CAPTURE(named.second);
    const std::vector<ScalingCurve> curves = quickly(small_task(growth, growth == Growth::pixels ? 4e4 : 2e4));
    REQUIRE(curves.size() == 2);
    for (const ScalingCurve& curve : curves) {
      CHECK(curve.precision == (&curve == &curves[0] ? "double" : "float"));
      CHECK((growth == Growth::pixels || curve.same_fragments()));
      for (const MeasuredPoint& point : curve.points) {
        CHECK(point.frames == 2);
        CHECK(point.frame_ms.min > 0);
        CHECK(point.counts.fragments == static_cast<std::uint64_t>(point.point.width * point.point.height));
      }
    }
  }
}

TEST_CASE("the peak of memory is that since it was last asked to count anew" * doctest::skip(built_with_sanitizer)) {
  restart_peak_memory();
  const auto before = peak_memory_bytes();
  if (!before) {
    MESSAGE("this kernel does not let the peak be counted anew");
    return;
  }
  constexpr std::size_t bytes = 64 << 20;
  {
    std::vector<char> much(bytes);
    volatile char* const pages = much.data(); // else clang leaves the memory out, of which nothing is read
    for (std::size_t i = 0; i < bytes; i += 4096) pages[i] = 1;
  }
  CHECK(*peak_memory_bytes() > *before + bytes / 2); // some pages may have been there before
  restart_peak_memory();
  CHECK(*peak_memory_bytes() < *before + bytes / 2);
}
