// Pages of the manual, of every command.

#include "app/options/help.h"
#include "app/options/man_page.h"
#include "tests/support/text.h"
#include "tests/unit/app/shell.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

using namespace refraster;
using test::answer;
using test::installed;

namespace {

/// roff's names of characters, as a terminal shows them in ASCII and '…'.
std::string without_roff(std::string text) {
  const std::pair<std::string, std::string> names[] = {
      {"\\fB", ""},   {"\\fI", ""},   {"\\fR", ""},   {"\\&", ""},        {"\\-", "-"},
      {"\\(ga", "`"}, {"\\(ha", "^"}, {"\\(ti", "~"}, {"\\[u2026]", "…"}, {"\\e", "\\"}};
  for (const auto& [name, shown] : names)
    for (std::size_t at = 0; (at = text.find(name, at)) != std::string::npos; at += shown.size())
      text.replace(at, name.size(), shown);
  return text;
}

} // namespace

TEST_CASE("every command, option and note has its place in a page of the manual, which is ASCII") {
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    INFO(full_name(path));
    const std::string page = man_page(path);
    CHECK(
        std::all_of(page.begin(), page.end(), [](char byte) { return byte == '\n' || (byte >= ' ' && byte <= '~'); }));
    // What is to be typed can be copied: a plain '-' may be shown as a hyphen.
    CHECK(holds(page, "\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\n"));
    const std::string text = without_roff(page);
    CHECK(holds(text, "\n.B " + full_name(path) + "\n"));
    for (const Command& command : path.back()->commands)
      CHECK(holds(text, "\n.TP\n" + command.name + "\n" + sentence(command.meaning) + "\n"));
    for (const Option* const option : all_options(*path.back())) {
      INFO(option->name);
      const std::string name = option->is_argument() ? option->name : usage_of(*option);
      CHECK(holds(text, "\n.TP\n" + name + "\n" + sentence(meaning_with_default(*option)) + "\n"));
    }
    for (const std::string& note : path.back()->notes) CHECK(holds(text, "\n" + note + "\n"));
  }
}

TEST_CASE("groff has no complaint about any page") {
  if (!installed("groff")) return;
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    INFO(full_name(path));
    const test::Answer found = answer("groff -man -ww -z FILE", man_page(path));
    CHECK(found.exit_code == 0);
    CHECK(found.text == "");
  }
}

TEST_CASE("a formatted page says what the declarations say") {
  if (!installed("nroff")) return;
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    // -c and a wide line, without hyphens or stretched lines: words as they are declared.
    const test::Answer found =
        answer("cat FILE | GROFF_NO_SGR=1 nroff -man -Tutf8 -rLL=2000n -rHY=0 | col -bx", man_page(path));
    if (found.text.find("not found") != std::string::npos) {
      MESSAGE("skipped: there is no col");
      return;
    }
    const std::string text = in_one_line(found.text);
    INFO(full_name(path));
    for (const Option* const option : all_options(*path.back())) {
      INFO(option->name);
      CHECK(holds(text, in_one_line(sentence(meaning_with_default(*option)))));
    }
  }
}

TEST_CASE("mandoc finds nothing wrong but the date, which there is none of") {
  if (!installed("mandoc")) return;
  const Command program = refraster_command();
  for (const CommandPath& path : all_commands(program)) {
    INFO(full_name(path));
    const test::Answer found = answer("mandoc -T lint -W warning FILE", man_page(path));
    CHECK_MESSAGE(std::count(found.text.begin(), found.text.end(), '\n') == 1, found.text);
    CHECK_MESSAGE(holds(found.text, "missing date"), found.text);
  }
}

TEST_CASE("what roff would take for a request, or a character of its own, is text") {
  const Command command{.name = "x", .meaning = "Dots", .notes = {".png is what it is", "'quoted' a\\b ^ ~ ` …"}};
  const std::string page = man_page({&command});
  CHECK(holds(page, "\n\\&.png is what it is\n"));
  CHECK(holds(page, "\n\\&'quoted' a\\eb \\(ha \\(ti \\(ga \\[u2026]\n"));
}
