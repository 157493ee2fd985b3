// refraster_merl_ladder: how far each way to read a measured table is from the material, and what it costs.

#include "bench/merl_ladder/page.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <fstream>
#include <iostream>
#include <sstream>

namespace {

using namespace refraster;
using namespace refraster::ladder;

void update(const std::string& path, const std::string& ladder) {
  std::ostringstream page;
  if (!(page << std::ifstream(path).rdbuf())) throw std::runtime_error(path + ": cannot be read");
  const std::string text = updated_page(page.str(), ladder);
  if (!(std::ofstream(path) << text).flush()) throw std::runtime_error(path + ": cannot be written");
}

} // namespace

int main(int argc, char** argv) {
  CLI::App app("Every way to read a measured table: its error against the material's formula, and its cost.");
  int pairs = 200000;
  std::string page;
  app.add_option("--pairs", pairs, "pairs of directions in each family")
      ->check(CLI::Range(1, 100'000'000))
      ->capture_default_str();
  app.add_option("--update", page, "the page whose tables to replace: docs/merl.md; else they are printed")
      ->type_name("FILE");
  CLI11_PARSE(app, argc, argv);
  try {
    const auto preset = [](const char* name) { return find_brdf_preset(name)->brdf; };
    std::vector<ladder::Material> materials;
    materials.push_back(measure_errors("Sharp: metal, α = 0.02", GgxConductor{0.02, Double3(0.9, 0.7, 0.4)}, pairs));
    materials.push_back(measure_errors("Between: `brass-like`, α = 0.1", preset("brass-like"), pairs));
    materials.push_back(measure_errors("Smooth: `nylon-like`, α = 0.3", preset("nylon-like"), pairs));
    const std::string ladder = markdown(materials, measure_costs(preset("brass-like")), pairs);
    if (page.empty()) std::cout << ladder;
    else update(page, ladder);
  } catch (const std::exception& error) {
    std::cerr << "refraster_merl_ladder: " << error.what() << '\n';
    return 4;
  }
}
