#pragma once
// The steps of the ladder.

#include "bench/merl_ladder/readers.h"
#include "scenes/synthesis/merl_synthesis.h"

#include <string>

namespace refraster::ladder {

/// |f - true f| / (true f + epsilon), the greatest of the three channels; over many pairs.
struct Errors {
  double mean = 0, mostly = 0, max = 0; // mostly: 99 of 100 are not larger
};

/// One way to read a table.
struct Way {
  MerlLookup lookup;
  std::string_view lookup_name;
  Reader reader;

  const Format& format() const {
    const bool logarithms = lookup == MerlLookup::trilinear_log || lookup == MerlLookup::tricubic_log;
    return logarithms ? reader.logarithms : reader.values;
  }
};

/// With what it makes of one material's table.
struct Step {
  Way way;
  struct {
    Errors from_material, from_trilinear; // the formula; trilinear in double
  } specular, uniform;
};

struct Material {
  std::string name;
  std::vector<Step> steps;
};

Material measure_errors(const std::string& name, const AnalyticBrdf& brdf, int pairs);

struct Cost {
  Way way;
  double sphere_ns = 0, random_ns = 0; // of one look-up, with the angles before it
};
std::vector<Cost> measure_costs(const AnalyticBrdf& brdf);

} // namespace refraster::ladder
