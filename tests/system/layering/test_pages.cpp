// Pages are as wide as code: 120 columns, but for tables, code, images, what a program writes between two comments, and
// what has no blank to break at.

#include "tests/system/layering/source_tree.h"

#include <doctest/doctest.h>

namespace {

constexpr std::size_t column_limit = 120;

/// Whether a line could be broken within the limit: a blank stands there behind its first word, that of a list aside.
bool has_a_break(std::string_view line) {
  std::size_t at = line.find_first_not_of(" ->*#0123456789.");
  if (at == std::string_view::npos) return false;
  at = line.find(' ', at);
  return at != std::string_view::npos && at < line.size() - 1;
}

/// The numbers of the lines, from 1, that are too wide.
std::vector<std::size_t> wide_lines(const std::string& text) {
  std::vector<std::size_t> result;
  std::size_t number = 0;
  bool in_code = false, is_written = false;
  for (const std::string_view line : refraster::test::lines_of(text)) {
    ++number;
    const std::string_view content = line.substr(std::min(line.find_first_not_of(' '), line.size()));
    if (content.starts_with("```")) in_code = !in_code;
    if (content.starts_with("<!--")) is_written = content != "<!-- end -->";
    if (in_code || is_written || content.starts_with("![") || content.starts_with("|") || content.starts_with("<") ||
        line.starts_with("    "))
      continue;
    if (refraster::test::columns(line) > column_limit && has_a_break(line)) result.push_back(number);
  }
  return result;
}

} // namespace

TEST_CASE("no line of a page is wider than 120 columns, but for tables and code") {
  const std::vector<refraster::test::SourceFile> files = refraster::test::source_files({".md"});
  CHECK(files.size() > 15);
  for (const refraster::test::SourceFile& file : files) {
    for (const std::size_t line : wide_lines(file.text)) FAIL_CHECK(file.name << ":" << line << ": wider than 120");
  }
}

TEST_CASE("a wide line of a page is found; tables, code and what cannot be broken may be wide") {
  using Lines = std::vector<std::size_t>;
  std::string words;
  for (int i = 0; i < 30; ++i) words += "word ";
  words += "end\n";
  CHECK(wide_lines(words) == Lines{1});
  CHECK(wide_lines("short\n- " + words) == Lines{2});
  CHECK(wide_lines("| " + words + "```\n" + words + "```\n    " + words).empty());
  CHECK(wide_lines("<!-- program -->\n" + words + "<!-- end -->\n" + words) == Lines{4});
  CHECK(wide_lines("- " + std::string(200, 'x') + "\n").empty());
  std::string umlauts;
  for (int i = 0; i < 20; ++i) umlauts += "ü·²→ "; // 100 characters in more bytes
  CHECK(wide_lines(umlauts + "\n").empty());
}
