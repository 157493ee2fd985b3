#include "app/options/completions/completions.h"

namespace refraster {
namespace {

/// Fish takes a backslash in single quotes for an escape; a quote in them is written \'.
std::string single_quoted(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) {
    if (letter == '\'' || letter == '\\') result += '\\';
    result += letter;
  }
  return result + "'";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// What completes a value, as further words of the command `complete`. -x: files are none; -F: they are.
std::string offer(const Command& program, const Option& option) {
  const std::string exclusive = option.is_argument() ? "" : " -x";
  switch (option.completes) {
  case Completes::files:
    return option.is_argument() ? " -F" : " -r -F";
  case Completes::folders:
    return exclusive + " -a '(__fish_complete_directories)'";
  case Completes::commands:
    return exclusive + " -a " + single_quoted(names_of_commands(program));
  case Completes::words:
    if (option.takes == Takes::values)
      return exclusive + " -a " + single_quoted("(__fish_append , " + joined(option.words) + ")");
    return exclusive + " -a " + single_quoted(joined(option.words));
  case Completes::nothing:
    break;
  }
  return exclusive;
}

} // namespace

std::string fish_completions(const Command& program) {
  std::string commands, lines;
  for (const CommandPath& path : all_commands(program)) {
    if (path.size() > 1) commands += " " + single_quoted(full_name(path));
    const std::string line =
        "complete -c refraster -n " + single_quoted("test (__refraster_command) = \"" + full_name(path) + "\"");
    for (const Command& sub : path.back()->commands)
      lines += line + " -a " + single_quoted(sub.name) + " -d " + single_quoted(sub.meaning) + "\n";
    for (const Option* const option : all_options(*path.back())) {
      std::string names;
      if (option->short_name != 0) names += std::string(" -s ") + option->short_name;
      if (!option->is_argument()) names += " -l " + option->name.substr(2);
      const std::string value = option->takes == Takes::nothing ? "" : offer(program, *option);
      if (!option->is_argument() || !value.empty())
        lines += line + names + value + " -d " + single_quoted(option->meaning) + "\n";
    }
  }
  return R"(# Completion of refraster for fish, made by `refraster list completions fish`.
function __refraster_command -d 'the command that the words before the cursor name'
  set -l path refraster
  set -l words (commandline -opc)
  set -e words[1]
  for word in $words
    switch "$path $word"
      case)" +
         commands +
         R"(
        set path "$path $word"
    end
  end
  echo $path
end
complete -c refraster -f
)" + lines;
}

} // namespace refraster
