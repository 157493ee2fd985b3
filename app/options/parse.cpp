#include "app/options/parse.h"

#include "app/options/help.h"
#include "app/options/unknown_words.h"
#include "app/options/wrap.h"
#include "app/usage_error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

#include <unistd.h>

namespace refraster {
namespace {

using Words = std::vector<std::string>;

std::string quoted(const std::string& word) {
  return "\"" + word + "\"";
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-';
}

/// For what takes precedence over everything else: before commands, too.
bool is_help(const std::string& word) {
  return word == "--help" || word == "-h" || word == "--version";
}

Action printing(const std::string& text) {
  return [text] {
    std::cout << text;
    return ExitCode::ok;
  };
}

Action printing_help(const CommandPath& path) {
  return printing(help_text(path, terminal_width(STDOUT_FILENO)));
}

/// What CLI11 makes of the words: which option was given which texts, in the order of all_options, and what is left.
struct Sorted {
  std::vector<Words> given;
  Words unknown_options, further_arguments;
};

Sorted sorted(const std::vector<const Option*>& options, const NamedCommand& named) {
  CLI::App parser;
  parser.set_help_flag();
  parser.allow_extras();
  std::vector<CLI::Option*> known;
  for (const Option* const option : options) {
    std::string names = option->name;
    if (option->short_name != 0) names = std::string("-") + option->short_name + "," + names;
    if (option->takes == Takes::nothing) {
      known.push_back(parser.add_flag(names));
      continue;
    }
    CLI::Option* const added = parser.add_option(names, [](const CLI::results_t&) { return true; });
    // An option is given once more for each further value: the words behind its first are arguments.
    if (option->occurs == Occurs::repeatedly && option->is_argument()) added->expected(-1);
    added->multi_option_policy(CLI::MultiOptionPolicy::TakeAll); // one too many is reported here
    known.push_back(added);
  }
  try {
    parser.parse(Words(named.rest.rbegin(), named.rest.rend())); // which takes them from the end
  } catch (const CLI::ArgumentMismatch&) {
    // Words ran out behind an option: the last word is its name, or short names of which it is the last.
    const std::string& last = named.rest.back();
    const bool is_cluster = is_option(last) && last[1] != '-';
    for (const Option* const option : options)
      if (option->takes != Takes::nothing &&
          (last == option->name || (is_cluster && last.back() == option->short_name)))
        throw UsageError(option->name, "nothing", option->form);
    throw UsageError(place_name(named.path), "found " + quoted(last) + ", which lacks its value");
  } catch (const CLI::ParseError& error) {
    throw UsageError(place_name(named.path), error.what());
  }
  Sorted result;
  for (const CLI::Option* const option : known) result.given.push_back(option->results());
  for (const std::string& word : parser.remaining())
    if (word != "--") (is_option(word) ? result.unknown_options : result.further_arguments).push_back(word);
  return result;
}

/// "-quiet" is not told as "-uiet", which is what is left of it behind -q.
std::string as_written(const std::string& left, const Words& words) {
  for (const std::string& word : words)
    if (word.size() > left.size() && word[0] == '-' && word[1] != '-' && word.ends_with(left.substr(1))) return word;
  return left;
}

void read(const Option& option, const Words& texts, const Words& words) {
  if (option.takes == Takes::nothing) {
    // --quiet=false is no flag, --quiet=very is nothing.
    for (const std::string& text : texts)
      if (text != "true" && text != "false") throw UsageError(option.name, quoted(text), "no value");
    if (!texts.empty() && texts.back() == "true") option.read("");
    return;
  }
  if (option.occurs != Occurs::repeatedly && texts.size() > 1)
    throw UsageError(option.name, quoted(texts[0]) + " and " + quoted(texts[1]), "one of the two");
  for (const std::string& text : texts)
    if (const std::optional<ValueFault> fault = option.read(text))
      throw UsageError(option.name, quoted(fault->found.empty() ? text : fault->found),
                       fault->expected + hint_of_commas(option, words));
}

} // namespace

NamedCommand named_command(const Command& program, const Words& words) {
  NamedCommand named{{&program}, {}};
  auto word = words.begin();
  for (; word != words.end() && !named.path.back()->commands.empty(); ++word) {
    if (is_help(*word)) {
      named.rest.push_back(*word);
      continue;
    }
    const std::vector<Command>& commands = named.path.back()->commands;
    const auto found =
        std::find_if(commands.begin(), commands.end(), [&](const Command& command) { return command.name == *word; });
    if (found == commands.end()) break;
    named.path.push_back(&*found);
  }
  named.rest.insert(named.rest.end(), word, words.end());
  return named;
}

Action action_of(const NamedCommand& named) {
  const Command& command = *named.path.back();
  if (!command.commands.empty()) {
    if (named.rest.empty()) throw missing_command(named.path);
    if (named.rest[0] == "--version") return printing(version_text() + "\n");
    if (is_help(named.rest[0])) return printing_help(named.path);
    throw is_option(named.rest[0]) ? unknown_option(named.path, named.rest[0])
                                   : unknown_command(named.path, named.rest[0]);
  }
  const std::vector<const Option*> options = all_options(command);
  const Sorted words = sorted(options, named);
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (words.given[i].empty()) continue;
    if (options[i]->name == "--help") return printing_help(named.path);
    if (options[i]->name == "--version") return printing(version_text() + "\n");
  }
  if (!words.unknown_options.empty())
    throw unknown_option(named.path, as_written(words.unknown_options[0], named.rest));
  for (std::size_t i = 0; i < options.size(); ++i) read(*options[i], words.given[i], named.rest);
  if (!words.further_arguments.empty()) throw further_argument(named.path, words.further_arguments[0], named.rest);
  for (std::size_t i = 0; i < options.size(); ++i)
    if (options[i]->occurs == Occurs::once && words.given[i].empty())
      throw UsageError(place_name(named.path), "nothing", options[i]->name + " (" + options[i]->meaning + ")");
  return command.finish();
}

} // namespace refraster
