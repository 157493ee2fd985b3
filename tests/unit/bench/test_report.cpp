// How figures are reported: differences that are smaller than their spread, doubts, tables, pictures.

#include "bench/page/page.h"
#include "bench/report/doubts.h"
#include "bench/report/report_csv.h"
#include "bench/report/report_json.h"
#include "bench/report/report_text.h"
#include "tests/support/text.h"

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <sstream>

using namespace refraster;
using namespace refraster::bench;

namespace {

/// A run of one scene on a quiet machine of four CPUs: ten repetitions of 10 ms. `light`: what one more light costs.
Run quiet_run(const Spread& light) {
  Run run;
  run.machine.cpus = 4;
  run.machine.usable_cpus = {0, 1, 2, 3};
  run.machine.cpu = "a, \"CPU\"";
  SceneResult scene;
  scene.scene = "folder/ball <1>.json";
  scene.width = 64, scene.height = 36;
  scene.repetitions = 10;
  scene.counts.shaded = 1000;
  PrecisionResult precision;
  precision.precision = "double";
  precision.threads = 2;
  precision.frame_ms = precision.cpu_ms = {9.9, 9.95, 10, 10.05, 10.1};
  precision.split_ns.lighting = -3;
  precision.lighting_ns = {-9, -4, -3, 2, 5};
  precision.marginal = Marginal{.light = light, .texture = {}, .double_samples = {}};
  scene.precisions = {precision};
  run.scenes = {scene};
  return run;
}

const Spread unresolved{-9, -4, 1, 2.5, 7}; // quartiles 6.5 apart
const Spread resolved{1, 2, 3, 4, 5};
const Spread saving{-5, -4, -3, -2, -1};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

const CsvTable& table_named(const std::vector<CsvTable>& tables, std::string_view name) {
  for (const CsvTable& table : tables)
    if (table.file_name == name) return table;
  FAIL("no such table");
  return tables.front();
}

} // namespace

TEST_CASE("a difference is a figure where its median is farther from 0 than its quartiles are from each other") {
  CHECK(is_resolved(resolved));
  CHECK(is_resolved(saving));
  CHECK_FALSE(is_resolved(unresolved));
  CHECK_FALSE(is_resolved({1, 2, 2, 4, 5})); // as far
  CHECK_FALSE(is_resolved({3, 3, 3, 3, 3})); // a single round
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(is_resolved({nan, nan, nan, nan, nan}));
}

TEST_CASE("what a cost is below is never less than the spread, nor negative") {
  CHECK(cost_bound(unresolved) == 6.5);
  CHECK(cost_bound({0, 1, 4, 7, 9}) == 7);
  CHECK(cost_bound({-9, -8, -5, -2, -1}) == 6);
  CHECK(cost_bound({-3, -3, -3, -3, -3}) == 3);
}

TEST_CASE("costs in words: a figure, a bound, a saving, nothing") {
  const auto words = [](const Spread& difference) {
    const CostText text = cost_text(difference);
    return text.median + "|" + text.lower + "|" + text.upper;
  };
  CHECK(words(resolved) == "3.00|2.00|4.00");
  CHECK(words(unresolved) == "< 6.50|-|-");
  CHECK(words(saving) == "saves 3.00|2.00|4.00");
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(words({infinity, infinity, infinity, infinity, infinity}) == "-|-|-");
}

TEST_CASE("no report shows a negative cost; JSON and CSV keep the numbers, with a flag") {
  const Run run = quiet_run(unresolved);
  for (const std::string& text : {run_text(run), run_html(run)}) {
    CHECK_MESSAGE(!holds(text, "-3"), text);
    CHECK(!holds(text, "-4"));
  }
  CHECK(holds(run_text(run), "< 6.50"));
  CHECK(holds(run_text(run), "< 6.00")); // of the fragment functions, in the split
  CHECK(holds(run_html(run), "&lt; 6.50"));
  CHECK(holds(run_html(run), "fragment_functions: &lt; 6.00 ns"));
  const std::string json = run_json(run);
  CHECK(holds(json, "\"resolved\": false"));
  CHECK(holds(json, "\"below\": 6.5"));
  CHECK(holds(json, "\"fragment_functions\": -3"));
  CHECK(holds(run_json(quiet_run(resolved)), "\"resolved\": true,\n          \"below\": null"));
}

TEST_CASE("the standard error of a median, by hand: sqrt(pi / 2 / 9) * 2 / 1.349 of 10") {
  CHECK(median_error({8, 9, 10, 11, 12}, 9) == doctest::Approx(0.0619).epsilon(0.001));
  CHECK(std::isnan(median_error({8, 9, 10, 11, 12}, 2)));
}

TEST_CASE("a quiet run leaves no doubts") {
  CHECK(doubts(quiet_run(resolved)).empty());
  Run run = quiet_run(resolved);
  run.load_at_start = {2.4, 0, 0}; // and 2 threads, on 4 CPUs
  run.load_at_end = {4.4, 0, 0};   // with our own
  CHECK(doubts(run).empty());
}

TEST_CASE("other programs on the CPUs are noted, at the start and, beside our own threads, at the end") {
  Run run = quiet_run(resolved);
  run.load_at_start = {2.6, 0, 0};
  REQUIRE(doubts(run).size() == 1);
  CHECK(doubts(run)[0] == "at the start other programs kept 2.6 of 4 CPUs busy, by the load average, and up to 2 were "
                          "measured on: figures may be too high");
  run.load_at_start = {0, 0, 0}, run.load_at_end = {4.6, 0, 0};
  REQUIRE(doubts(run).size() == 1);
  CHECK(doubts(run)[0].starts_with("at the end other programs kept 2.6 of 4 CPUs busy"));
  // 64 threads on 4 CPUs are our own load.
  run.scenes[0].precisions[0].threads = 64;
  run.load_at_end = {63, 0, 0};
  CHECK(doubts(run).empty());
}

TEST_CASE("times that scatter are noted, and repetitions that are too few to know") {
  Run run = quiet_run(resolved);
  run.scenes[0].precisions[0].frame_ms = {5, 8, 10, 12, 50}; // 0.117 of the median
  REQUIRE(doubts(run).size() == 1);
  CHECK(doubts(run)[0] ==
        "1 of 1 frame times scatter so much that their second digit means nothing; most of all double "
        "with 2 threads on folder/ball <1>.json, 64x36, whose quartiles are 40 % of the median "
        "apart, over 10 repetitions");
  run.scenes[0].repetitions = 2;
  REQUIRE(doubts(run).size() == 1);
  CHECK(doubts(run)[0].find("1 of 1 frame times are of fewer than three repetitions") == 0);
}

TEST_CASE("every table is a file: headings, then rows of as many cells, with quotes where they are needed") {
  Run run = quiet_run(unresolved);
  run.notes = {"a note, and \"more\""};
  const std::vector<CsvTable> tables = csv_tables(run);
  REQUIRE(tables.size() == std::size(csv_file_names));
  const auto costs = lines_of(table_named(tables, "costs.csv").text);
  REQUIRE(costs.size() == 2);
  CHECK(costs[0] ==
        "scene,width,height,samples,precision,threads,what,of,ns_min,ns_lower,ns_median,ns_upper,ns_max,resolved,"
        "below_ns");
  CHECK(costs[1] == "folder/ball <1>.json,64,36,1,double,2,one more light,pixel,-9,-4,1,2.5,7,no,6.5");
  CHECK(lines_of(table_named(tables, "frames.csv").text).size() == 2);
  CHECK(holds(table_named(tables, "frames.csv").text, ",double,2,10,9.9,9.95,10,10.05,10.1,"));
  CHECK(holds(table_named(tables, "split.csv").text, ",-3,"));
  CHECK(lines_of(table_named(tables, "errors.csv").text).size() == 1);
  CHECK(lines_of(table_named(tables, "scaling.csv").text).size() == 1);
  CHECK(holds(table_named(tables, "machine.csv").text, "cpu,\"a, \"\"CPU\"\"\"\n"));
  CHECK(holds(table_named(tables, "machine.csv").text, "note,\"a note, and \"\"more\"\"\"\n"));
  for (const CsvTable& table : tables) { // none of these has a comma within quotes
    if (table.file_name == "machine.csv") continue;
    const auto lines = lines_of(table.text);
    for (const std::string& line : lines)
      CHECK(std::count(line.begin(), line.end(), ',') == std::count(lines[0].begin(), lines[0].end(), ','));
  }
}

TEST_CASE("a picture that is cut out of the page is a file of its own: XML, SVG's name space, a style, paper") {
  Run run = quiet_run(resolved);
  run.scenes[0].scene = "a\x01 & <b>\xff.json";
  PrecisionError error;
  error.precision = "double";
  error.against_exact = {.pixels = 1, .max_relative = 1, .mean_relative = 1};
  run.scenes[0].errors = {error};
  run.scenes[0].opengl = {{2, "driver", "1", resolved, resolved}};
  run.scenes[0].precisions[0].opengl_ratio = resolved;
  ScalingCurve curve;
  curve.growth = Growth::lights;
  curve.precision = "double";
  for (const double n : {1, 2}) {
    MeasuredPoint point;
    point.point.n = n;
    point.frame_ms = resolved;
    point.frames = 3;
    point.peak_memory_bytes = 1000000;
    curve.points.push_back(point);
  }
  run.scaling = {curve};
  const std::string page = run_html(run);
  int pictures = 0;
  for (std::size_t at = page.find("<svg"); at != std::string::npos; at = page.find("<svg", at + 1)) {
    const std::size_t end = page.find("</svg>", at) + 6;
    std::istringstream file(page.substr(at, end - at));
    boost::property_tree::ptree xml;
    REQUIRE_NOTHROW(boost::property_tree::read_xml(file, xml));
    CHECK(xml.get<std::string>("svg.<xmlattr>.xmlns") == "http://www.w3.org/2000/svg");
    const auto style = xml.get<std::string>("svg.style");
    CHECK(holds(style, ".paper { fill: #fdfdfc;"));
    const auto& paper = xml.get_child("svg.rect"); // the first: beneath all else
    CHECK(paper.get<std::string>("<xmlattr>.class") == "paper");
    CHECK(paper.get<std::string>("<xmlattr>.width") == xml.get<std::string>("svg.<xmlattr>.width") + ".00");
    // Every class that is drawn with has its rule in the picture's own style.
    for (const auto& [name, element] : xml.get_child("svg")) {
      std::istringstream classes(element.get<std::string>("<xmlattr>.class", ""));
      for (std::string one; classes >> one;) CHECK_MESSAGE(holds(style, "." + one), one);
    }
    ++pictures;
  }
  CHECK(pictures == 5); // error, split, ratio, growth, memory
}
