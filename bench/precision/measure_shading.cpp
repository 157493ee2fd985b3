#include "bench/precision/exact_shading.h"
#include "bench/precision/measure.h"

#include "scenes/synthesis/merl_synthesis.h"
#include "shading/fragment_functions.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace refraster::precision {

namespace {

/// Merl has one channel measured in every trial; all others have the same value in all three.
int channel_of(int trial) {
  return trial % 3;
}

template <class F, class SomeFunction>
F radiance(const SomeFunction& function, const Inputs& in, int channel) {
  const Lit<F> there = lit<F>(in);
  return reflected(function, there.at, there.light)[channel];
}

/// The errors of one fragment function in one number.
struct FunctionErrors {
  Errors terms, result;

  template <class F, class Describe>
  void add(F computed, const Exactly& exactly, const Describe& describe) {
    const Exact error = abs(Exact(computed) - exactly.value);
    terms.add(error / Exact(ulp_at<F>(exactly.terms.value())), describe);
    result.add(error / Exact(ulp_at<F>(exactly.value.value())), describe);
  }
};

/// Which bound belongs to a row; the default one, which nothing keeps to, where there is none yet.
PrecisionBound bound_of(std::string_view function, std::string_view inputs) {
  for (const PrecisionBound& bound : precision_bounds)
    if (bound.function == function && bound.inputs == inputs) return bound;
  return {function, inputs, {}, {}, {}, {}, 0};
}

/// Radiance of float beside that of double, on one scene: each rounds the inputs for itself.
template <class SomeFunction>
double float_from_double(const SomeFunction& in_double, const SomeFunction& in_float, const Inputs& of_double,
                         const Inputs& of_float, int channel) {
  const double arriving = lit<double>(of_double).light.radiance.x;
  const double apart = radiance<double>(in_double, of_double, channel) -
                       static_cast<double>(radiance<float>(in_float, of_float, channel));
  return std::abs(apart) / arriving;
}

// Phong, Blinn-Phong and microfacets.

/// With a highlight about as wide as Blinn-Phong's of that glossiness: alpha^2 = 2 / (s + 2). Half of it is metal.
Microfacet microfacets_of(const Inputs& in) {
  Microfacet function;
  function.base_color = Double3(std::min(in.kd, 1.0)), function.metallic = 0.5;
  function.roughness = std::max(std::pow(2 / (in.glossiness + 2), 0.25), Microfacet::min_roughness);
  return function;
}

template <class SomeFunction>
SomeFunction fragment_function_of(const Inputs& in) {
  if constexpr (std::is_same_v<SomeFunction, Microfacet>) return microfacets_of(in);
  else return SomeFunction{{Double3(0), Double3(in.kd), Double3(in.ks), in.glossiness, SpecularGate::open}};
}

template <class SomeFunction>
ShadingRow measure_phong(const Family& inputs, int trials) {
  FunctionErrors in_double, in_float;
  Errors apart;
  const auto once = [&]<class F>(FunctionErrors& errors, std::mt19937_64& random) {
    const Inputs in = held<F>(inputs.make(random, decades<F>));
    const SomeFunction function = fragment_function_of<SomeFunction>(in);
    errors.add(radiance<F>(function, in, 0), exactly(function, in), [&] { return text(in, Glossiness::used); });
  };
  std::mt19937_64 random_double(1), random_float(2);
  for (int k = 0; k < trials; ++k) {
    once.template operator()<double>(in_double, random_double);
    const std::mt19937_64 before = random_float;
    once.template operator()<float>(in_float, random_float);
    std::mt19937_64 again = before;
    const Inputs in = inputs.make(again, decades<float>);
    const Inputs of_double = held<double>(in), of_float = held<float>(in);
    apart.add(float_from_double(fragment_function_of<SomeFunction>(of_double),
                                fragment_function_of<SomeFunction>(of_float), of_double, of_float, 0),
              [&] { return text(of_float, Glossiness::used); });
  }
  return {bound_of(SomeFunction::name, inputs.name),
          in_double.terms.summary(),
          in_float.terms.summary(),
          in_double.result.summary(),
          in_float.result.summary(),
          apart.summary()};
}

// MERL.

/// Whether rounding decides which bin a point lies in: `nearest` then reads the neighbouring sample, which says nothing
/// about last places. Such inputs are counted and left out.
template <class F>
bool other_bin(const MerlPlace& place, const Inputs& in) {
  const Lit<F> there = lit<F>(in);
  const MerlPoint<F> at =
      merl_point(half_difference(MerlAngles::closed, there.at.normal, there.light.direction, there.at.to_eye));
  const auto bin = [](const auto& x, int last) { return std::clamp(floor_and_fraction(x).index, 0, last); };
  return bin(at.u, 89) != bin(place.at.u, 89) || bin(at.v, 89) != bin(place.at.v, 89) ||
         bin(at.w, 179) != bin(place.at.w, 179);
}

struct Lookup {
  MerlLookup lookup;
  FunctionErrors in_double, in_float;
  Errors apart;
  int other_bin_double = 0, other_bin_float = 0;
};

template <class F>
void add_all(std::vector<Lookup>& lookups, const std::shared_ptr<const MerlTable>& table, const Inputs& in, int channel,
             FunctionErrors Lookup::*errors, int Lookup::*other) {
  const MerlPlace place = exact_merl_place(in);
  const bool border = other_bin<F>(place, in);
  for (Lookup& one : lookups) {
    if (one.lookup == MerlLookup::nearest && border) {
      ++(one.*other);
      continue;
    }
    const F computed = radiance<F>(Merl{table, one.lookup, MerlAngles::closed}, in, channel);
    const Exactly exactly = exact_merl(place, *table, one.lookup, channel);
    (one.*errors).add(computed, exactly, [&] { return text(in, Glossiness::unused); });
  }
}

std::vector<ShadingRow> measure_merl(const std::shared_ptr<const MerlTable>& table, const Family& inputs, int trials) {
  std::vector<Lookup> lookups;
  for (const auto& [lookup, name] : EnumNames<MerlLookup>::names) lookups.push_back({lookup, {}, {}, {}});
  std::mt19937_64 random_double(1), random_float(2);
  for (int k = 0; k < trials; ++k) {
    const int channel = channel_of(k);
    add_all<double>(lookups, table, held<double>(inputs.make(random_double, decades<double>)), channel,
                    &Lookup::in_double, &Lookup::other_bin_double);
    const Inputs in = inputs.make(random_float, decades<float>);
    const Inputs of_double = held<double>(in), of_float = held<float>(in);
    add_all<float>(lookups, table, of_float, channel, &Lookup::in_float, &Lookup::other_bin_float);
    for (Lookup& one : lookups) {
      const Merl function{table, one.lookup, MerlAngles::closed};
      one.apart.add(float_from_double(function, function, of_double, of_float, channel),
                    [&] { return text(of_float, Glossiness::unused); });
    }
  }
  std::vector<ShadingRow> rows;
  for (Lookup& one : lookups) {
    // A row's name has to live as long as the row: it is that of the bound, or one of these.
    static const std::string names[] = {"merl nearest", "merl trilinear", "merl trilinear-edge", "merl trilinear-log",
                                        "merl tricubic-log"};
    rows.push_back({bound_of(names[static_cast<int>(one.lookup)], inputs.name), one.in_double.terms.summary(),
                    one.in_float.terms.summary(), one.in_double.result.summary(), one.in_float.result.summary(),
                    one.apart.summary(), one.other_bin_double / double(trials), one.other_bin_float / double(trials)});
  }
  return rows;
}

} // namespace

std::vector<ShadingRow> measure_shading(int trials) {
  std::vector<ShadingRow> rows;
  for (const Family& inputs : phong_families()) rows.push_back(measure_phong<Phong>(inputs, trials));
  for (const Family& inputs : phong_families()) rows.push_back(measure_phong<BlinnPhong>(inputs, trials));
  for (const Family& inputs : phong_families()) rows.push_back(measure_phong<Microfacet>(inputs, trials));
  const std::shared_ptr<const MerlTable> table(new MerlTable(merl_table_from(find_brdf_preset("nylon-like")->brdf)));
  std::vector<ShadingRow> merl;
  for (const Family& inputs : merl_families())
    for (ShadingRow& row : measure_merl(table, inputs, trials)) merl.push_back(std::move(row));
  // By lookup, then by inputs.
  std::stable_sort(merl.begin(), merl.end(),
                   [](const ShadingRow& a, const ShadingRow& b) { return a.bound.function < b.bound.function; });
  for (ShadingRow& row : merl) rows.push_back(std::move(row));
  return rows;
}

} // namespace refraster::precision
