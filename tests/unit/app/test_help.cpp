// The help of every command, at every width.

#include "app/options/help.h"
#include "app/options/wrap.h"
#include "tests/support/random.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <sstream>

using namespace refraster;

namespace {

/// The words with one blank between them.
} // namespace

TEST_CASE("every command, option, default and note is in the help, whole, at any width") {
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program))
    for (const int width : {40, 59, 60, 80, 120}) {
      INFO(full_name(path) << " in " << width << " columns");
      const std::string help = in_one_line(help_text(path, width));
      CHECK(holds(help, synopsis(path)));
      for (const Command& command : path.back()->commands)
        CHECK(holds(help, " " + command.name + " " + command.meaning + " "));
      for (const Option* const option : all_options(*path.back())) {
        INFO(option->name);
        CHECK(holds(help, usage_of(*option) + " " + meaning_with_default(*option)));
        if (!option->default_text.empty()) CHECK(holds(help, "(default " + option->default_text + ")"));
      }
      for (const std::string& note : path.back()->notes) CHECK(holds(help, note));
    }
}

TEST_CASE("no line of help is wider than the terminal, unless one word alone is, and none ends in a blank") {
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program))
    for (int width = 40; width <= 120; ++width) {
      std::istringstream lines(help_text(path, width));
      for (std::string line; std::getline(lines, line);) {
        INFO(full_name(path) << " in " << width << " columns: " << line);
        const bool one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;
        CHECK((columns_of(line) <= width || one_word));
        CHECK_FALSE(line.ends_with(' '));
      }
    }
}

TEST_CASE("a wrapped text is the same words in lines that are as full as they can be") {
  Random random(6);
  for (int trial = 0; trial < 500; ++trial) {
    std::string text;
    for (int word = random.below(30); word > 0; --word) {
      for (int letter = 1 + random.below(12); letter > 0; --letter) text += random.below(5) == 0 ? "é" : "n";
      text += random.below(4) == 0 ? "  " : " ";
    }
    const int width = 5 + random.below(30);
    const std::vector<std::string> lines = wrapped(text, width);
    std::string joined;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      joined += lines[i] + "\n";
      CHECK((columns_of(lines[i]) <= width || lines[i].find(' ') == std::string::npos));
      if (i == 0) continue;
      const std::string first_word = lines[i].substr(0, lines[i].find(' '));
      CHECK(columns_of(lines[i - 1]) + 1 + columns_of(first_word) > width);
    }
    CHECK(in_one_line(joined) == in_one_line(text));
  }
}

TEST_CASE("columns are characters, not bytes") {
  CHECK(columns_of("") == 0);
  CHECK(columns_of("N,…") == 3);
  CHECK(columns_of("mesh²") == 5);
}

TEST_CASE("the width is what COLUMNS says, within bounds; without it, off a terminal, 80") {
  const char* const before = std::getenv("COLUMNS");
  const std::string restored = before == nullptr ? "" : before;
  const auto width = [](const char* columns) {
    setenv("COLUMNS", columns, 1);
    return terminal_width(-1);
  };
  CHECK(width("100") == 100);
  CHECK(width("20") == 40);
  CHECK(width("400") == 120);
  for (const char* const nothing : {"", "0", "-5", "wide", "99999999999999"}) CHECK(width(nothing) == 80);
  unsetenv("COLUMNS");
  CHECK(terminal_width(-1) == 80);
  if (before != nullptr) setenv("COLUMNS", restored.c_str(), 1);
}
