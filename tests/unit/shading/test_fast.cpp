// What the precision fast gives up: as much as shading/precision_bounds.h says, and nothing of what must be finite.

#include "shading/precision_bounds.h"
#include "tests/support/shading/merl_tables.h"
#include "tests/unit/shading/laws.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace refraster;

namespace {

using Fast = FastPrecision::Number;
constexpr int lanes = NumberTraits<Fast>::lanes;

template <class T, class M>
Rgb<T> shaded(const M& function, const Situation& s) {
  const auto at = s.fragment<T>();
  return ambient(function, at) + reflected(function, at, s.incident<T>());
}

/// Both see the same numbers: directions as a float holds them.
Double3 as_float_has_it(const Double3& v) {
  return Double3(Float3(v));
}

/// A light of radiance 1 at ordinary directions, and every other time near a highlight.
Situation ordinary(std::mt19937_64& random, int k) {
  const SurfacePair at = k % 2 == 0 ? random_pair(random) : specular_pair(random);
  return {as_float_has_it(at.n), as_float_has_it(at.i), as_float_has_it(at.o), Double3(1), Double3(1)};
}

/// Differences from double, of the radiance where that is above 1, sorted.
template <class MakeFunction>
std::vector<double> differences(const MakeFunction& function_for, int trials) {
  std::mt19937_64 random(11);
  std::vector<double> all;
  for (int k = 0; k < trials; ++k) {
    const auto function = function_for(random);
    const Situation s = ordinary(random, k);
    const double fast = static_cast<double>(shaded<Fast>(function, s).x[k % lanes]),
                 exact = shaded<double>(function, s).x;
    all.push_back(std::abs(fast - exact) / std::max(1.0, exact));
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <class MakeFunction>
void check_bound(std::string_view name, const MakeFunction& function_for, int trials = 40000) {
  const auto bound = std::find_if(std::begin(fast_bounds), std::end(fast_bounds),
                                  [&](const FastBound& b) { return b.function == name; });
  REQUIRE(bound != std::end(fast_bounds));
  const std::vector<double> all = differences(function_for, trials);
  const double most = all.back(), p99 = all[all.size() / 100 * 99];
  if (std::getenv("REFRASTER_PRINT_BOUNDS")) MESSAGE(name, " ", most, " ", p99);
  CAPTURE(name);
  CHECK(most <= bound->max);
  CHECK(p99 <= bound->p99);
}

PhongParameters some_parameters(std::mt19937_64& random) {
  return {Double3(0.1), Double3(0.6), Double3(0.7), random_scale(random, 0, 3), SpecularGate::open};
}

} // namespace

TEST_CASE("fast is as near to double as promised") {
  check_bound("phong", [](std::mt19937_64& random) { return Phong{some_parameters(random)}; });
  check_bound("blinn_phong", [](std::mt19937_64& random) { return BlinnPhong{some_parameters(random)}; });
  check_bound("microfacet", [](std::mt19937_64& random) {
    Microfacet function;
    function.base_color = {uniform(random, 0, 1), 0.5, 0.5}, function.metallic = uniform(random, 0, 1);
    function.roughness = uniform(random, 0.2, 1);
    return function;
  });
  const std::shared_ptr<const MerlTable> table(new MerlTable(merl_table_from(find_brdf_preset("nylon-like")->brdf)));
  for (const MerlLookup lookup : {MerlLookup::trilinear, MerlLookup::trilinear_log, MerlLookup::tricubic_log})
    check_bound("merl " + std::string(name_of(lookup)), [&](std::mt19937_64&) {
      return Merl{table, lookup, MerlAngles::closed};
    });
}

TEST_CASE("fast is finite and not negative, whatever the geometry") {
  for (const NamedFunction& tried : all_fragment_functions()) {
    CAPTURE(tried.name);
    std::mt19937_64 random(12);
    for (int k = 0; k < 200; ++k) {
      const Situation s = random_situation(random, k);
      const Rgb<Fast> colour = std::visit([&](const auto& m) { return shaded<Fast>(m, s); }, tried.function);
      for (int channel = 0; channel < 3; ++channel)
        REQUIRE((colour[channel][k % lanes] >= 0 && std::isfinite(colour[channel][k % lanes])));
    }
  }
}

TEST_CASE("fast keeps what is exact: zero, one, and what does not change") {
  const Fast one(1), zero(0);
  CHECK(refraster::pow(zero, 3)[0] == 0);
  CHECK(refraster::pow(one, 1000)[0] == 1);
  CHECK(atan2(zero, one)[0] == 0);
  CHECK(exp2(zero)[0] == 1);
  CHECK(log2(one)[0] == 0);
  const Vec3<Fast> nothing = normalize(Vec3<Fast>(zero, zero, zero));
  CHECK(nothing.x[0] == 0);
  const Vec3<Fast> huge = normalize(Vec3<Fast>(Fast(3e37f), zero, Fast(4e37f)));
  CHECK(std::abs(huge.x[0] - 0.6f) <= 1e-6f * 0.6f);
  // A table cell of one value has that value everywhere in it.
  CHECK(mix(Vec3<Fast>(one, one, one), Vec3<Fast>(one, one, one), Fast(0.3f)).x[0] == 1);
}
