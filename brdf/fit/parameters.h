#pragma once
// The parameters of lobes as numbers without bounds.

#include "brdf/model.h"

#include <string>
#include <vector>

namespace refraster {

/// A parameter of one lobe that a fit may change.
struct FitParameter {
  std::size_t lobe = 0;
  std::string name; // "kd.r", "alpha"
  double value = 0;
  Range range;            // what it may be: for widths, from 1e-4 to 1e6 at most
  bool is_width = false;  // a single number: its logarithm is what is fitted
  bool is_at_end() const; // of its range, to within a thousandth: the fit may want more
};

/// Those of all lobes: colours channel by channel, then single numbers. What is diffuse (kd, albedo) is the first
/// lobe's only; choices, and what no light shows, stay as they are.
std::vector<FitParameter> fit_parameters(const std::vector<BrdfModel>& lobes);

/// The values without bounds: each number stands for one within the range, by James and Roos, "MINUIT", 1975, section
/// 1.2: a sine between two ends, of a width its logarithm; a hyperbola above one end.
std::vector<double> unbounded(const std::vector<FitParameter>& parameters);

/// The lobes with the values that these stand for.
std::vector<BrdfModel> with_unbounded(std::vector<BrdfModel> lobes, const std::vector<double>& x);

} // namespace refraster
