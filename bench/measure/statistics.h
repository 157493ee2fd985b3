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

/// Each value with the other sign: what was the least becomes the greatest.
Spread operator-(const Spread& spread);

/// The distance of the quartiles.
inline double quartile_distance(const Spread& spread) {
  return spread.upper - spread.lower;
}

/// Whether a difference of two measurements, taken repetition by repetition, is larger than its spread: its median
/// farther from 0 than its quartiles are from each other. The median of nine repetitions has a standard error of 0.31
/// of that distance (median_error), so that what is farther from 0 is three standard errors from it. Of a single
/// repetition no spread is known: never. Nor of values that are no numbers.
bool is_resolved(const Spread& difference);

/// What a cost whose difference is not resolved is below: the greater of its upper quartile and the distance of the
/// quartiles. > 0, but for a single repetition in which nothing was measured.
double cost_bound(const Spread& difference);

/// The standard error of the median of `repetitions` values, as a share of that median: sqrt(pi / 2) sigma /
/// sqrt(repetitions), for a normal distribution, whose quartiles are 1.349 sigma apart. NaN of fewer than three values,
/// which have no quartiles of their own.
double median_error(const Spread& spread, std::size_t repetitions);

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
