#include "bench/precision/page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>

namespace refraster::precision {

namespace {

/// One after the other. (Sums of literals and temporary strings make GCC 12 warn of an overlap that is none.)
std::string joined(std::initializer_list<std::string_view> parts) {
  std::string all;
  for (const std::string_view part : parts) all += part;
  return all;
}

/// Two digits: "0.57", "180", "5.8e5".
std::string number(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", x);
  const double rounded = std::strtod(buffer, nullptr), size = std::abs(rounded);
  if (rounded == 0 || (size >= 1e-3 && size < 1e5)) {
    std::snprintf(buffer, sizeof buffer, "%g", rounded);
    return buffer;
  }
  std::snprintf(buffer, sizeof buffer, "%.2g", rounded);
  std::string text = buffer;
  for (const std::string_view sign : {"e+0", "e+", "e-0"})
    if (const std::size_t at = text.find(sign); at != std::string::npos)
      return text.replace(at, sign.size(), sign == "e-0" ? "e-" : "e");
  return text;
}

std::string measured(const Error& error) {
  return joined({number(error.max), " (", number(error.mostly), ")"});
}

template <class Bound>
std::string cell(const Error& error, const Bound& bound) {
  return joined({" ", measured(error), " ", bound_text(bound), " |"});
}

std::string functions_table(const std::vector<FunctionRow>& rows) {
  std::string table = "| function | arguments | double | float |\n|---|---|---|---|\n";
  for (const FunctionRow& row : rows)
    table += row_name(row.function, row.inputs) + cell(row.double_ulp, row.double_bound) +
             (row.has_float ? cell(row.float_ulp, row.float_bound) : " — |") + "\n";
  return table;
}

std::string shading_table(const std::vector<ShadingRow>& rows) {
  std::string table =
      "| function | inputs | double, ulp of the terms | float, ulp of the terms | double, ulp of the result "
      "| float, ulp of the result | float − double |\n|---|---|---|---|---|---|---|\n";
  for (const ShadingRow& row : rows) {
    table += row_name(row.bound.function, row.bound.inputs) + cell(row.double_terms, row.bound.double_terms) +
             cell(row.float_terms, row.bound.float_terms) + cell(row.double_result, row.bound.double_result) +
             cell(row.float_result, row.bound.float_result) +
             joined({" ", measured(row.float_from_double), " ≤ ", number(row.bound.float_from_double), " |\n"});
  }
  return table;
}

/// What `nearest` read from a neighbouring bin.
std::string borders_table(const std::vector<ShadingRow>& rows) {
  std::string table = "| inputs | double | float |\n|---|---|---|\n";
  for (const ShadingRow& row : rows)
    if (row.bound.function == "merl nearest")
      table += joined({"| ", row.bound.inputs, " | ", number(100 * row.double_other_bin), " % | ",
                       number(100 * row.float_other_bin), " % |\n"});
  return table;
}

std::string coordinates_table(const std::vector<CoordinateRow>& rows) {
  std::string table = "| coordinate | inputs | double, bins | float, bins |\n|---|---|---|---|\n";
  for (const CoordinateRow& row : rows)
    table += row_name(joined({row.bound.coordinate, " ", row.bound.method}), row.bound.inputs) +
             cell(row.double_bins, row.bound.double_bins) + cell(row.float_bins, row.bound.float_bins) + "\n";
  return table;
}

/// What the constants promise of the goals.
std::string goals_table() {
  const auto bound = [](std::string_view function) {
    return *std::find_if(std::begin(precision_bounds), std::end(precision_bounds), [&](const PrecisionBound& one) {
      return one.function == function && one.inputs == "ordinary";
    });
  };
  const auto bins = [](std::string_view coordinate, std::string_view inputs) {
    return std::find_if(std::begin(coordinate_bounds), std::end(coordinate_bounds),
                        [&](const CoordinateBound& one) {
                          return one.coordinate == coordinate && one.method == "closed" && one.inputs == inputs;
                        })
        ->float_bins.max;
  };
  std::string table = "| ordinary inputs | double, ulp of the terms | double, ulp of the result | float − double |\n"
                      "|---|---|---|---|\n";
  for (const std::string_view function : {"phong", "blinn_phong", "merl trilinear"})
    table +=
        joined({"| ", function, " | ≤ ", number(bound(function).double_terms.max), " | ≤ ",
                number(bound(function).double_result.max), " | ≤ ", number(bound(function).float_from_double), " |\n"});
  table += "\n| float, bins | directions anywhere above the surface | specular |\n|---|---|---|\n";
  for (const std::string_view coordinate : {"u", "v", "w sin θh sin θd"})
    table += joined({"| ", coordinate, " | ≤ ", number(bins(coordinate, "uniform")), " | ≤ ",
                     number(bins(coordinate, "specular")), " |\n"});
  return table;
}

std::string worst_line(std::string_view what, std::string_view inputs, const char* kind, const Error& error) {
  return joined({what, ", ", inputs, ", ", kind, ": ", number(error.max), " at ", error.worst, "\n"});
}

std::string worst_inputs(const Measurements& all) {
  std::string text = "```\n";
  for (const FunctionRow& row : all.functions) {
    text += worst_line(row.function, row.inputs, "double", row.double_ulp);
    if (row.has_float) text += worst_line(row.function, row.inputs, "float", row.float_ulp);
  }
  for (const CoordinateRow& row : all.coordinates) {
    const std::string name = joined({row.bound.coordinate, " ", row.bound.method});
    text += worst_line(name, row.bound.inputs, "double", row.double_bins);
    text += worst_line(name, row.bound.inputs, "float", row.float_bins);
  }
  for (const ShadingRow& row : all.shading) {
    text += worst_line(row.bound.function, row.bound.inputs, "double", row.double_terms);
    text += worst_line(row.bound.function, row.bound.inputs, "float", row.float_terms);
  }
  return text + "```\n";
}

void replace_part(std::string& page, const std::string& name, const std::string& by) {
  const std::string begin = joined({"<!-- refraster_precision ", name, " -->\n"}), end = "<!-- end -->\n";
  const std::size_t from = page.find(begin);
  const std::size_t to = from == std::string::npos ? from : page.find(end, from);
  if (to == std::string::npos) throw std::runtime_error("the page has no part \"" + name + '"');
  page.replace(from + begin.size(), to - from - begin.size(), by);
}

double with_margin(double x) {
  if (!(x > 0) || !std::isfinite(x)) return x;
  const double unit = std::pow(10, std::floor(std::log10(1.25 * x)) - 1);
  return std::ceil(1.25 * x / unit - 1e-9) * unit;
}

std::string braces(const Error& error) {
  return joined({"{", number(with_margin(error.max)), ", ", number(with_margin(error.mostly)), "}"});
}
std::string quoted(std::string_view text) {
  return joined({"\"", text, "\""});
}

} // namespace

std::string bound_text(double max, double mostly) {
  return joined({"≤ ", number(max), " (", number(mostly), ")"});
}

std::string row_name(std::string_view what, std::string_view inputs) {
  return joined({"| ", what, " | ", inputs, " |"});
}

std::string updated_page(std::string page, const Measurements& measured) {
  std::vector<ShadingRow> phong, merl;
  for (const ShadingRow& row : measured.shading) (row.bound.function.starts_with("merl") ? merl : phong).push_back(row);
  replace_part(page, "goals", goals_table());
  replace_part(page, "functions", functions_table(measured.functions));
  replace_part(page, "phong", shading_table(phong));
  replace_part(page, "merl", shading_table(merl));
  replace_part(page, "borders", borders_table(merl));
  replace_part(page, "coordinates", coordinates_table(measured.coordinates));
  replace_part(page, "worst", worst_inputs(measured));
  return page;
}

std::string updated_page(std::string page, const std::vector<VertexRow>& measured) {
  std::string table = "| stored | scenes | double, units |\n|---|---|---|\n", worst = "```\n";
  for (const VertexRow& row : measured) {
    table += row_name(row.bound.stored, row.bound.scenes) + cell(row.units, row.bound.units) + "\n";
    worst += worst_line(row.bound.stored, row.bound.scenes, "double", row.units);
  }
  replace_part(page, "vertices", table);
  replace_part(page, "worst vertices", worst + "```\n");
  return page;
}

std::string suggested_bounds(const std::vector<VertexRow>& measured) {
  std::string text;
  for (const VertexRow& row : measured)
    text +=
        joined({"    {", quoted(row.bound.stored), ", ", quoted(row.bound.scenes), ", ", braces(row.units), "},\n"});
  return text;
}

std::string suggested_bounds(const Measurements& measured) {
  std::string text;
  for (const ShadingRow& row : measured.shading)
    text += joined({"    {", quoted(row.bound.function), ", ", quoted(row.bound.inputs), ", ", braces(row.double_terms),
                    ", ", braces(row.float_terms), ", ", braces(row.double_result), ", ", braces(row.float_result),
                    ", ", number(with_margin(row.float_from_double.max)), "},\n"});
  text += '\n';
  for (const CoordinateRow& row : measured.coordinates)
    text += joined({"    {", quoted(row.bound.coordinate), ", ", quoted(row.bound.method), ", ",
                    quoted(row.bound.inputs), ", ", braces(row.double_bins), ", ", braces(row.float_bins), "},\n"});
  return text;
}

} // namespace refraster::precision
