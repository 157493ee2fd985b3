#include "bench/precision/arc_cosines.h"
#include "bench/precision/exact_shading.h"
#include "bench/precision/measure.h"

#include "tests/support/shading/directions.h"

#include <algorithm>

namespace refraster::precision {

namespace {

/// An azimuth is the less defined the closer h is to n and i to h. On the sphere an error of it is a distance.
constexpr std::string_view sphere = "w sin θh sin θd";
Exact sines(const ExactPoint& at) {
  const Exact pi = constant<Exact>(constants::pi);
  const Exact theta_h = at.u * at.u / Exact(8100) * pi / Exact(2), theta_d = at.v * pi / Exact(180);
  return Exact(Exact::Value(sin(theta_h.value()) * sin(theta_d.value())));
}

struct Column {
  std::string_view coordinate, method;
  Errors in_double, in_float;
};

template <class F>
void add_all(std::vector<Column>& columns, const Inputs& in, Errors Column::*errors) {
  const Vec3<F> n = as<F>(in.n), i = as<F>(in.l), o = as<F>(in.v);
  const ExactPoint exactly = exact_merl_point(n, i, o);
  const auto describe = [&] { return "n = " + hex(in.n) + ", i = " + hex(in.l) + ", o = " + hex(in.v); };
  const MerlPoint<F> arc_cosines = merl_point_by_arc_cosines(n, i, o);
  for (Column& column : columns) {
    MerlPoint<F> at = arc_cosines;
    for (const auto& [method, name] : EnumNames<MerlAngles>::names)
      if (name == column.method) at = merl_point(half_difference(method, n, i, o));
    Exact error;
    if (column.coordinate == "u") error = abs(Exact(at.u) - exactly.u);
    if (column.coordinate == "v") error = abs(Exact(at.v) - exactly.v);
    if (column.coordinate == "w") error = distance_around(Exact(at.w), exactly.w);
    if (column.coordinate == sphere) error = distance_around(Exact(at.w), exactly.w) * sines(exactly);
    (column.*errors).add(error, describe);
  }
}

// theta_h and theta_d are computed in the same way for all three methods.
constexpr std::pair<std::string_view, std::string_view> measured[] = {
    {"u", "closed"},   {"u", "acos"},  {"v", "closed"},    {"v", "acos"},        {"w", "closed"},
    {"w", "rotation"}, {"w", "frame"}, {sphere, "closed"}, {sphere, "rotation"}, {sphere, "frame"},
};

CoordinateBound bound_of(const Column& column, std::string_view inputs) {
  for (const CoordinateBound& bound : coordinate_bounds)
    if (bound.coordinate == column.coordinate && bound.method == column.method && bound.inputs == inputs) return bound;
  return {column.coordinate, column.method, inputs, {}, {}};
}

} // namespace

std::vector<CoordinateRow> measure_coordinates(int trials) {
  std::vector<CoordinateRow> rows;
  for (const std::string_view name : {"uniform", "specular", "retro", "grazing", "plane"}) {
    const Family& inputs = family(merl_families(), name);
    std::vector<Column> columns;
    for (const auto& [coordinate, method] : measured) columns.push_back({coordinate, method, {}, {}});
    std::mt19937_64 random_double(1), random_float(2);
    for (int k = 0; k < trials; ++k) {
      add_all<double>(columns, held<double>(inputs.make(random_double, 0)), &Column::in_double);
      add_all<float>(columns, held<float>(inputs.make(random_float, 0)), &Column::in_float);
    }
    for (Column& column : columns)
      rows.push_back({bound_of(column, inputs.name), column.in_double.summary(), column.in_float.summary()});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const CoordinateRow& a, const CoordinateRow& b) {
    return std::pair(a.bound.coordinate, a.bound.method) < std::pair(b.bound.coordinate, b.bound.method);
  });
  return rows;
}

std::vector<HighlightPoint> measure_highlight(int pairs_each) {
  std::vector<HighlightPoint> points;
  std::mt19937_64 random(1);
  constexpr double least = -8, steps_per_decade = 10; // 1e-8 to 1 radian
  for (int step = 0; step <= static_cast<int>(-least * steps_per_decade); ++step) {
    const double angle = std::pow(10, least + step / steps_per_decade);
    std::vector<double> acos_errors, closed_errors;
    while (static_cast<int>(acos_errors.size()) < pairs_each) {
      const Double3 normal = random_direction(random), half = turned(normal, angle, random);
      const Double3 light = random_direction_above(normal, random), eye = mirrored(light, half);
      if (dot(normal, light) < 0.1 || dot(normal, eye) < 0.1) continue;
      const auto n = normalize(Float3(normal)), i = normalize(Float3(light)), o = normalize(Float3(eye));
      const Exact u = exact_merl_point(n, i, o).u;
      const auto off = [&](float computed) { return static_cast<double>(abs(Exact(computed) - u)); };
      acos_errors.push_back(off(merl_point_by_arc_cosines(n, i, o).u));
      closed_errors.push_back(off(merl_point(half_difference(MerlAngles::closed, n, i, o)).u));
    }
    std::sort(acos_errors.begin(), acos_errors.end());
    std::sort(closed_errors.begin(), closed_errors.end());
    const std::size_t middle = acos_errors.size() / 2;
    points.push_back({angle, acos_errors.back(), acos_errors[middle], closed_errors.back(), closed_errors[middle]});
  }
  return points;
}

} // namespace refraster::precision
