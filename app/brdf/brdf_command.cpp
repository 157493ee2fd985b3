// refraster brdf: what its commands have in common.

#include "app/brdf/brdf_commands.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "brdf/read_brdf.h"

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
  const auto progress = means_model(word) ? nullptr : progress_line(diagnostics, "reading " + word);
  return read_brdf(word, lookup);
}

Command brdf_command() {
  return {.name = "brdf",
          .meaning = "Look into reflectance, measured or by a formula",
          .commands = {brdf_info_command(), brdf_synth_command(), brdf_eval_command(), brdf_compare_command(),
                       brdf_fit_command(), brdf_plot_command(), brdf_import_command()}};
}

} // namespace refraster
