// refraster brdf: what its commands have in common.

#include <refraster/files.h>

#include "app/brdf/brdf_commands.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "io/file/nearest.h"

#include <filesystem>
#include <system_error>

namespace refraster {

Option brdf_argument(const std::string& name, std::string& word, const std::string& meaning) {
  return argument(name, word, meaning + ": a table, .binary, or a model, NAME:KEY=VALUE,…");
}

Option lookup_option(MerlLookup& lookup) {
  return enum_option("--lookup", lookup, "how tables are read between their samples; docs/merl.md");
}

std::vector<std::string> model_notes() {
  std::vector<std::string> notes;
  std::string models = "Models, with their parameters:";
  for_each_model([&](const BrdfModel& model) { models += " " + model_text(model) + ";"; });
  models.back() = '.';
  notes.push_back(models + " A colour is one number, or three with commas between them. '+' between models adds them "
                           "up. docs/brdf.md");
  std::string presets = "Presets, models whose parameters are chosen:";
  for (const BrdfPreset& preset : brdf_presets())
    if (preset.name != Lambert::name) presets += " " + std::string(preset.name) + ",";
  presets.back() = '.';
  notes.push_back(presets);
  return notes;
}

void check_brdf_word(const std::string& name, const std::string& word) {
  if (!means_model(word)) return;
  for (const ModelFault& fault : read_models(word).faults)
    throw UsageError(fault.place.empty() ? name : fault.place, fault.found, fault.expected);
}

Brdf read_brdf(const std::string& word, MerlLookup lookup, const Diagnostics& diagnostics) {
  if (means_model(word)) return {word, read_models(word).lobes};
  std::error_code ignored;
  if (word.find_first_of("./") == std::string::npos && !std::filesystem::exists(word, ignored))
    throw InputError(InputFault{word, 0, 0, "", "no such file", "a MERL table, or " + one_of(model_names(), word)});
  const auto progress = progress_line(diagnostics, "reading " + word);
  Merl table;
  table.table = read_merl(word);
  table.lookup = lookup;
  return {word, table};
}

Command brdf_command() {
  return {.name = "brdf",
          .meaning = "Look into reflectance, measured or by a formula",
          .commands = {brdf_info_command(), brdf_synth_command(), brdf_eval_command(), brdf_compare_command(),
                       brdf_fit_command(), brdf_plot_command(), brdf_import_command()}};
}

} // namespace refraster
