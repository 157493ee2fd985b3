#pragma once
// Parameters of a model that come nearest to a reflectance.

#include "brdf/fit/parameters.h"
#include "brdf/fit/start.h"

#include <string>
#include <vector>

namespace refraster {

struct BrdfFit {
  std::string model = {};               // of the list fitted_models
  std::vector<BrdfModel> lobes = {};    // that add up
  double log_rms = 0;                   // root mean square of ln(1 + c f) - ln(1 + c f_table), over bins and channels
  double explained = 0;                 // 1 - the sum of squares, by that about the mean: R^2
  int evaluations = 0;                  // of all starts together
  std::vector<std::string> doubts = {}; // sentences: why it is poor; empty if it is not
};

/// A fit whose lobes explain less of what the table's logarithms vary is called poor.
inline constexpr double min_explained = 0.9;

/// Least squares of ln(1 + c f), c the cosine of the light's angle (Löw, Kronander, Ynnerman, Unger, "BRDF models for
/// accurate and efficient rendering of glossy surfaces", 2012), over red, green and blue at the centres of bins: of all
/// theta_h, every fourth theta_d and every ninth phi_d, where light and eye are within 80 degrees of the normal. Each
/// bin counts the same, so that a highlight, where bins are fine, does. Begins at closed forms of the highlight's
/// height and width, and at a third and three times that width; the best of them is the result. Deterministic. A second
/// or two. lobes: 1 to 3. Nothing where the reflectance is measured nowhere that the start looks.
std::optional<BrdfFit> fit_brdf(const Brdf& brdf, const FittedModel& model, int lobes);

/// The same of a model by its name, which must be listed. Throws InputError, of the file that the label names, where
/// there is nothing.
BrdfFit fit_or_refuse(const Brdf& brdf, const std::string& model, int lobes);

/// The same from these lobes alone: for those who search for a better start.
std::optional<BrdfFit> fit_brdf_from(const Brdf& brdf, std::string model, const std::vector<BrdfModel>& start);

/// Whether a scene can name the fit as it is: one lobe of a fragment function.
bool is_fragment_function(const BrdfFit& fit);

/// For people.
std::string fit_text(const Brdf& brdf, const BrdfFit& fit);
/// docs/reports.md.
std::string fit_json(const Brdf& brdf, const BrdfFit& fit);
/// The keys "fragment_function" and "material" of an object of a scene file, within one object. table: path of the fit
/// as a table, for those that no fragment function has.
std::string material_json(const BrdfFit& fit, const std::string& table);

} // namespace refraster
