#include "bench/page/charts.h"

#include "io/html/svg.h"
#include "io/file/text.h"

#include <algorithm>

namespace refraster::bench {
namespace {

constexpr double width = 424, height = 318, left = 66, right = 14, top = 30, bottom = 268;

struct Values {
  std::string classes;
  std::vector<double> n, value;
  std::vector<std::string> tooltips;
};

void min_and_max(const std::vector<double>& values, double& least, double& most) {
  for (const double value : values) least = std::min(least, value), most = std::max(most, value);
}

enum class Reference { none, linear };

/// Curves with dots. A reference goes through the last point of the first curve: what cost would be, had it grown
/// linearly up to there.
std::string plot(const Run& run, const std::vector<Values>& curves, const std::string& x_name,
                 const std::string& y_name, Scale::Kind x_kind, Scale::Kind y_kind, Reference reference) {
  if (curves.empty() || curves.front().n.empty()) return {};
  double x_min = curves[0].n[0], x_max = x_min, y_min = curves[0].value[0], y_max = y_min;
  for (const Values& curve : curves) {
    min_and_max(curve.n, x_min, x_max);
    min_and_max(curve.value, y_min, y_max);
  }
  if (y_kind == Scale::Kind::linear) y_min = 0;
  const Scale x = Scale::around(x_kind, x_min, x_max, left, width - right);
  const Scale y = Scale::around(y_kind, y_min, y_max, bottom, top);
  Svg svg(width, height, y_name + " over " + x_name);
  svg.legend(left, 12, precision_legend(run));
  svg.x_axis(x, top, bottom, x_name);
  svg.y_axis(y, left, width - right, y_name);
  if (reference == Reference::linear) {
    const double each = curves[0].value.back() / curves[0].n.back();
    const double from = std::max(x.from(), y.from() / each), to = std::min(x.to(), y.to() / each);
    if (from < to) svg.line(x(from), y(from * each), x(to), y(to * each), "reference");
  }
  for (const Values& curve : curves) {
    std::vector<double> xs, ys;
    for (std::size_t i = 0; i < curve.n.size(); ++i) xs.push_back(x(curve.n[i])), ys.push_back(y(curve.value[i]));
    svg.curve(xs, ys, "curve " + curve.classes);
    for (std::size_t i = 0; i < xs.size(); ++i) svg.dot(xs[i], ys[i], 3.2, curve.classes, curve.tooltips[i]);
  }
  return svg.markup();
}

std::string classes_of(const Run& run, const ScalingCurve& curve) {
  return precision_class(index_of(precisions_of(run), curve.precision)) +
         (curve.order == LayerOrder::front_to_back ? " dashed" : "");
}

std::string axis_name(const ScalingCurve& curve) {
  return curve.growth == Growth::overdraw ? "layers" : std::string(name_of(curve.growth));
}

} // namespace

std::string growth_chart(const Run& run, std::span<const ScalingCurve* const> curves) {
  const bool threads = curves.front()->growth == Growth::threads;
  std::vector<Values> all;
  for (const ScalingCurve* const curve : curves) {
    Values& values = all.emplace_back();
    values.classes = classes_of(run, *curve);
    for (const MeasuredPoint& point : curve->points) {
      const double ms = point.frame_ms.median;
      values.n.push_back(point.point.n);
      values.value.push_back(threads ? curve->points.front().frame_ms.median / ms : ms);
      values.tooltips.push_back(format("%s, %.0f: %.4g ms", curve->precision.c_str(), point.point.n, ms));
    }
  }
  if (threads)
    return plot(run, all, "threads", "times as fast as one thread", Scale::Kind::whole, Scale::Kind::linear,
                Reference::none);
  return plot(run, all, axis_name(*curves.front()), "ms a frame", Scale::Kind::logarithmic, Scale::Kind::logarithmic,
              Reference::linear);
}

std::string memory_chart(const Run& run, std::span<const ScalingCurve* const> curves) {
  std::vector<Values> all;
  for (const ScalingCurve* const curve : curves) {
    Values values;
    values.classes = classes_of(run, *curve);
    for (const MeasuredPoint& point : curve->points) {
      if (!point.peak_memory_bytes) continue;
      const double megabytes = static_cast<double>(*point.peak_memory_bytes) * 1e-6;
      values.n.push_back(point.point.n);
      values.value.push_back(megabytes);
      values.tooltips.push_back(format("%s, %.0f: %.4g MB", curve->precision.c_str(), point.point.n, megabytes));
    }
    if (!values.n.empty()) all.push_back(std::move(values));
  }
  const bool steep = all.empty() || all.front().value.back() > 5 * all.front().value.front();
  const bool threads = curves.front()->growth == Growth::threads;
  return plot(run, all, axis_name(*curves.front()), "peak memory, MB",
              threads ? Scale::Kind::whole : Scale::Kind::logarithmic,
              steep ? Scale::Kind::logarithmic : Scale::Kind::linear, Reference::none);
}

} // namespace refraster::bench
