#pragma once
// What makes a shell complete the program's commands, options and the words that options choose from.

#include "app/command.h"

#include <string>
#include <string_view>

namespace refraster {

// The text of a script for the shell; `refraster list completions --help` says what to do with it. A file each,
// completions_bash.cpp and so on.
std::string bash_completions(const Command& program);
std::string zsh_completions(const Command& program);
std::string fish_completions(const Command& program);

struct Shell {
  std::string_view name;
  std::string (*completions)(const Command& program);
};
inline constexpr Shell shells[] = {{"bash", bash_completions}, {"zsh", zsh_completions}, {"fish", fish_completions}};

/// In single quotes, for any of the shells.
std::string shell_quoted(std::string_view text);

/// "render compare gl"
std::string names_of_commands(const Command& command);

} // namespace refraster
