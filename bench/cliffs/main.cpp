// refraster_cliffs [--precision double|float] [--only WORD]: see bench/cliffs/run.

#include "bench/cliffs/calibration.h"
#include "bench/report/text_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace refraster;
using namespace refraster::cliffs;

constexpr double larger = 4;        // the second size over the first
constexpr double expensive = 10;    // times the ordinary cost
constexpr double seconds_a_row = 1; // at least five frames of each size

std::string number(double value, const char* format = "%.3g") {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

struct Options {
  Precision precision = Precision::float_;
  std::string only;
};

Options read_arguments(int count, char** words) {
  Options options;
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view word = words[i], value = words[i + 1];
    if (word == "--only") options.only = value;
    else if (word == "--precision" && value == "double") options.precision = Precision::double_;
    else if (word != "--precision" || value != "float") std::exit(2);
  }
  if (count % 2 == 0) std::exit(2);
  return options;
}

/// How cost grows: from t to 4^exponent t. And at least, with both frames timed to their quartiles.
struct Growth {
  double exponent, at_least;
};
/// That of n log n, which counts as linear: lists are sorted.
double sorting_exponent(double size) {
  return 1 + std::log(std::log(larger * size) / std::log(size)) / std::log(larger);
}

Growth growth(const TwoTimings& timings) {
  const auto exponent = [](double from, double to) { return std::log(to / from) / std::log(larger); };
  return {exponent(timings.first.median_ms, timings.second.median_ms),
          exponent(timings.first.upper_ms, timings.second.lower_ms)};
}

/// Measures a family and adds its row. Whether it is a cliff without a reason.
bool add_row(const Family& family, const Options& options, const OrdinaryCost& cost, bench::TextTable& table) {
  std::array<Work, 2> works = {family.make(family.size), family.make(larger * family.size)};
  for (Work& work : works) work.options.precision = options.precision;
  const TwoTimings timings = timings_of(works[0], works[1], seconds_a_row);
  const Load load = load_of(works[1], timings.second.counts);
  const double ms = timings.second.median_ms, times = ms / ordinary_ms(cost, load);
  const auto each = [&](double units) { return units > 0 ? number(1e6 * ms / units) : "-"; };
  const Growth grown = growth(timings);
  const bool cliff = grown.at_least > sorting_exponent(family.size) || times > expensive;
  const std::string mark = !cliff ? "" : family.reason.empty() ? "CLIFF" : std::string(family.reason);
  table.add({std::string(family.name), std::string(words_of(family.grows)) + " " + number(family.size, "%.0f") + " x 4",
             number(timings.first.median_ms), number(ms), each(load.triangles), each(load.vertices), each(load.pixels),
             number(grown.exponent, "%.2f"), number(times, "%.2f"), mark});
  std::cerr << "." << std::flush;
  return cliff && family.reason.empty();
}

int run(const Options& options) {
  const OrdinaryCost cost = measured_costs(options.precision);
  std::cout << "ordinarily, in " << name_of(options.precision) << " on one thread: " << number(cost.pixel)
            << " ns a pixel of the background, " << number(cost.covered) << " a pixel that a triangle covers, "
            << number(cost.fragment) << " a fragment and light, " << number(cost.triangle) << " a triangle, "
            << number(cost.vertex) << " a vertex\n\n";
  bench::TextTable table({"family", "grows", "ms", "ms at 4 x", "ns a triangle", "a vertex", "a sample", "exponent",
                          "times the ordinary", ""});
  int cliffs = 0;
  for (const auto families : {geometry_families(), pixel_families(), shading_families()})
    for (const Family& family : families)
      if (family.name.find(options.only) != std::string_view::npos) cliffs += add_row(family, options, cost, table);
  std::cerr << "\n";
  std::cout << table.text();
  return cliffs > 0;
}

} // namespace

int main(int count, char** words) {
  try {
    return run(read_arguments(count, words));
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}
