#include "brdf/fit/fit.h"

#include <refraster/notes.h>

#include "brdf/fit/levenberg_marquardt.h"
#include "io/file/text.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

/// A bin's centre, and what is fitted there.
struct FitPoint {
  DirectionPair pair;
  Rgb<double> logarithm; // ln(1 + c f)
};

Rgb<double> logarithm_of(const Rgb<double>& f, double cosine) {
  return {std::log1p(cosine * f.x), std::log1p(cosine * f.y), std::log1p(cosine * f.z)};
}

/// Beyond 80 degrees of either direction measurements are the least certain, and of what is smooth the highlight is a
/// hundred times what it is elsewhere: Ngan et al. 2005, section 3, leave it out as well.
constexpr double min_cosine = 0.17364817766693035; // of 80 degrees

std::vector<FitPoint> fit_points(const Brdf& brdf) {
  std::vector<FitPoint> points;
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 2; d < MerlTable::theta_d_bins; d += 4)
      for (int p = 4; p < MerlTable::phi_d_bins; p += 9) { // both of p and 179 - p: light and eye exchanged
        const DirectionPair pair = directions_at_centre(h, d, p);
        if (std::min(pair.i.z, pair.o.z) < min_cosine) continue;
        const BrdfValue value = brdf.value(pair);
        if (value.measured) points.push_back({pair, logarithm_of(value.f, pair.i.z)});
      }
  return points;
}

Rgb<double> value_of(const std::vector<BrdfModel>& lobes, const DirectionPair& pair) {
  Rgb<double> sum(0);
  for (const BrdfModel& lobe : lobes) sum += model_value(lobe, pair);
  return sum;
}

Residuals residuals_of(const std::vector<FitPoint>& points, const std::vector<BrdfModel>& start) {
  return [&points, &start](std::span<const double> x, std::span<double> residuals) {
    const std::vector<BrdfModel> lobes = with_unbounded(start, {x.begin(), x.end()});
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Rgb<double> f = logarithm_of(value_of(lobes, points[k].pair), points[k].pair.i.z);
      for (int c = 0; c < 3; ++c) residuals[3 * k + static_cast<std::size_t>(c)] = f[c] - points[k].logarithm[c];
    }
  };
}

/// Sum of squares about the mean of each channel.
double variation(const std::vector<FitPoint>& points) {
  Rgb<double> mean(0);
  for (const FitPoint& point : points) mean += point.logarithm;
  mean /= static_cast<double>(points.size());
  double sum = 0;
  for (const FitPoint& point : points) sum += squared_length(point.logarithm - mean);
  return sum;
}

std::vector<std::string> doubts_of(const BrdfFit& fit, bool converged) {
  std::vector<std::string> doubts;
  if (fit.explained < min_explained)
    doubts.push_back(format("the model explains %.0f %% of how the logarithms vary, less than %.0f %%: it has not the "
                            "shape of the table",
                            100 * std::max(fit.explained, 0.0), 100 * min_explained));
  if (!converged) doubts.emplace_back("the search was stopped before it was at rest");
  for (const FitParameter& parameter : fit_parameters(fit.lobes))
    if (parameter.is_at_end())
      doubts.push_back(parameter.name + format(" is at the end of what it may be, %.4g", parameter.value));
  return doubts;
}

constexpr int max_evaluations = 600; // forty steps and their differences; most fits take a third

BrdfFit fit_to_points(const std::vector<FitPoint>& points, std::string model, const std::vector<BrdfModel>& start,
                      int evaluations) {
  const Minimum minimum = levenberg_marquardt(residuals_of(points, start), 3 * points.size(),
                                              unbounded(fit_parameters(start)), evaluations);
  BrdfFit fit{.model = std::move(model), .lobes = with_unbounded(start, minimum.x), .evaluations = minimum.evaluations};
  fit.log_rms = std::sqrt(minimum.sum_of_squares / static_cast<double>(3 * points.size()));
  const double varies = variation(points);
  fit.explained = varies > 0 ? 1 - minimum.sum_of_squares / varies : 1;
  fit.doubts = doubts_of(fit, minimum.converged);
  return fit;
}

bool can_be_fitted(const std::vector<FitPoint>& points, const std::vector<BrdfModel>& start) {
  return 3 * points.size() >= fit_parameters(start).size();
}

} // namespace

std::optional<BrdfFit> fit_brdf(const Brdf& brdf, const FittedModel& model, int lobes) {
  const std::optional<HighlightShape> shape = highlight_shape(brdf);
  if (!shape) return std::nullopt;
  const std::vector<FitPoint> points = fit_points(brdf);
  constexpr double widths[] = {1, 1.0 / 3, 3};
  const auto start = [&](std::size_t s, std::size_t w) { return model.starts[s](*shape, lobes, widths[w]); };
  for (std::size_t s = 0; s < model.starts.size(); ++s)
    if (!can_be_fitted(points, start(s, 0))) return std::nullopt;
  // A dozen steps tell which width is the best to start with; from there it goes on until it is at rest. A thread for
  // each start: within one, threads would wait for each other hundreds of times.
  std::vector<BrdfFit> tried(model.starts.size() * std::size(widths)), fits(model.starts.size());
#pragma omp parallel for schedule(dynamic)
  for (std::size_t k = 0; k < tried.size(); ++k) {
    const std::vector<BrdfModel> lobes_at_start = start(k / std::size(widths), k % std::size(widths));
    const int some_evaluations = 12 * static_cast<int>(fit_parameters(lobes_at_start).size() + 1);
    tried[k] = fit_to_points(points, std::string(model.name), lobes_at_start, some_evaluations);
  }
#pragma omp parallel for schedule(dynamic)
  for (std::size_t s = 0; s < fits.size(); ++s) {
    const auto first = tried.begin() + static_cast<std::ptrdiff_t>(s * std::size(widths));
    const auto best = std::ranges::min_element(first, first + std::size(widths), {}, &BrdfFit::log_rms);
    fits[s] = fit_to_points(points, std::string(model.name), best->lobes, max_evaluations);
  }
  BrdfFit fit = *std::ranges::min_element(fits, {}, &BrdfFit::log_rms);
  fit.evaluations = 0;
  for (const std::vector<BrdfFit>* const all : {&tried, &fits})
    for (const BrdfFit& one : *all) fit.evaluations += one.evaluations;
  return fit;
}

BrdfFit fit_or_refuse(const Brdf& brdf, const std::string& model, int lobes) {
  if (auto fit = fit_brdf(brdf, *find_fitted_model(model), lobes)) return *std::move(fit);
  throw InputError(InputFault{brdf.label(), 0, 0, "", "no value along theta_d = 22.5, phi_d = 89.5 degrees",
                              "a highlight to begin with"});
}

std::optional<BrdfFit> fit_brdf_from(const Brdf& brdf, std::string model, const std::vector<BrdfModel>& start) {
  const std::vector<FitPoint> points = fit_points(brdf);
  if (!can_be_fitted(points, start)) return std::nullopt;
  return fit_to_points(points, std::move(model), start, max_evaluations);
}

} // namespace refraster
