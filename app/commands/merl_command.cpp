// refraster merl info | synth

#include "app/arguments.h"
#include "app/command.h"
#include "app/memory_limit.h"
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

void add_info(CLI::App& merl, Action& chosen) {
  CLI::App& info = add_sub_command(merl, "info", "What is in a table");
  const auto path = std::make_shared<std::string>();
  info.add_option("file", *path, "table, .binary")->required()->type_name("FILE");
  const auto max_memory = std::make_shared<std::uint64_t>(0);
  add_memory_option(info, *max_memory);
  info.final_callback([&chosen, path, max_memory] {
    chosen = [path, max_memory] {
      set_memory_limit(*max_memory, 1);
      return print_info(*path);
    };
  });
}

/// `merl synth NAME -o FILE`; the caller may add options that change the formula.
template <class Brdf>
CLI::App& add_formula(CLI::App& synth, Action& chosen, const std::string& name, const std::string& meaning,
                      const std::shared_ptr<Brdf>& formula) {
  CLI::App& command = add_sub_command(synth, name, meaning);
  const auto output = std::make_shared<std::string>(name + ".binary");
  command.add_option("-o,--output", *output, "table to write")->type_name("FILE");
  const auto max_memory = std::make_shared<std::uint64_t>(0);
  add_memory_option(command, *max_memory);
  command.final_callback([&chosen, formula, output, max_memory] {
    chosen = [formula, output, max_memory] {
      set_memory_limit(*max_memory, 1);
      check_writable(*output);
      {
        const ProgressLine line("making " + *output);
        write_merl(*output, merl_table_from(std::as_const(*formula)));
      }
      std::cout << *output << "\n";
      return ExitCode::ok;
    };
  });
  return command;
}

void add_reflectance(CLI::App& command, const std::string& name, Double3& value, const std::string& description) {
  const auto text = [](double x) { return CLI::detail::to_string(x); };
  add_parsed_option(command, name, value, reflectance_from, "R,G,B", "one number or three, in [0, 1]", description)
      ->default_str(text(value.x) + "," + text(value.y) + "," + text(value.z));
}

void add_alpha(CLI::App& command, double& alpha) {
  // Below 0.001 a highlight is narrower than the first bin of theta_h, 1.9e-4 rad: the table would only show noise.
  add_number_option(command, "--alpha", alpha, Range{0.001, 1},
                    "roughness: slope at which the density has fallen to a quarter");
}

void add_synth(CLI::App& merl, Action& chosen) {
  CLI::App& synth = add_sub_command(merl, "synth", "Make a table from a formula");
  synth.require_subcommand(1);

  const auto lambert = std::make_shared<Lambert>();
  CLI::App& matt = add_formula(synth, chosen, "lambert", "the same in all directions", lambert);
  add_reflectance(matt, "--albedo", lambert->albedo, "fraction of the light that is reflected");

  const auto conductor = std::make_shared<GgxConductor>();
  CLI::App& metal = add_formula(synth, chosen, "ggx-conductor", "rough metal", conductor);
  add_alpha(metal, conductor->alpha);
  add_reflectance(metal, "--f0", conductor->f0, "reflectance at normal incidence");

  const auto dielectric = std::make_shared<GgxDielectric>();
  CLI::App& plastic =
      add_formula(synth, chosen, "ggx-dielectric", "rough dielectric over a diffuse ground", dielectric);
  add_alpha(plastic, dielectric->alpha);
  add_number_option(plastic, "--ior", dielectric->ior, Range{1.0001, 10}, "refractive index");
  add_reflectance(plastic, "--albedo", dielectric->albedo, "of the ground");

  for (const BrdfPreset& preset : brdf_presets()) {
    if (preset.name == "lambert") continue; // is there, with a parameter
    add_formula(synth, chosen, std::string(preset.name), std::string(preset.meaning),
                std::make_shared<AnalyticBrdf>(preset.brdf));
  }
}

} // namespace

void add_merl(CLI::App& program, Action& chosen) {
  CLI::App& merl = add_sub_command(program, "merl", "Look into a measured BRDF, or make a table");
  merl.require_subcommand(1);
  add_info(merl, chosen);
  add_synth(merl, chosen);
}

} // namespace refraster
