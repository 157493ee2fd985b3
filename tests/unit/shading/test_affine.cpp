// Fragment functions on affine bounds: an adversary looks for what lies outside, and says how wide they are beside what
// it reached.

#include "tests/unit/shading/adversary.h"

#include <cstdlib>

#include <doctest/doctest.h>

using namespace refraster;

namespace {

using Bounds = Affine<FloatArithmetic>;

struct Tightness {
  double median, most; // at 95 %
};

/// How wide bounds may be beside what the adversary reached, in the middle and at 95 % of the places. A spline between
/// logarithms is wide in the very middle of a highlight, where all its azimuths are read.
Tightness allowed(const std::string& name) {
  return {1.3, name.find("tricubic") == std::string::npos ? 2.5 : 5};
}

void check(int places, int evaluations) {
  long all = 0;
  for (const NamedFunction& tried : tried_functions()) {
    CAPTURE(tried.name);
    const Found found = search<FloatArithmetic>(tried.function, 0, places, evaluations, 1e-4);
    CHECK(found.outside == 0);
    CHECK(rank(found.ratio, 0.5) <= allowed(tried.name).median);
    CHECK(rank(found.ratio, 0.95) <= allowed(tried.name).most);
    CHECK(rank(found.of_intervals, 0.95) >= 2 * rank(found.ratio, 0.95));
    all += found.evaluations;
    if (std::getenv("REFRASTER_PRINT"))
      MESSAGE(tried.name << ": ratio " << rank(found.ratio, 0.5) << " / " << rank(found.ratio, 0.95) << " / "
                         << rank(found.ratio, 1) << ", of intervals " << rank(found.of_intervals, 0.5) << " / "
                         << rank(found.of_intervals, 0.95));
  }
  if (std::getenv("REFRASTER_PRINT")) MESSAGE(all << " evaluations");
}

/// In the situations where something is undefined or extreme, and in small boxes around them; but those where
/// directions are anything, so that all of a measured table is read.
template <class Budget>
void check_situations(double half_width, int situations) {
  using T = Affine<Budget>;
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(7);
    for (int k = 0; k < situations; ++k) {
      const Situation situation = random_situation(random, k);
      const bool reads_all = min(length(situation.l + situation.v), length(situation.n)) < 1e-3 ||
                             min(length(situation.l), length(situation.v)) < 1e-3;
      if (half_width > 0 && reads_all && std::holds_alternative<Merl>(tried.function)) continue;
      auto at = situation.fragment<T>();
      for (int axis = 0; axis < 3; ++axis) {
        const double n = situation.n[axis], v = situation.v[axis],
                     more = half_width > 0 ? half_width * (1 + 0x1p-20) + 0x1p-24 : 0;
        at.normal[axis] = T(n - more, n + more).named(static_cast<int>(Symbol::normal) + axis);
        at.to_eye[axis] = T(v - more, v + more).named(static_cast<int>(Symbol::position) + axis);
      }
      const auto shade = [&](const auto& fragment, const auto& light) {
        return std::visit([&](const auto& f) { return ambient(f, fragment) + reflected(f, fragment, light); },
                          tried.function);
      };
      const Rgb<T> bounds = shade(at, situation.incident<T>());
      for (int inside = 0; inside < 4; ++inside) {
        Situation moved = situation;
        for (int axis = 0; axis < 3; ++axis) {
          moved.n[axis] += uniform(random, -half_width, half_width);
          moved.v[axis] += uniform(random, -half_width, half_width);
        }
        const Rgb<double> point = shade(moved.fragment<double>(), moved.incident<double>());
        for (int c = 0; c < 3; ++c) REQUIRE(bounds[c].contains(point[c]));
        if constexpr (std::same_as<Budget, FloatArithmetic>) {
          const Rgb<float> single = shade(moved.fragment<float>(), moved.incident<float>());
          for (int c = 0; c < 3; ++c) REQUIRE(bounds[c].contains(static_cast<double>(single[c])));
        }
      }
    }
  }
}

} // namespace

TEST_CASE("affine bounds hold where something is undefined or extreme") {
  check_situations<DoubleArithmetic>(0, 50);
  check_situations<FloatArithmetic>(1e-5, 10);
}

TEST_CASE("no device within the budget leaves the bounds of a fragment function, and they are tight") {
  check(20, 300); // 126,000 evaluations
  const double width = Bounds::anything().width();
  CHECK_FALSE(width / 1e30 <= allowed("").most);
}

TEST_SUITE("slow") {
  TEST_CASE("so it is with many more places and evaluations") {
    check(20, 1200); // half a million
  }

  TEST_CASE("so do they in many more situations") {
    check_situations<DoubleArithmetic>(1e-5, 20);
    check_situations<FloatArithmetic>(1e-5, 20);
  }
}

TEST_SUITE("long") {
  TEST_CASE("so do they in a hundred of each kind") {
    check_situations<DoubleArithmetic>(1e-5, 100);
    check_situations<FloatArithmetic>(1e-5, 100);
  }

  TEST_CASE("so it is with ten million evaluations") {
    check(160, 3000);
  }
}
