#include "app/options/unknown_words.h"

#include "app/options/old_names.h"
#include "io/file/nearest.h"

#include <algorithm>
#include <optional>

namespace refraster {
namespace {

using Words = std::vector<std::string>;

std::string quoted(const std::string& word) {
  return "\"" + word + "\"";
}

std::vector<std::string_view> names_of(const std::vector<Command>& commands) {
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  return names;
}

/// What `word` is called now, if that is one of the names.
std::optional<std::string> name_now(std::string_view word, const std::vector<std::string_view>& names) {
  for (const OldName& known : old_names)
    if (known.old_name == word && std::find(names.begin(), names.end(), known.name) != names.end())
      return std::string(known.name);
  return std::nullopt;
}

/// one_of, or the one that has the old name.
std::string expected_name(const std::string& word, const std::vector<std::string_view>& names) {
  if (const auto now = name_now(word, names)) return *now + ", as it is called now";
  return one_of(names, word);
}

bool has_option(const Command& command, const std::string& name) {
  for (const Option* const option : all_options(command))
    if (option->name == name || (option->short_name != 0 && name == std::string("-") + option->short_name)) return true;
  return false;
}

/// The first command below this one, itself included, that has the option; a null pointer if none has.
const Command* with_option(const Command& command, const std::string& name) {
  if (command.commands.empty()) return has_option(command, name) ? &command : nullptr;
  for (const Command& sub : command.commands)
    if (const Command* const found = with_option(sub, name)) return found;
  return nullptr;
}

/// Values that stand behind an option, or behind its '='; those after the first only as long as they are no options.
Words values_behind(const Option& option, const Words& words) {
  Words values;
  const auto add = [&](std::string_view text) {
    for (const std::string_view word : split(text, ' '))
      for (const std::string_view part : split(word, ','))
        if (!part.empty()) values.emplace_back(part);
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string with_equals = option.name + "=";
    if (words[i].starts_with(with_equals)) add(std::string_view(words[i]).substr(with_equals.size()));
    else if (words[i] != option.name && !(option.short_name != 0 && words[i] == std::string("-") + option.short_name))
      continue;
    for (++i; i < words.size() && !words[i].starts_with("--"); ++i) add(words[i]);
    break;
  }
  return values;
}

} // namespace

BareCommand missing_command(const CommandPath& path) {
  return {place_name(path), "nothing", one_of(names_of(path.back()->commands), "")};
}

UsageError unknown_command(const CommandPath& path, const std::string& word) {
  return {place_name(path), quoted(word), expected_name(word, names_of(path.back()->commands))};
}

UsageError unknown_option(const CommandPath& path, const std::string& word) {
  const Command& command = *path.back();
  const std::string name = word.substr(0, word.find('='));
  if (!command.commands.empty() && with_option(command, name))
    return {place_name(path), quoted(name), "a command before it, " + one_of(names_of(command.commands), "")};
  std::vector<std::string_view> names;
  for (const Option* const option : all_options(command))
    if (!option->is_argument()) names.push_back(option->name);
  return {place_name(path), quoted(name), expected_name(name, names)};
}

UsageError further_argument(const CommandPath& path, const std::string& word, const Words& words) {
  Words arguments;
  std::string hint;
  for (const Option* const option : all_options(*path.back())) {
    if (option->is_argument()) arguments.push_back(option->name);
    else if (hint.empty()) hint = hint_of_commas(*option, words);
  }
  std::string expected = "no argument";
  for (const std::string& argument : arguments) expected += (argument == arguments[0] ? " but " : " and ") + argument;
  return {place_name(path), quoted(word), expected + hint};
}

std::string hint_of_commas(const Option& option, const Words& words) {
  if (option.takes != Takes::values) return "";
  const Words values = values_behind(option, words);
  std::string text, right;
  for (std::size_t i = 0; i < values.size(); ++i) {
    text += (i == 0 ? "" : ",") + values[i];
    if (i > 0 && !option.read(text)) right = text; // the longest: further words may be other arguments
  }
  const bool is_given_so = std::find(words.begin(), words.end(), right) != words.end();
  return right.empty() || is_given_so ? "" : "; commas stand between values: " + option.name + " " + right;
}

} // namespace refraster
