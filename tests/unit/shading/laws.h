#pragma once
// What holds for every fragment function and every number: the tests go through these closed lists.

#include "math/precisions.h"
#include "scenes/synthesis/merl_synthesis.h"
#include "shading/fragment_functions.h"
#include "tests/support/shading/directions.h"

#include <memory>
#include <string>
#include <vector>

namespace refraster {

struct NamedFunction {
  std::string name;
  FragmentFunction function;
};

/// At least one of every fragment function, with each of its conventions.
inline const std::vector<NamedFunction>& all_fragment_functions() {
  static const std::vector<NamedFunction> functions = [] {
    std::vector<NamedFunction> list;
    for (const SpecularGate gate : {SpecularGate::open, SpecularGate::cut_below_horizon})
      for (const double glossiness : {0.0, 1.0, 8.0, 1e6}) {
        const std::string name = " gate " + std::string(name_of(gate)) + " glossiness " + std::to_string(glossiness);
        const PhongParameters parameters{{0.1, 0.2, 0}, {0.5, 0.3, 0.7}, {0.4, 0, 1}, glossiness, gate};
        list.push_back({"phong" + name, Phong{parameters}});
        list.push_back({"blinn_phong" + name, BlinnPhong{parameters}});
      }
    list.push_back({"phong, no highlight", Phong{{{0, 0, 0}, {1, 1, 1}, {0, 0, 0}, 8, SpecularGate::open}}});
    for (const auto& [fresnel, fresnel_name] : EnumNames<MicrofacetFresnel>::names)
      for (const double roughness : {1e-3, 0.3, 1.0}) {
        if (fresnel != MicrofacetFresnel::schlick && roughness != 0.3) continue; // how rough is nothing to these
        Microfacet function;
        function.base_color = {0.9, 0.5, 0}, function.metallic = 0.6;
        function.roughness = roughness, function.fresnel = fresnel;
        list.push_back({"microfacet " + std::string(fresnel_name) + " " + std::to_string(roughness), function});
      }
    const std::shared_ptr<const MerlTable> table(new MerlTable(merl_table_from(GgxConductor{0.1, {0.91, 0.78, 0.42}})));
    for (const auto& [lookup, lookup_name] : EnumNames<MerlLookup>::names)
      for (const auto& [angles, angles_name] : EnumNames<MerlAngles>::names)
        list.push_back(
            {"merl " + std::string(lookup_name) + " " + std::string(angles_name), Merl{table, lookup, angles}});
    return list;
  }();
  return functions;
}

/// What a fragment function is given, in double.
struct Situation {
  Double3 n, l, v, texture, radiance;

  template <class T>
  Fragment<T> fragment() const {
    return {Vec3<T>(T(0)), as<T>(n), as<T>(v), as<T>(texture), nullptr};
  }
  template <class T>
  Incident<T> incident() const {
    return {as<T>(l), as<T>(radiance)};
  }
};

/// Ordinary ones, and among every ten one of each of those where something is undefined or extreme.
inline Situation random_situation(std::mt19937_64& random, int k) {
  const auto colour = [&] { return Double3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)); };
  SurfacePair at = random_pair(random);
  switch (k % 10) {
  case 0:
    at.o = -at.i;
    break; // no half vector
  case 1:
    at.o = at.i;
    break; // light behind the eye
  case 2:
    at.o = mirrored(at.i, at.n);
    break; // the middle of a highlight
  case 3:
    at = specular_pair(random);
    break;
  case 4:
    at = opposite_grazing_pair(random);
    break;
  case 5:
    at.i = random_direction(random), at.o = random_direction(random);
    break; // also below the horizon
  case 6:
    at.n = Double3(0);
    break; // no normal
  case 7:
    at.i = Double3(0);
    break; // light at the surface
  case 8:
    at.o = Double3(0);
    break; // eye at the surface
  default:
    break;
  }
  return {at.n, at.i, at.o, colour(), colour() * random_scale(random, -3, 3)};
}

} // namespace refraster
