#include "bench/measure/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace refraster::bench {

Spread spread_of(std::vector<double> values) {
  assert(!values.empty());
  std::sort(values.begin(), values.end());
  const auto at = [&](double fraction) {
    const double place = fraction * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (values[above] - values[below]) * (place - static_cast<double>(below));
  };
  return {values.front(), at(0.25), at(0.5), at(0.75), values.back()};
}

Spread operator*(const Spread& spread, double factor) {
  return {spread.min * factor, spread.lower * factor, spread.median * factor, spread.upper * factor,
          spread.max * factor};
}

Spread operator-(const Spread& spread) {
  return {-spread.max, -spread.upper, -spread.median, -spread.lower, -spread.min};
}

bool is_resolved(const Spread& difference) {
  return difference.max > difference.min && std::abs(difference.median) > quartile_distance(difference);
}

double cost_bound(const Spread& difference) {
  return std::max({difference.upper, quartile_distance(difference), std::abs(difference.median)});
}

double median_error(const Spread& spread, std::size_t repetitions) {
  if (repetitions < 3) return std::numeric_limits<double>::quiet_NaN();
  constexpr double quartiles_of_normal = 1.3489795; // 2 Phi^-1(3/4)
  const double sigma = quartile_distance(spread) / quartiles_of_normal;
  return std::sqrt(std::numbers::pi / 2 / static_cast<double>(repetitions)) * sigma / spread.median;
}

std::vector<std::size_t> middle_half(std::span<const double> values) {
  assert(!values.empty());
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  const auto quarter = static_cast<std::ptrdiff_t>(values.size() / 4);
  return {order.begin() + quarter, order.end() - quarter};
}

Slope log_log_slope(std::span<const Point> points) {
  assert(points.size() >= 2);
  const auto n = static_cast<double>(points.size());
  double mean_x = 0, mean_y = 0;
  for (const Point& p : points) mean_x += std::log(p.x) / n, mean_y += std::log(p.y) / n;
  double xx = 0, xy = 0;
  for (const Point& p : points) {
    const double x = std::log(p.x) - mean_x, y = std::log(p.y) - mean_y;
    xx += x * x, xy += x * y;
  }
  const double slope = xy / xx;
  if (points.size() == 2) return {slope, 0};
  double residuals = 0;
  for (const Point& p : points) {
    const double off = std::log(p.y) - mean_y - slope * (std::log(p.x) - mean_x);
    residuals += off * off;
  }
  return {slope, std::sqrt(residuals / (n - 2) / xx)};
}

} // namespace refraster::bench
