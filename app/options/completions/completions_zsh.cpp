#include "app/options/completions/completions.h"

#include <algorithm>

namespace refraster {
namespace {

/// "refraster brdf info" is completed by the function _refraster_brdf_info.
std::string function_name(const CommandPath& path) {
  std::string name = "_" + full_name(path);
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// Within a specification of _arguments, where ':' and brackets have a meaning.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (letter == ':' || letter == '[' || letter == ']' || letter == '\\') result += '\\';
    result += letter;
  }
  return result;
}

/// ":FILE:_files", what completes a value.
std::string offer(const Command& program, const Option& option) {
  const std::string message = ":" + escaped(option.is_argument() ? option.name : option.form) + ":";
  switch (option.completes) {
  case Completes::files:
    return message + "_files";
  case Completes::folders:
    return message + "_files -/";
  case Completes::commands:
    return message + "(" + names_of_commands(program) + ")";
  case Completes::words: {
    std::string words;
    for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + word;
    if (option.takes == Takes::values) return message + "_values -s , word " + words;
    return message + "(" + words + ")";
  }
  case Completes::nothing:
    break;
  }
  return message + " ";
}

/// One specification of _arguments a line.
std::string specifications(const Command& program, const Command& command) {
  std::string lines;
  const auto add = [&](const std::string& text) { lines += " \\\n    " + shell_quoted(text); };
  for (const Option* const option : all_options(command)) {
    if (option->is_argument()) {
      add((option->occurs == Occurs::repeatedly ? "*" : "") + offer(program, *option));
      continue;
    }
    const bool has_value = option->takes != Takes::nothing;
    const std::string meaning = "[" + escaped(option->meaning) + "]" + (has_value ? offer(program, *option) : "");
    const std::string short_name = std::string("-") + option->short_name;
    // Who has written one of the names is offered the other no more.
    const std::string others = option->short_name == 0 ? "" : "(" + short_name + " " + option->name + ")";
    if (option->short_name != 0) add(others + short_name + (has_value ? "+" : "") + meaning);
    add(others + option->name + (has_value ? "=" : "") + meaning);
  }
  return lines;
}

/// Of a command that does something.
std::string function_of(const Command& program, const CommandPath& path) {
  return function_name(path) + "() {\n  _arguments -s" + specifications(program, *path.back()) + "\n}\n";
}

/// Of a command that others follow.
std::string function_of_group(const Command& program, const CommandPath& path) {
  std::string names, cases;
  for (const Command& sub : path.back()->commands) {
    CommandPath longer = path;
    longer.push_back(&sub);
    names += "\n    " + shell_quoted(escaped(sub.name) + ":" + sub.meaning);
    cases += "\n    " + sub.name + ") " + function_name(longer) + " ;;";
  }
  return function_name(path) + R"(() {
  local curcontext=$curcontext state state_descr line
  typeset -A opt_args
  local -a commands=()" +
         names + R"(
  )
  _arguments -C)" +
         specifications(program, *path.back()) + R"( \
    '1: :->command' '*:: :->words' && return
  if [[ $state == command ]]; then
    _describe command commands
    return
  fi
  case $line[1] in)" +
         cases + R"(
  esac
}
)";
}

} // namespace

std::string zsh_completions(const Command& program) {
  std::string text =
      "#compdef refraster\n# Completion of refraster for zsh, made by `refraster list completions zsh`.\n";
  for (const CommandPath& path : all_commands(program))
    text += path.back()->commands.empty() ? function_of(program, path) : function_of_group(program, path);
  // Either loaded by the first completion, which is to be answered, or sourced.
  return text + R"(if [[ $funcstack[1] == _refraster ]]; then
  _refraster "$@"
else
  compdef _refraster refraster
fi
)";
}

} // namespace refraster
