#pragma once
// Least squares of functions that are not linear: MINPACK's.

#include <functional>
#include <span>
#include <vector>

namespace refraster {

/// Writes all residuals at x.
using Residuals = std::function<void(std::span<const double> x, std::span<double> residuals)>;

struct Minimum {
  std::vector<double> x;
  double sum_of_squares = 0;
  int evaluations = 0;
  bool converged = false; // false: stopped after max_evaluations
};

/// A local minimum of the sum of squares near x, by MINPACK's lmdif (Moré, Garbow, Hillstrom 1980; cminpack): the
/// method of Levenberg and Marquardt with forward differences. Stops where neither the sum nor x changes by more than
/// sqrt(2^-52) of itself, as MINPACK's manual advises. residual_count >= x.size(). The same bits every time.
Minimum levenberg_marquardt(const Residuals& residuals, std::size_t residual_count, std::vector<double> x,
                            int max_evaluations);

} // namespace refraster
