#include "brdf/fit/levenberg_marquardt.h"

#include <cminpack.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace refraster {
namespace {

extern "C" int call_residuals(void* residuals, int m, int n, const double* x, double* values, int) {
  (*static_cast<const Residuals*>(residuals))({x, static_cast<std::size_t>(n)}, {values, static_cast<std::size_t>(m)});
  return 0;
}

} // namespace

Minimum levenberg_marquardt(const Residuals& residuals, std::size_t residual_count, std::vector<double> x,
                            int max_evaluations) {
  const std::size_t n = x.size();
  const double tolerance = std::sqrt(std::numeric_limits<double>::epsilon());
  std::vector<double> values(residual_count), jacobian(residual_count * n), diagonal(n), qtf(n), work_1(n), work_2(n),
      work_3(n), work_4(residual_count);
  std::vector<int> pivots(n);
  constexpr int scaled_by_jacobian = 1;
  constexpr double first_step = 100; // of |D x|, MINPACK's own choice
  Minimum minimum;
  const int info =
      lmdif(call_residuals, const_cast<Residuals*>(&residuals), static_cast<int>(residual_count), static_cast<int>(n),
            x.data(), values.data(), tolerance, tolerance, 0, max_evaluations, 0, diagonal.data(), scaled_by_jacobian,
            first_step, 0, &minimum.evaluations, jacobian.data(), static_cast<int>(residual_count), pivots.data(),
            qtf.data(), work_1.data(), work_2.data(), work_3.data(), work_4.data());
  constexpr int too_many_evaluations = 5;
  minimum.converged = info >= 1 && info != too_many_evaluations;
  minimum.x = std::move(x);
  minimum.sum_of_squares = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return minimum;
}

} // namespace refraster
