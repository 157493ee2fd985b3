#include "app/options/completions/completions.h"

namespace refraster {

std::string shell_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

std::string names_of_commands(const Command& command) {
  std::string names;
  for (const Command& sub : command.commands) names += (names.empty() ? "" : " ") + sub.name;
  return names;
}

} // namespace refraster
