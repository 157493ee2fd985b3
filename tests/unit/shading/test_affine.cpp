// Fragment functions on affine bounds: an adversary looks for what lies outside, and says how wide they are beside what
// it reached.

#include "math/bounds/affine_functions.h"
#include "shading/light.h"
#include "tests/support/affine_cases.h"
#include "tests/support/perturbed.h"
#include "tests/unit/shading/laws.h"

#include <algorithm>
#include <cstdlib>

#include <doctest/doctest.h>

using namespace refraster;

namespace {

using Bounds = Affine<FloatArithmetic>;
using Device = Perturbed<FloatArithmetic>;

/// A fragment as rasterization leaves it: position and normal move with the sample, and each component was rounded.
struct Place {
  std::array<Linear, 3> position, normal; // the normal of any length
  Double3 eye, texture;
  PointLight light;
};

/// Symbols 0 and 1 are the sample's shift; each component has one of its own.
Place some_place(std::mt19937_64& random, double shift) {
  Place place;
  SurfacePair at = random() % 4 ? random_pair(random) : specular_pair(random);
  if (random() % 8 == 0) at.o = mirrored(at.i, at.n);
  const Double3 p(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2));
  const double size = uniform(random, 0.5, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto c = static_cast<int>(i);
    place.position[i].centre = p[c], place.normal[i].centre = at.n[c] * size;
    for (std::size_t k = 0; k < 2; ++k) {
      place.position[i].slope[k] = uniform(random, -shift, shift);
      place.normal[i].slope[k] = uniform(random, -shift, shift);
    }
    constexpr double rounding = 16 * 0x1p-24;
    place.position[i].slope[static_cast<std::size_t>(Symbol::position) + i] = rounding * 2;
    place.normal[i].slope[static_cast<std::size_t>(Symbol::normal) + i] = rounding * size;
  }
  place.eye = p + at.o * uniform(random, 1, 10);
  place.light.position = p + at.i * uniform(random, 1, 10);
  place.light.radiance = Double3(uniform(random, 0.5, 4), 1, 2);
  if (random() % 2) place.light.constant = 0.5, place.light.linear = 0.25, place.light.quadratic = 0.125;
  place.texture = Double3(uniform(random, 0, 1), 0.5, 1);
  return place;
}

template <class T, class Function>
Rgb<T> shaded(const Function& function, const Place& place, const Vec3<T>& position, const Vec3<T>& normal) {
  Fragment<T> at{position, normalize(normal), normalize(as<T>(place.eye) - position), as<T>(place.texture), nullptr};
  return ambient(function, at) + reflected(function, at, arriving(place.light, at));
}

template <class Number>
Vec3<Number> bounds_of(const std::array<Linear, 3>& line) {
  const auto component = [&](std::size_t i) -> Number {
    const auto bounds = line[i].bounds<FloatArithmetic>();
    if constexpr (std::same_as<Number, Bounds>) return bounds;
    else return bounds.range();
  };
  return {component(0), component(1), component(2)};
}
template <class T>
Vec3<T> point_of(const std::array<Linear, 3>& line, const Symbols& e) {
  const auto component = [&](std::size_t i) { return T(static_cast<RealOf<T>>(line[i].at(e))); };
  return {component(0), component(1), component(2)};
}

struct Spread {
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;
  void add(double x) { lo = std::min(lo, x), hi = std::max(hi, x); }
};

/// Climbs to the least and the greatest value of one channel: steps in the symbols that shrink where they do not help,
/// and other signs of the roundings.
template <class Value>
Spread searched(Random& random, int evaluations, const Value& value) {
  Spread spread;
  for (const double sign : {1.0, -1.0}) {
    Symbols best = some_symbols(random);
    std::uint64_t best_flips = random.bits();
    double highest = sign * value(best, best_flips), step = 1;
    spread.add(sign * highest);
    for (int i = 1; i < evaluations / 2; ++i) {
      Symbols e = best;
      std::uint64_t flips = best_flips;
      if (random.below(3) == 0) flips = random.bits();
      else
        for (double& x : e)
          if (random.below(3) == 0) x = std::clamp(x + step * random.uniform(-2, 2), -1.0, 1.0);
      const double found = value(e, flips);
      spread.add(found);
      if (sign * found > highest) highest = sign * found, best = e, best_flips = flips, step = std::min(1.0, 2 * step);
      else step = std::max(step * 0.9, 1e-3);
    }
  }
  return spread;
}

/// The value that so much of all are below.
double rank(std::vector<double> values, double at) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(at * static_cast<double>(values.size() - 1))];
}

struct Tightness {
  double median, most; // at 95 %
};

struct Found {
  std::vector<double> ratio, of_intervals;
  long evaluations = 0, outside = 0;
};

/// Of so many places of one function: 2/3 of the evaluations on the worst device, the others in double and in float.
Found search(const FragmentFunction& function, int places, int evaluations, double shift) {
  Found found;
  for (int k = 0; k < places; ++k) {
    std::mt19937_64 random(static_cast<std::uint64_t>(k));
    const Place place = some_place(random, shift);
    Random adversary(static_cast<std::uint64_t>(k));
    std::visit(
        [&](const auto& f) {
          const Rgb<Bounds> bounds =
              shaded<Bounds>(f, place, bounds_of<Bounds>(place.position), bounds_of<Bounds>(place.normal));
          using Range = Interval<FloatArithmetic>;
          const Rgb<Range> range =
              shaded<Range>(f, place, bounds_of<Range>(place.position), bounds_of<Range>(place.normal));
          const auto value = [&](const Symbols& e, std::uint64_t flips) {
            const auto in = [&]<class T>(T) {
              return static_cast<double>(
                  shaded<T>(f, place, point_of<T>(place.position, e), point_of<T>(place.normal, e)).x);
            };
            ++found.evaluations;
            Device::flips() = Random(flips);
            const double result = flips % 6 == 0 ? in(0.0) : flips % 6 == 1 ? in(0.0f) : in(Device(0));
            found.outside += !bounds.x.contains(result);
            return result;
          };
          const Spread spread = searched(adversary, evaluations, value);
          found.outside += bounds.x.lo < range.x.lo || bounds.x.hi > range.x.hi;
          if (spread.hi > spread.lo) {
            found.ratio.push_back(bounds.x.width() / (spread.hi - spread.lo));
            found.of_intervals.push_back(range.x.width() / (spread.hi - spread.lo));
          }
        },
        function);
  }
  return found;
}

std::vector<NamedFunction> tried_functions() {
  std::vector<NamedFunction> list;
  for (const double glossiness : {8.0, 128.0, 1e6}) {
    const PhongParameters parameters{{0.1, 0.2, 0}, {0.5, 0.3, 0.7}, {0.4, 0, 1}, glossiness, SpecularGate::open};
    list.push_back({"phong " + std::to_string(glossiness), Phong{parameters}});
    list.push_back({"blinn_phong " + std::to_string(glossiness), BlinnPhong{parameters}});
  }
  for (const NamedFunction& f : all_fragment_functions())
    if (std::holds_alternative<Merl>(f.function)) list.push_back(f);
  return list;
}

/// How wide bounds may be beside what the adversary reached, in the middle and at 95 % of the places. A spline between
/// logarithms is wide in the very middle of a highlight, where all its azimuths are read.
Tightness allowed(const std::string& name) {
  return {1.3, name.find("tricubic") == std::string::npos ? 2.5 : 5};
}

void check(int places, int evaluations) {
  long all = 0;
  for (const NamedFunction& tried : tried_functions()) {
    CAPTURE(tried.name);
    const Found found = search(tried.function, places, evaluations, 1e-4);
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
    check(160, 3000); // ten million
  }

  TEST_CASE("so do they in many more situations") {
    check_situations<DoubleArithmetic>(1e-5, 100);
    check_situations<FloatArithmetic>(1e-5, 100);
  }
}
