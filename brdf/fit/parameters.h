#pragma once
// The parameters of lobes as numbers without bounds.

#include "brdf/model.h"

#include <string>
#include <vector>

namespace refraster {

/// How steps of a number are measured.
enum class FitScale {
  channel,  // of a colour: by itself
  width,    // by its logarithm
  fraction, // by itself: either end is an answer
};

/// A parameter of one lobe that a fit may change.
struct FitParameter {
  std::size_t lobe = 0;
  std::string name; // "kd.r", "alpha"
  double value = 0;
  Range range; // what it may be: for widths, from 1e-4 to 1e6 at most
  FitScale scale = FitScale::channel;
  bool is_at_end() const; // of its range, to within a thousandth: the fit may want more
};

/// Those of all lobes: colours channel by channel, then single numbers. The ground (kd, albedo, metallic, ior) is the
/// first lobe's only; choices, and what f does not depend on, stay as they are. Of a Microfacet without any metal the
/// refractive index may change and the metal may not, of others the other way round.
std::vector<FitParameter> fit_parameters(const std::vector<BrdfModel>& lobes);

/// The values without bounds: each number stands for one within the range, by James and Roos, "MINUIT", 1975, section
/// 1.2: a sine between two ends, of a width its logarithm; a hyperbola above one end.
std::vector<double> unbounded(const std::vector<FitParameter>& parameters);

/// The lobes with the values that these stand for.
std::vector<BrdfModel> with_unbounded(std::vector<BrdfModel> lobes, const std::vector<double>& x);

} // namespace refraster
