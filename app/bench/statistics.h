#pragma once
// What many measurements of one thing say.

#include <cstddef>
#include <span>
#include <vector>

namespace refraster::bench {

/// Five numbers: the least, the greatest, and the three that cut the sorted values into quarters.
struct Spread {
  double min = 0, lower = 0, median = 0, upper = 0, max = 0;
};

/// Of at least one value. Between two values that share a quartile's place it is interpolated linearly, so that the
/// median of two is their mean.
Spread spread_of(std::vector<double> values);

/// Each value times `factor` >= 0.
Spread operator*(const Spread& spread, double factor);

/// Which values lie in the middle half: indices into `values`, at least one. The mean over them is as steady as a
/// median, and unlike medians such means add up: the parts of a frame to the frame.
std::vector<std::size_t> middle_half(std::span<const double> values);

/// A straight line through points in logarithms, y = c x^value: least squares, with the standard error of the slope
/// (0 for two points, which a line fits exactly).
struct Slope {
  double value = 0, error = 0;
};
struct Point {
  double x, y; // > 0
};
/// Of at least two points with different x.
Slope log_log_slope(std::span<const Point> points);

} // namespace refraster::bench
