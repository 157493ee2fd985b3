// refraster merl info | synth

#include <refraster/files.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/memory_limit.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "io/brdf/merl_file.h"
#include "io/file/sha256.h"
#include "scenes/synthesis/merl_synthesis.h"
#include "verify/merl_facts.h"

#include <cstdio>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

void print_rgb(const char* label, const Rgb<double>& rgb) {
  std::printf("%-16s %12.6g %12.6g %12.6g\n", label, rgb.x, rgb.y, rgb.z);
}

struct TableInfo {
  std::string material; // empty if not one of the database
  MerlFacts facts;
};

TableInfo table_info(const std::string& path) {
  const ProgressLine line("reading " + path);
  const std::shared_ptr<const MerlTable> table = read_merl(path);
  return {std::string(merl_material_name(file_sha256(path))), merl_facts(*table)};
}

ExitCode print_info(const std::string& path) {
  const TableInfo info = table_info(path);
  const MerlFacts& facts = info.facts;
  const auto per_channel = [&](double ChannelFacts::*fact) {
    return Rgb<double>(facts.channels[0].*fact, facts.channels[1].*fact, facts.channels[2].*fact);
  };
  std::printf("%-16s %s\n", "file", path.c_str());
  std::printf("%-16s %s\n", "material",
              info.material.empty() ? "not one of the 100 of the database" : info.material.c_str());
  std::printf("%-16s %d x %d x %d (theta_h, theta_d, phi_d)\n", "samples", MerlTable::theta_h_bins,
              MerlTable::theta_d_bins, MerlTable::phi_d_bins);
  std::printf("%-16s %llu (%.2f %%)\n", "never measured", static_cast<unsigned long long>(facts.never_measured),
              100 * static_cast<double>(facts.never_measured) / static_cast<double>(MerlTable::samples));
  std::printf("%-16s %12s %12s %12s\n", "f, 1/sr", "red", "green", "blue");
  print_rgb("  min", per_channel(&ChannelFacts::min));
  print_rgb("  max", per_channel(&ChannelFacts::max));
  print_rgb("  mean", per_channel(&ChannelFacts::mean));
  std::printf("albedo, light at\n");
  for (const AlbedoFact& fact : facts.albedos)
    print_rgb(("  " + std::to_string(static_cast<int>(fact.degrees)) + " degrees").c_str(), fact.albedo);
  std::printf("%-16s %.3g relative, the most of %d pairs of directions\n", "f(i,o) - f(o,i)", facts.reciprocity_error,
              facts.reciprocity_pairs);
  return ExitCode::ok;
}

Command info_command() {
  struct Arguments {
    std::string path;
    std::uint64_t max_memory = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  return {.name = "info",
          .meaning = "What is in a table",
          .groups = {{"Table",
                      {argument("FILE", arguments->path, "table, .binary"), memory_option(arguments->max_memory)}}},
          .finish = [arguments]() -> Action {
            return [arguments] {
              set_memory_limit(arguments->max_memory, 1);
              return print_info(arguments->path);
            };
          }};
}

/// `merl synth NAME -o FILE`. parameters: options that change the formula.
template <class Brdf>
Command formula_command(std::string name, std::string meaning, const std::shared_ptr<Brdf>& formula,
                        std::vector<Option> parameters) {
  struct Arguments {
    std::string output;
    std::uint64_t max_memory = 0;
  };
  const auto arguments = std::make_shared<Arguments>();
  arguments->output = name + ".binary";
  Command command{.name = std::move(name), .meaning = std::move(meaning)};
  if (!parameters.empty()) command.groups.push_back({"Formula", std::move(parameters)});
  command.groups.push_back({"Run",
                            {file_option("-o,--output", "FILE", arguments->output, "table to write"),
                             memory_option(arguments->max_memory)}});
  command.finish = [formula, arguments]() -> Action {
    return [formula, arguments] {
      set_memory_limit(arguments->max_memory, 1);
      check_writable(arguments->output);
      {
        const ProgressLine line("making " + arguments->output);
        write_merl(arguments->output, merl_table_from(std::as_const(*formula)));
      }
      std::cout << arguments->output << "\n";
      return ExitCode::ok;
    };
  };
  return command;
}

Option reflectance_option(const std::string& name, Double3& value, std::string meaning) {
  return parsed_option(name, "R,G,B", value, reflectance_from,
                       "one number, or three separated by commas, each in [0, 1]", std::move(meaning))
      .by_default(number_text(value.x) + "," + number_text(value.y) + "," + number_text(value.z));
}

Option alpha_option(double& alpha) {
  // Below 0.001 a highlight is narrower than the first bin of theta_h, 1.9e-4 rad: the table would only show noise.
  return number_option("--alpha", alpha, Range{0.001, 1},
                       "roughness: slope at which the density has fallen to a quarter");
}

Command synth_command() {
  const auto lambert = std::make_shared<Lambert>();
  const auto metal = std::make_shared<GgxConductor>();
  const auto plastic = std::make_shared<GgxDielectric>();
  Command command{.name = "synth", .meaning = "Make a table from a formula"};
  command.commands = {
      formula_command("lambert", "the same in all directions", lambert,
                      {reflectance_option("--albedo", lambert->albedo, "fraction of the light that is reflected")}),
      formula_command(
          "ggx-conductor", "rough metal", metal,
          {alpha_option(metal->alpha), reflectance_option("--f0", metal->f0, "reflectance at normal incidence")}),
      formula_command("ggx-dielectric", "rough dielectric over a diffuse ground", plastic,
                      {alpha_option(plastic->alpha),
                       number_option("--ior", plastic->ior, Range{1.0001, 10}, "refractive index"),
                       reflectance_option("--albedo", plastic->albedo, "of the ground")})};
  for (const BrdfPreset& preset : brdf_presets()) {
    if (preset.name == "lambert") continue; // is there, with a parameter
    command.commands.push_back(formula_command(std::string(preset.name), std::string(preset.meaning),
                                               std::make_shared<AnalyticBrdf>(preset.brdf), {}));
  }
  return command;
}

} // namespace

Command merl_command() {
  return {.name = "merl",
          .meaning = "Look into a measured BRDF, or make a table",
          .commands = {info_command(), synth_command()}};
}

} // namespace refraster
