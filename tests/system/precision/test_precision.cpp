// docs/precision.md, the constants it quotes, and what is measured now: all three agree.

#include "bench/precision/page.h"
#include "bench/precision/plot.h"
#include "tests/support/scenes/listed_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

using namespace refraster;
using namespace refraster::precision;

namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What the page says in the row of that name; empty if there is none.
std::string row_of_page(std::string_view what, std::string_view inputs) {
  static const std::string page = contents(REFRASTER_SOURCE_DIR "/docs/precision.md");
  const std::size_t from = page.find('\n' + row_name(what, inputs));
  return from == std::string::npos ? "" : page.substr(from + 1, page.find('\n', from + 1) - from - 1);
}

/// The row's bounds are these, in this order.
void check_bounds_in_page(std::string_view what, std::string_view inputs, std::initializer_list<std::string> bounds) {
  const std::string row = row_of_page(what, inputs);
  std::size_t from = 0;
  for (const std::string& bound : bounds) {
    CAPTURE(what);
    CAPTURE(inputs);
    CAPTURE(bound);
    from = row.find(bound + " |", from);
    REQUIRE(from != std::string::npos);
    from += bound.size();
  }
}

/// Of few inputs the largest error is all that can be judged; of many also what 99 of 100 keep to.
enum class Judge { maximum, both };

template <class Bound>
void check_error(std::string_view what, std::string_view inputs, const std::string& number, const Error& error,
                 const Bound& bound, Judge judge) {
  CAPTURE(what);
  CAPTURE(inputs);
  CAPTURE(number);
  CAPTURE(error.worst);
  CHECK(error.max <= bound.max);
  if (judge == Judge::both) CHECK(error.mostly <= bound.mostly);
}

void check_functions(int trials, Judge judge) {
  for (const FunctionRow& row : measure_functions(trials)) {
    check_error(row.function, row.inputs, "double", row.double_ulp, row.double_bound, judge);
    if (row.has_float) check_error(row.function, row.inputs, "float", row.float_ulp, row.float_bound, judge);
  }
}

void check_shading(int trials, Judge judge) {
  const std::vector<ShadingRow> rows = measure_shading(trials);
  CHECK(rows.size() == std::size(precision_bounds));
  for (const ShadingRow& row : rows) {
    const auto check = [&](const std::string& number, const Error& error, const UlpBound& bound) {
      check_error(row.bound.function, row.bound.inputs, number, error, bound, judge);
    };
    check("double, terms", row.double_terms, row.bound.double_terms);
    check("float, terms", row.float_terms, row.bound.float_terms);
    check("double, result", row.double_result, row.bound.double_result);
    check("float, result", row.float_result, row.bound.float_result);
    const double apart = row.bound.float_from_double;
    check("float - double", row.float_from_double, {apart, apart});
  }
}

void check_coordinates(int trials, Judge judge) {
  const std::vector<CoordinateRow> rows = measure_coordinates(trials);
  CHECK(rows.size() == std::size(coordinate_bounds));
  for (const CoordinateRow& row : rows) {
    check_error(row.bound.coordinate, row.bound.inputs, "double", row.double_bins, row.bound.double_bins, judge);
    check_error(row.bound.coordinate, row.bound.inputs, "float", row.float_bins, row.bound.float_bins, judge);
  }
}

void check_vertices(const std::vector<VertexRow>& rows, Judge judge) {
  CHECK(2 * rows.size() == std::size(vertex_bounds));
  for (const VertexRow& row : rows) {
    CHECK(row.bound.units.max > 0); // listed
    check_error(row.bound.stored, row.bound.scenes, "double", row.units, row.bound.units, judge);
  }
}

const PrecisionBound& bound_of(std::string_view function, std::string_view inputs) {
  for (const PrecisionBound& bound : precision_bounds)
    if (bound.function == function && bound.inputs == inputs) return bound;
  FAIL("no such bound");
  return precision_bounds[0];
}

} // namespace

TEST_CASE("docs/precision.md quotes the bounds of the source") {
  for (const FunctionRow& row : measure_functions(1)) {
    check_bounds_in_page(row.function, row.inputs, {bound_text(row.double_bound)});
    if (row.has_float) check_bounds_in_page(row.function, row.inputs, {bound_text(row.float_bound)});
  }
  for (const PrecisionBound& bound : precision_bounds)
    check_bounds_in_page(bound.function, bound.inputs,
                         {bound_text(bound.double_terms), bound_text(bound.float_terms),
                          bound_text(bound.double_result), bound_text(bound.float_result)});
  for (const CoordinateBound& bound : coordinate_bounds)
    check_bounds_in_page(std::string(bound.coordinate) + ' ' + std::string(bound.method), bound.inputs,
                         {bound_text(bound.double_bins), bound_text(bound.float_bins)});
  for (const VertexBound& bound : vertex_bounds)
    check_bounds_in_page(bound.stored, bound.scenes, {bound_text(bound.units)});
}

TEST_CASE("double keeps within 4 ulp on ordinary inputs, float within 1.2e-4 bin") {
  for (const std::string_view function : {"phong", "blinn_phong", "merl trilinear"})
    CHECK(bound_of(function, "ordinary").double_terms.max <= 4);
  for (const CoordinateBound& bound : coordinate_bounds)
    if (bound.method == "closed" && bound.coordinate != "w" && bound.inputs == "uniform")
      CHECK(bound.float_bins.max <= 1.2e-4);
}

TEST_CASE("no elementary function exceeds its bound") {
  check_functions(300, Judge::maximum);
}

TEST_CASE("no fragment function exceeds its bounds on any family of inputs") {
  check_shading(20, Judge::maximum);
}

TEST_CASE("no coordinate of the MERL table exceeds its bounds") {
  check_coordinates(300, Judge::maximum);
}

TEST_CASE("nothing that the vertex stage stores exceeds its bounds in the gallery or in random scenes") {
  check_vertices(measure_gallery_vertices(listed_scenes()), Judge::both);
  check_vertices(measure_random_vertices(500), Judge::maximum);
}

TEST_CASE("an arc cosine in float misses the highlight by more than a bin, the closed form by less than a tenth") {
  double acos_worst = 0, closed_worst = 0;
  for (const HighlightPoint& point : measure_highlight(20)) {
    acos_worst = std::max(acos_worst, point.acos_max);
    closed_worst = std::max(closed_worst, point.closed_max);
  }
  CHECK(acos_worst > 1);
  CHECK(closed_worst < 0.1);
}

namespace {

/// Everything that the page measures, on a share of its inputs.
void check_page(int share, Judge judge) {
  check_functions(20000 / share, judge);
  check_shading(5000 / share, judge);
  check_coordinates(20000 / share, judge);
  check_vertices(measure_random_vertices(20000 / share), judge);
}

} // namespace

TEST_SUITE("slow") {
  TEST_CASE("nothing exceeds its bounds on a thirtieth of the page's inputs") {
    check_page(30, Judge::maximum);
  }
}

TEST_SUITE("long") {
  TEST_CASE("nothing exceeds its bounds on the page's inputs, 99 of 100 results keep to the tighter ones") {
    check_page(1, Judge::both);
  }
}
