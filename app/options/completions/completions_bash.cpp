#include "app/options/completions/completions.h"

namespace refraster {
namespace {

/// 'refraster render --output' | 'refraster render -o': a pattern of `case`.
std::string places(const CommandPath& path, const Option& option) {
  const std::string place = full_name(path) + " ";
  std::string text = shell_quoted(place + option.name);
  if (option.short_name != 0) text += " | " + shell_quoted(place + "-" + option.short_name);
  return text;
}

/// What completes a value, as assignments of the script.
std::string offer(const Command& program, const Option& option) {
  switch (option.completes) {
  case Completes::files:
    return "kind=files";
  case Completes::folders:
    return "kind=folders";
  case Completes::commands:
    return "words=" + shell_quoted(names_of_commands(program));
  case Completes::words: {
    std::string words;
    for (const std::string& word : option.words) words += (words.empty() ? "" : " ") + word;
    return std::string(option.takes == Takes::values ? "kind=list " : "") + "words=" + shell_quoted(words);
  }
  case Completes::nothing:
    break;
  }
  return "kind=nothing";
}

} // namespace

std::string bash_completions(const Command& program) {
  std::string commands, values, names;
  for (const CommandPath& path : all_commands(program)) {
    const std::string place = shell_quoted(full_name(path));
    if (path.size() > 1) commands += "      " + place + ") path=$step ;;\n";
    std::string words = names_of_commands(*path.back()), argument;
    for (const Option* const option : all_options(*path.back())) {
      if (option->is_argument()) {
        argument = offer(program, *option);
        continue;
      }
      words += (words.empty() ? "" : " ") + option->name;
      if (option->short_name != 0) words += std::string(" -") + option->short_name;
      if (option->takes != Takes::nothing)
        values += "    " + places(path, *option) + ") " + offer(program, *option) + " ;;\n";
    }
    names += "      " + place + ")\n        options=" + shell_quoted(words) + "\n";
    if (!argument.empty()) names += "        " + argument + "\n";
    names += "        ;;\n";
  }
  return R"(# Completion of refraster for bash, made by `refraster list completions bash`.
_refraster() {
  # Readline takes '=' for a word of its own.
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  if [[ $current == = ]]; then
    current=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  local path=refraster step i
  for ((i = 1; i < COMP_CWORD; i++)); do
    step="$path ${COMP_WORDS[i]}"
    case $step in
)" + commands +
         R"(    esac
  done
  local kind=none words= options= head=
  case "$path $before" in
)" + values +
         R"(  esac
  if [[ $kind == none && -z $words ]]; then
    case $path in
)" + names +
         R"(    esac
    [[ $current == -* ]] && kind=none words=
    words="$words $options"
  fi
  if [[ $kind == list && $current == *,* ]]; then
    head=${current%,*},
    current=${current##*,}
  fi
  COMPREPLY=($(compgen -P "$head" -W "$words" -- "$current"))
  local IFS=$'\n' # names of files may hold blanks
  case $kind in
    files) COMPREPLY+=($(compgen -f -- "$current")) ;;
    folders) COMPREPLY+=($(compgen -d -- "$current")) ;;
  esac
  [[ $kind == files || $kind == folders ]] && compopt -o filenames 2>/dev/null
  return 0
}
complete -F _refraster refraster
)";
}

} // namespace refraster
