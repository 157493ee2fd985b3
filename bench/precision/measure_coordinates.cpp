#include "bench/precision/arc_cosines.h"
#include "bench/precision/exact_shading.h"
#include "bench/precision/measure.h"

namespace refraster::precision {

namespace {

struct Column {
  std::string_view coordinate, method;
  Errors in_double, in_float;
};

template <class F>
void add_all(std::vector<Column>& columns, const Inputs& in, Errors Column::*errors) {
  const Vec3<F> n = as<F>(in.n), i = as<F>(in.l), o = as<F>(in.v);
  const ExactPoint exactly = exact_merl_point(exact(n), exact(i), exact(o));
  const auto describe = [&] { return "n = " + hex(in.n) + ", i = " + hex(in.l) + ", o = " + hex(in.v); };
  const MerlPoint<F> arc_cosines = merl_point_by_arc_cosines(n, i, o);
  for (Column& column : columns) {
    MerlPoint<F> at = arc_cosines;
    for (const auto& [method, name] : EnumNames<MerlAngles>::names)
      if (name == column.method) at = merl_point(half_difference(method, n, i, o));
    Exact error;
    if (column.coordinate == "u") error = abs(Exact(at.u - exactly.u));
    if (column.coordinate == "v") error = abs(Exact(at.v - exactly.v));
    if (column.coordinate == "w") error = distance_around(Exact(at.w), exactly.w);
    (column.*errors).add(error, describe);
  }
}

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
    // theta_h and theta_d are computed in the same way for all three methods.
    std::vector<Column> columns;
    for (const auto& [coordinate, method] :
         {std::pair("u", "closed"), {"u", "acos"}, {"v", "closed"}, {"v", "acos"}, {"w", "closed"}, {"w", "rotation"},
          {"w", "frame"}})
      columns.push_back({coordinate, method, {}, {}});
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

} // namespace refraster::precision
