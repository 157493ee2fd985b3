// refraster_precision: measures how exact the numbers are, and writes docs/precision.md.

#include "bench/precision/page.h"
#include "bench/precision/plot.h"

#include "tests/support/scenes/listed_scenes.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>
#include <utility>
#include <vector>

namespace {

std::string contents(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  if (!(text << file.rdbuf())) throw std::runtime_error(path + ": cannot be read");
  return text.str();
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  if (!(file << text).flush()) throw std::runtime_error(path + ": cannot be written");
}

/// The gallery, whose meshes scripts/make_assets makes, and random scenes.
std::vector<refraster::precision::VertexRow> measure_vertices(int random_scenes) {
  using namespace refraster::precision;
  std::vector<VertexRow> rows = measure_gallery_vertices(refraster::listed_scenes());
  for (VertexRow& row : measure_random_vertices(random_scenes)) rows.push_back(std::move(row));
  return rows;
}

} // namespace

int main(int argc, char** argv) {
  using namespace refraster::precision;
  CLI::App app("Measures every elementary function and fragment function against 60 digits.");
  int trials = 20000;
  std::string page, plot;
  bool bounds = false, vertices = false;
  app.add_option("--trials", trials, "inputs in each row")->check(CLI::PositiveNumber)->capture_default_str();
  app.add_option("--update", page, "the page whose tables to replace: docs/precision.md")->type_name("FILE");
  app.add_option("--plot", plot, "the picture to write: docs/images/precision_acos.svg")->type_name("FILE");
  app.add_flag("--bounds", bounds, "print the rows of shading/precision_bounds.h and raster/vertex/error_bounds.h");
  app.add_flag("--vertices", vertices, "measure the vertex stage alone, in seconds");
  CLI11_PARSE(app, argc, argv);

  try {
    if (!plot.empty()) write(plot, highlight_plot(measure_highlight(1000)));
    if (page.empty() && !bounds) return 0;
    const std::vector<VertexRow> stored = measure_vertices(trials);
    if (bounds) std::cout << suggested_bounds(stored);
    if (!page.empty()) write(page, updated_page(contents(page), stored));
    if (vertices) return 0;
    const Measurements measured = {measure_functions(trials), measure_shading(trials), measure_coordinates(trials)};
    if (bounds) std::cout << suggested_bounds(measured);
    if (!page.empty()) write(page, updated_page(contents(page), measured));
  } catch (const std::exception& error) {
    std::cerr << "refraster_precision: " << error.what() << '\n';
    return 4;
  }
  return 0;
}
