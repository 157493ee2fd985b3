// What shells are told, of every command.

#include "app/options/completions/completions.h"
#include "tests/support/text.h"
#include "tests/unit/app/shell.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

using namespace refraster;
using test::answer;
using test::installed;

namespace {

using Words = std::vector<std::string>;

Words words_in(const std::string& line) {
  std::istringstream in(line);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool has(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// What a specification of zsh's _arguments says, cut at each ':' that no backslash is before.
Words parts_of(const std::string& specification) {
  Words parts(1);
  for (std::size_t i = 0; i < specification.size(); ++i) {
    if (specification[i] == ':') parts.emplace_back();
    else parts.back() += specification[i] == '\\' ? specification[++i] : specification[i];
  }
  return parts;
}

/// Command lines to complete, in the order that `check` takes the answers in.
struct Question {
  std::string line;
  Words expected; // all of them are offered
};

/// What must be offered: at each command its commands and options, at each option the words to choose from.
std::vector<Question> questions() {
  std::vector<Question> list;
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    Words commands, options;
    for (const Command& command : path.back()->commands) commands.push_back(command.name);
    if (!commands.empty()) list.push_back({full_name(path) + " ", commands});
    for (const Option* const option : all_options(*path.back())) {
      if (option->is_argument()) {
        if (!option->words.empty()) list.push_back({full_name(path) + " ", option->words});
        continue;
      }
      options.push_back(option->name);
      if (option->words.empty()) continue;
      list.push_back({full_name(path) + " " + option->name + " ", option->words});
    }
    list.push_back({full_name(path) + " --", options});
    for (const Option* const option : all_options(*path.back()))
      if (option->short_name != 0)
        list.push_back({full_name(path) + " -", {std::string("-") + option->short_name, option->name}});
  }
  return list;
}

/// answers: a line for each question.
void check(const std::vector<Question>& list, const std::string& answers) {
  std::istringstream lines(answers);
  std::string line;
  for (const Question& question : list) {
    REQUIRE_MESSAGE(std::getline(lines, line), answers);
    INFO(question.line << " offers " << line);
    const Words offered = words_in(line);
    for (const std::string& word : question.expected) CHECK_MESSAGE(has(offered, word), word);
  }
}

} // namespace

TEST_CASE("bash offers every command, option and word to choose from") {
  const std::vector<Question> list = questions();
  std::string script = bash_completions(refraster_command());
  script +=
      "try() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _refraster; echo \"${COMPREPLY[*]}\"; }\n";
  for (const Question& question : list)
    script += "try " + question.line + (question.line.ends_with(' ') ? "''" : "") + "\n";
  const test::Answer found = answer("bash FILE", script);
  CHECK(found.exit_code == 0);
  check(list, found.text);
}

TEST_CASE("bash goes on in a list after a comma, behind '=', and with a file where one is meant") {
  std::string script = bash_completions(refraster_command());
  script +=
      "try() { COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); _refraster; echo \"${COMPREPLY[*]}\"; }\n"
      "cd " REFRASTER_SOURCE_DIR "\n"
      "try refraster render --aov depth,n\n"
      "try refraster render --precision = fl\n"
      "try refraster render READ\n"
      "try refraster render --report READ\n"
      "try refraster bench --csv doc\n"
      "try refraster render --size ''\n"
      "try refraster mesh sphere RE\n";
  CHECK(answer("bash FILE", script).text == "depth,normal\nfloat\nREADME.md\nREADME.md\ndocs\n\n\n");
}

TEST_CASE("fish offers every command, option and word to choose from") {
  if (!installed("fish")) return;
  const std::vector<Question> list = questions();
  std::string script = fish_completions(refraster_command());
  // Before the tab, which a description follows.
  for (const Question& question : list)
    script += "echo (complete -C '" + question.line + "' | string replace -r '\\t.*' '')\n";
  const test::Answer found = answer("HOME=/nonexistent fish --no-config FILE", script);
  CHECK(found.exit_code == 0);
  check(list, found.text);
}

TEST_CASE("zsh is told every command and, in specifications of _arguments, every option") {
  if (!installed("zsh")) return;
  const Command program = refraster_command();
  std::string script = "compdef() { }\n" + zsh_completions(program) +
                       "_arguments() { print -rl -- \"$@\"; state=command; return 1 }\n"
                       "_describe() { print -rl -- $commands }\n";
  for (const CommandPath& path : all_commands(program)) {
    std::string name = "_" + full_name(path);
    std::replace(name.begin(), name.end(), ' ', '_');
    script += name + "; print end\n";
  }
  const test::Answer found = answer("zsh -f FILE", script);
  std::istringstream lines(found.text);
  for (const CommandPath& path : all_commands(program)) {
    Words told;
    for (std::string line; std::getline(lines, line) && line != "end";) told.push_back(line);
    INFO(full_name(path) << "\n" << found.text);
    for (const Command& command : path.back()->commands) CHECK(has(told, command.name + ":" + command.meaning));
    for (const Option* const option : all_options(*path.back())) {
      INFO(option->name);
      const auto is_told = [&](const std::string& option_name) {
        return std::any_of(told.begin(), told.end(), [&](const std::string& specification) {
          const Words parts = parts_of(specification);
          if (option->is_argument()) return parts.size() == 3 && parts[1] == option->name;
          const std::string group = parts[0].substr(parts[0].starts_with('(') ? parts[0].find(')') + 1 : 0);
          return group == option_name + "[" + option->meaning + "]" &&
                 parts.size() == (option->takes == Takes::nothing ? 1 : 3) &&
                 (option->takes == Takes::nothing || parts[1] == option->form) &&
                 (option->words.empty() || holds(parts[2], joined(option->words)));
        });
      };
      CHECK(is_told(option->name + (option->takes == Takes::nothing ? "" : "=")));
      if (option->short_name == 0) continue;
      CHECK(is_told(std::string("-") + option->short_name + (option->takes == Takes::nothing ? "" : "+")));
    }
  }
}

TEST_CASE("every shell finds its script well-formed") {
  const Command program = refraster_command();
  for (const Shell& shell : shells) {
    const std::string name(shell.name);
    if (!installed(name)) continue;
    const test::Answer found = answer(name + " -n FILE", shell.completions(program));
    INFO(name << ": " << found.text);
    CHECK(found.exit_code == 0);
    CHECK(found.text.empty());
    CHECK(answer(name + " -n FILE", shell.completions(program) + "\nif (").exit_code != 0); // what is not is told
  }
}
