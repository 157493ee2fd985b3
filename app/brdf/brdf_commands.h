#pragma once
// The commands of `refraster brdf`, a file each, and what they have in common.

#include <refraster/material.h>

#include "app/command.h"
#include "app/diagnostics.h"
#include "brdf/brdf.h"

#include <string>

namespace refraster {

Command brdf_info_command();    // info_command.cpp
Command brdf_synth_command();   // synth_command.cpp
Command brdf_eval_command();    // eval_command.cpp
Command brdf_compare_command(); // compare_command.cpp
Command brdf_fit_command();     // fit_command.cpp
Command brdf_plot_command();    // plot_command.cpp
Command brdf_import_command();  // import_command.cpp

/// An argument that names a table or a model: `refraster brdf info BRDF`.
Option brdf_argument(const std::string& name, std::string& word, const std::string& meaning);

/// --lookup: how tables are read between their samples.
Option lookup_option(MerlLookup& lookup);

/// What every command that takes models says of them below its options.
std::vector<std::string> model_notes();

/// Throws UsageError if the word means a model, and is wrong. Of files nothing is asked.
void check_brdf_word(const std::string& name, const std::string& word);

/// Reads the table of that name, or makes the model. Throws UsageError as check_brdf_word, and InputError for a file.
Brdf read_brdf(const std::string& word, MerlLookup lookup, const Diagnostics& diagnostics);

} // namespace refraster
