// Laws that every declared option keeps, and what the parser makes of any of them.

#include "app/options/old_names.h"
#include "app/options/parse.h"
#include "app/usage_error.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

using namespace refraster;

namespace {

using Words = std::vector<std::string>;

/// The words that name a command.
Words words_of(const CommandPath& path) {
  Words words;
  for (std::size_t i = 1; i < path.size(); ++i) words.push_back(path[i]->name);
  return words;
}

/// What is said of these words; "" if nothing is wrong.
std::string said_of(const Words& words) {
  const Command program = refraster_command();
  try {
    action_of(named_command(program, words));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

std::string said_of(const CommandPath& path, const Words& more) {
  Words words = words_of(path);
  words.insert(words.end(), more.begin(), more.end());
  return said_of(words);
}

/// Calls use(path, option) for all of the program.
void for_each_option(auto&& use) {
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program))
    for (const Option* const option : all_options(*path.back())) use(path, *option);
}

} // namespace

TEST_CASE("every command and option is declared in full") {
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    const Command& command = *path.back();
    INFO(full_name(path));
    CHECK_FALSE(command.meaning.empty());
    CHECK_FALSE(command.meaning.ends_with('.'));
    CHECK(command.commands.empty() == static_cast<bool>(command.finish));
    std::set<std::string> names;
    for (const Option* const option : all_options(command)) {
      INFO(option->name);
      CHECK(names.insert(option->name).second);
      if (option->short_name != 0) CHECK(names.insert(std::string("-") + option->short_name).second);
      CHECK_FALSE(option->meaning.empty());
      CHECK_FALSE(option->meaning.ends_with('.'));
      CHECK(option->read);
      CHECK((option->is_argument() || option->form.empty() == (option->takes == Takes::nothing)));
      CHECK(option->words.empty() == (option->completes != Completes::words));
    }
  }
}

TEST_CASE("an option of the same name is the same in every command: its form, or its place among others") {
  std::set<std::string> short_names;
  for_each_option([&](const CommandPath&, const Option& option) {
    if (option.short_name != 0) short_names.insert(std::string(1, option.short_name) + option.name);
  });
  CHECK(short_names == std::set<std::string>{"h--help", "o--output", "q--quiet"});
}

TEST_CASE("the default that the help states is accepted, where it is a value") {
  for_each_option([](const CommandPath& path, const Option& option) {
    if (option.default_text.empty() || holds(option.default_text, " ")) return;
    INFO(full_name(path) << " " << option.name << " " << option.default_text);
    CHECK_FALSE(option.read(option.default_text));
  });
}

TEST_CASE("every word to choose from is accepted, and one with a letter twice is told with the one that is meant") {
  for_each_option([](const CommandPath& path, const Option& option) {
    for (const std::string& word : option.words) {
      INFO(full_name(path) << " " << option.name << " " << word);
      CHECK_FALSE(option.read(word));
      if (word[0] >= '0' && word[0] <= '9') continue; // 11 may be 1 or 16
      const auto fault = option.read(word.substr(0, 1) + word);
      REQUIRE(fault);
      CHECK(fault->expected.ends_with("; did you mean " + word + "?"));
      for (const std::string& other : option.words) CHECK(holds(fault->expected, other));
    }
  });
}

TEST_CASE("every option and command with a letter twice is told with the one that is meant") {
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    for (const Option* const option : all_options(*path.back())) {
      if (option->is_argument() || option->name.size() == 3) continue; // of "--k" all two letters are as near
      const std::string slip = option->name.substr(0, 3) + option->name.substr(2);
      INFO(full_name(path) << " " << slip);
      CHECK(holds(said_of(path, {slip}), "found \"" + slip + "\", "));
      CHECK(holds(said_of(path, {slip}), "; did you mean " + option->name + "?"));
    }
    for (const Command& command : path.back()->commands) {
      const std::string said = said_of(path, {command.name + command.name.back()});
      CHECK(holds(said, "; did you mean " + command.name + "?"));
      for (const Command& other : path.back()->commands) CHECK(holds(said, other.name));
    }
  }
}

TEST_CASE("an old name is told with the one that it has now, wherever that is known, and stands for nothing") {
  const Command program = refraster_command();
  for (const OldName& known : old_names) {
    const std::string word(known.old_name), name(known.name);
    int places = 0;
    for (const CommandPath& path : all_commands(program)) {
      Words words;
      for (const Command& command : path.back()->commands) words.push_back(command.name);
      for (const Option* const option : all_options(*path.back())) words.push_back(option->name);
      INFO(full_name(path) << " " << word);
      CHECK(std::find(words.begin(), words.end(), word) == words.end());
      if (std::find(words.begin(), words.end(), name) == words.end()) continue;
      ++places;
      CHECK(holds(said_of(path, {word}), "found \"" + word + "\", expected " + name + ", as it is called now"));
      if (word[0] == '-') CHECK(holds(said_of(path, {"a", word + "=b"}), name + ", as it is called now"));
      if (word[0] == '-') CHECK(holds(said_of(path, {word, "b"}), name + ", as it is called now"));
    }
    CHECK(places > 0);
  }
}

TEST_CASE("an option without its value, given twice, or a flag with a value, is named") {
  for_each_option([](const CommandPath& path, const Option& option) {
    if (option.is_argument() || !path.back()->commands.empty()) return;
    if (option.name == "--help" || option.name == "--version") return; // which are answered before all else
    INFO(full_name(path) << " " << option.name);
    if (option.takes == Takes::nothing) {
      CHECK(said_of(path, {option.name + "=much"}) == option.name + ": found \"much\", expected no value");
      return;
    }
    CHECK(said_of(path, {option.name}) == option.name + ": found nothing, expected " + option.form);
    const std::string twice = said_of(path, {option.name + "=a", option.name, "b"});
    CHECK(holds(twice, "found \"a\"")); // by itself, or beside "b"
    if (option.short_name == 0) return;
    const std::string short_name = std::string("-") + option.short_name;
    CHECK(said_of(path, {short_name}) == option.name + ": found nothing, expected " + option.form);
  });
}

TEST_CASE("a required argument that is missing is named with its meaning, one too many is named itself") {
  for_each_option([](const CommandPath& path, const Option& option) {
    if (option.occurs != Occurs::once) return;
    INFO(full_name(path) << " " << option.name);
    CHECK(holds(said_of(path, {}), "found nothing, expected "));
    if (option.completes == Completes::words) return;
    const auto options = all_options(*path.back());
    if (std::any_of(options.begin(), options.end(), [](const Option* const other) {
          return other->is_argument() && other->occurs == Occurs::repeatedly;
        }))
      return;
    Words words;
    for (const Option* const other : options)
      if (other->occurs == Occurs::once || (other->is_argument() && other->occurs == Occurs::at_most_once))
        words.push_back(other->is_argument()   ? "1" // a file's name, or a number
                        : other->words.empty() ? other->name + "=1"
                                               : other->name + "=" + other->words.front());
    words.emplace_back("one-more");
    CHECK(holds(said_of(path, words), "found \"one-more\", expected no argument but "));
  });
}

TEST_CASE("a command line in the documentation names commands and options that there are") {
  const Command program = refraster_command();
  const std::filesystem::path root = REFRASTER_SOURCE_DIR;
  std::vector<std::filesystem::path> pages = {root / "README.md", root / "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") pages.push_back(entry.path());
  // From the program's name to the end of the line, or of the `code`; a line of options alone belongs to it.
  const std::regex command_line(R"(\brefraster ((?:[a-z][a-z-]*\b ?)+)([^`\n]*(?:\n {8,}\[[^`\n]*)*))"),
      name(R"(--[a-z][a-z0-9-]*)");
  int found = 0;
  for (const std::filesystem::path& page : pages) {
    std::ifstream file(page);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    for (std::sregex_iterator line(text.begin(), text.end(), command_line), end; line != end; ++line) {
      Words words;
      std::istringstream in(line->str(1));
      for (std::string word; in >> word;) words.push_back(word);
      const NamedCommand named = named_command(program, words);
      if (named.path.size() < 2) continue; // a sentence about the program
      const std::string rest = line->str(2);
      for (std::sregex_iterator it(rest.begin(), rest.end(), name); it != end; ++it, ++found) {
        const std::vector<const Option*> options = all_options(*named.path.back());
        INFO(page << ": " << line->str());
        CHECK_MESSAGE(std::any_of(options.begin(), options.end(),
                                  [&](const Option* option) { return option->name == it->str(); }),
                      it->str());
      }
    }
  }
  CHECK(found > 30);
}

TEST_CASE("what stands for a number, or a list, reads no more than that") {
  int number = 3;
  const Option option = number_option("--count", number, Range{1, 5}, "so many");
  CHECK(option.form == "1..5");
  CHECK(option.default_text == "3");
  CHECK_FALSE(option.read("5"));
  CHECK(number == 5);
  for (const char* const wrong : {"0", "6", "", "5x", " 5", "+5", "5.0", "nan"}) CHECK(option.read(wrong));
  CHECK(number == 5);
  Words chosen;
  const Words known = {"a", "b"};
  const auto use = [&](const std::vector<std::size_t>& indices) {
    for (const std::size_t i : indices) chosen.push_back(known[i]);
  };
  const Option list = word_list_option("-l,--list", "X,…", known, use, "some");
  CHECK(list.short_name == 'l');
  CHECK_FALSE(list.read("b,a"));
  CHECK(chosen == Words{"b", "a"});
  for (const char* const wrong : {"", "a,", "a,a", "a b", "c"}) CHECK(list.read(wrong));
}
