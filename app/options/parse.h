#pragma once
// The command line, read after the declarations. The only place that knows CLI11 is parse.cpp.

#include "app/command.h"

#include <string>
#include <vector>

namespace refraster {

/// The command that the first words name, and the words that follow them.
struct NamedCommand {
  CommandPath path;
  std::vector<std::string> rest;
};

/// words: without the program's own name. `path` points into `program`.
NamedCommand named_command(const Command& program, const std::vector<std::string>& words);

/// Lets the options read their values and gives what is to be done; or, with --help or --version anywhere, printing
/// that. Throws UsageError for the first thing that is wrong: an option that there is not, a value, an argument too
/// many, an argument that is missing, and what the command itself checks.
Action action_of(const NamedCommand& named);

} // namespace refraster
