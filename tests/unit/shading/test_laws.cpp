// Laws that every fragment function keeps, over every number.

#include "math/bounds/interval_functions.h"
#include "tests/unit/shading/laws.h"

#include <doctest/doctest.h>

#include <set>

using namespace refraster;

namespace {

using Bounds = Interval<DoubleArithmetic>;

constexpr int trials = 200;

template <class T>
Rgb<T> shaded(const FragmentFunction& function, const Situation& situation) {
  const auto at = situation.fragment<T>();
  const auto light = situation.incident<T>();
  return std::visit([&](const auto& m) { return ambient(m, at) + reflected(m, at, light); }, function);
}

template <class F>
bool same_bits(F a, F b) {
  return std::bit_cast<BitsOf<F>>(a) == std::bit_cast<BitsOf<F>>(b);
}

/// For one of `apart` situations: a box in which the azimuth is anything reads whole rows of a measured table.
void check_boxes(int apart) {
  const double half_width = 1e-5;
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(4);
    for (int k = 0; k < trials; k += apart) {
      const Situation situation = random_situation(random, k);
      auto at = situation.fragment<Bounds>();
      const auto light = situation.incident<Bounds>();
      for (int axis = 0; axis < 3; ++axis) {
        at.normal[axis] = {situation.n[axis] - half_width, situation.n[axis] + half_width};
        at.to_eye[axis] = {situation.v[axis] - half_width, situation.v[axis] + half_width};
      }
      const Rgb<Bounds> bounds =
          std::visit([&](const auto& m) { return ambient(m, at) + reflected(m, at, light); }, tried.function);
      for (int inside = 0; inside < 4; ++inside) {
        Situation moved = situation;
        for (int axis = 0; axis < 3; ++axis) {
          moved.n[axis] += uniform(random, -half_width, half_width);
          moved.v[axis] += uniform(random, -half_width, half_width);
        }
        const Rgb<double> point = shaded<double>(tried.function, moved);
        REQUIRE(bounds.x.contains(point.x));
        REQUIRE(bounds.y.contains(point.y));
        REQUIRE(bounds.z.contains(point.z));
      }
    }
  }
}

} // namespace

TEST_CASE("the laws are tried on every fragment function") {
  std::set<std::size_t> kinds;
  for (const NamedFunction& tried : all_fragment_functions()) kinds.insert(tried.function.index());
  CHECK(kinds.size() == std::variant_size_v<FragmentFunction>);
}

TEST_CASE_TEMPLATE("light toward the eye is finite and not negative, whatever the geometry", F, double, float) {
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(1);
    for (int k = 0; k < trials; ++k) {
      const Rgb<F> colour = shaded<F>(tried.function, random_situation(random, k));
      for (int channel = 0; channel < 3; ++channel) REQUIRE((colour[channel] >= 0 && std::isfinite(colour[channel])));
    }
  }
}

TEST_CASE_TEMPLATE("every lane shades as it would alone, to the last bit", T, Wide<float, 4>, Wide<float, 16>,
                   Wide<double, 2>, Wide<double, 8>) {
  using F = RealOf<T>;
  constexpr int lanes = NumberTraits<T>::lanes;
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(2);
    for (int k = 0; k < trials; k += lanes) {
      std::array<Situation, lanes> situations;
      Fragment<T> at;
      Incident<T> light;
      at.position = Vec3<T>(T(0));
      for (int lane = 0; lane < lanes; ++lane) {
        const Situation& s = situations[static_cast<std::size_t>(lane)] = random_situation(random, k + lane);
        const auto put = [lane](Vec3<T>& to, const Double3& from) {
          to.x.set(lane, static_cast<F>(from.x));
          to.y.set(lane, static_cast<F>(from.y));
          to.z.set(lane, static_cast<F>(from.z));
        };
        put(at.normal, s.n), put(at.to_eye, s.v), put(at.texture, s.texture);
        put(light.direction, s.l), put(light.radiance, s.radiance);
      }
      const Rgb<T> together =
          std::visit([&](const auto& m) { return ambient(m, at) + reflected(m, at, light); }, tried.function);
      for (int lane = 0; lane < lanes; ++lane) {
        const Rgb<F> alone = shaded<F>(tried.function, situations[static_cast<std::size_t>(lane)]);
        REQUIRE(same_bits(together.x[lane], alone.x));
        REQUIRE(same_bits(together.y[lane], alone.y));
        REQUIRE(same_bits(together.z[lane], alone.z));
      }
    }
  }
}

TEST_CASE("bounds on a point contain what double makes of it") {
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(3);
    for (int k = 0; k < trials; ++k) {
      const Situation situation = random_situation(random, k);
      const Rgb<double> point = shaded<double>(tried.function, situation);
      const Rgb<Bounds> bounds = shaded<Bounds>(tried.function, situation);
      REQUIRE(bounds.x.contains(point.x));
      REQUIRE(bounds.y.contains(point.y));
      REQUIRE(bounds.z.contains(point.z));
    }
  }
}

TEST_CASE("bounds on a box contain what double makes of points in it") {
  check_boxes(100);
}

TEST_SUITE("long") {
  TEST_CASE("so they do of many boxes") {
    check_boxes(10);
  }
}

TEST_CASE("a dark light adds nothing") {
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(5);
    for (int k = 0; k < trials; ++k) {
      Situation situation = random_situation(random, k);
      situation.radiance = Double3(0);
      const auto at = situation.fragment<double>();
      const Rgb<double> unlit = std::visit([&](const auto& m) { return ambient(m, at); }, tried.function);
      REQUIRE(shaded<double>(tried.function, situation) == unlit);
    }
  }
}

TEST_CASE("no diffuse or measured light comes from below the horizon") {
  for (const NamedFunction& tried : all_fragment_functions()) {
    const bool highlight = std::visit(
        [](const auto& function) {
          if constexpr (requires { function.specular_gate; })
            return function.specular_gate == SpecularGate::open && function.ks != Double3(0);
          return false;
        },
        tried.function);
    if (highlight) continue; // the textbook's highlight goes round the horizon
    CAPTURE(tried.name);
    std::mt19937_64 random(6);
    for (int k = 0; k < trials; ++k) {
      Situation situation = random_situation(random, k);
      if (dot(situation.n, situation.l) > 0) situation.l = -situation.l;
      const auto at = situation.fragment<double>();
      const auto light = situation.incident<double>();
      REQUIRE(std::visit([&](const auto& m) { return reflected(m, at, light); }, tried.function) == Rgb<double>(0));
    }
  }
}
