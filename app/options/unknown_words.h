#pragma once
// What is said of words that a command does not know: what was found, what was meant, what there is.

#include "app/command.h"
#include "app/usage_error.h"

#include <string>
#include <vector>

namespace refraster {

/// Nothing follows a command that another one must follow.
BareCommand missing_command(const CommandPath& path);

UsageError unknown_command(const CommandPath& path, const std::string& word);

/// word: "--name", "--name=value" or "-n". An old name is told with the new one.
UsageError unknown_option(const CommandPath& path, const std::string& word);

/// An argument too many. words: those behind the command.
UsageError further_argument(const CommandPath& path, const std::string& word, const std::vector<std::string>& words);

/// "; commas stand between values: --crop 0,0,4,4" if the option is given among the words, blanks stand between its
/// values, and with commas in their places they would be right. Else "". Lets the option read.
std::string hint_of_commas(const Option& option, const std::vector<std::string>& words);

} // namespace refraster
