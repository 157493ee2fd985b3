#pragma once
// The steps of the ladder.

#include "bench/merl_ladder/readers.h"
#include "shading/merl_synthesis.h"

#include <string>

namespace refraster::ladder {

/// |f - true f| / (true f + epsilon), the greatest of the three channels; over many pairs.
struct Errors {
  double mean = 0, mostly = 0, max = 0; // mostly: 99 of 100 are not larger
};

/// One way to read one material's table.
struct Step {
  std::string_view lookup;
  Reader reader;
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
  std::string_view lookup;
  Reader reader;
  double sphere_ns = 0, random_ns = 0; // of one look-up, with the angles before it
};
std::vector<Cost> measure_costs(const AnalyticBrdf& brdf);

} // namespace refraster::ladder
