// A comment that was cut by reflowing reads as if something were missing: a line ends within its sentence though the
// next word would have fitted, or clang-format has torn a statement in two to make room for what follows it.

#include "tests/system/layering/source_tree.h"

#include <doctest/doctest.h>

#include <cctype>
#include <optional>
#include <string_view>

namespace {

constexpr std::size_t column_limit = 120;
/// So much room is left where a word after the first edit of a full line has become shorter.
constexpr std::size_t spare_columns = 8;

std::size_t indent_of(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// A comment, where it stands alone in its line or behind code.
struct Comment {
  std::size_t column;        // of its slashes
  bool alone;                // in its line
  std::string_view slashes;  // "//" or "///"
  std::string_view sentence; // behind one blank; may begin with blanks where a table or a formula is set out
};

std::optional<Comment> comment_in(std::string_view line) {
  const std::size_t at = line.find("// ") != std::string_view::npos && line.find("/// ") != std::string_view::npos
                             ? line.find("/// ")
                             : line.find("// ");
  if (at == std::string_view::npos || line.substr(0, at).find('"') != std::string_view::npos) return std::nullopt;
  const std::size_t slashes = line[at + 2] == '/' ? 3 : 2;
  const std::string_view sentence = line.substr(at + slashes + 1);
  if (sentence.empty()) return std::nullopt;
  return Comment{at, indent_of(line) == at, line.substr(at, slashes), sentence};
}

bool ends_clause(std::string_view sentence) {
  return std::string_view(".:;!?").find(sentence.back()) != std::string_view::npos;
}

/// Whether the second line goes on with the first one's sentence, whose next word would have fitted.
bool cut_within(std::string_view first, std::string_view second) {
  const std::optional<Comment> a = comment_in(first), b = comment_in(second);
  if (!a || !b || !b->alone || a->column != b->column || a->slashes != b->slashes) return false;
  if (a->sentence.front() == ' ' || ends_clause(a->sentence)) return false;
  const char next = b->sentence.front();
  if (std::islower(static_cast<unsigned char>(next)) == 0 && next != '(') return false;
  const std::string_view word = b->sentence.substr(0, b->sentence.find(' '));
  return refraster::test::columns(first) + 1 + word.size() + spare_columns <= column_limit;
}

/// "Double3x3", or "else", and in the next line "    name; // a comment that is too long for both".
bool torn_statement(std::string_view first, std::string_view second) {
  const std::optional<Comment> comment = comment_in(second);
  if (!comment || comment->alone || indent_of(second) <= indent_of(first)) return false;
  const std::string_view code = second.substr(0, second.find_last_not_of(' ', comment->column - 1) + 1);
  const std::string_view type = first.substr(indent_of(first));
  if (!code.ends_with(';') || type.empty() || comment_in(first)) return false;
  const bool is_type =
      type.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_:<>, *&") ==
      std::string_view::npos;
  return is_type && type.back() != ',' && type.back() != ':';
}

/// The numbers of the lines, from 1, behind which something was cut off.
std::vector<std::size_t> cut_lines(const std::string& text) {
  const std::vector<std::string_view> lines = refraster::test::lines_of(text);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    if (cut_within(lines[i], lines[i + 1]) || torn_statement(lines[i], lines[i + 1])) result.push_back(i + 1);
  return result;
}

} // namespace

TEST_CASE("no comment was cut by reflowing") {
  const std::vector<refraster::test::SourceFile> files = refraster::test::source_files({".h", ".cpp"});
  CHECK(files.size() > 400);
  for (const refraster::test::SourceFile& file : files)
    for (const std::size_t line : cut_lines(file.text))
      FAIL_CHECK(file.name << ":" << line << ": the sentence goes on in the next line, and would have fitted here");
}

TEST_CASE("a comment that was cut is found; one that fills its lines, or sets something out, is none") {
  using Lines = std::vector<std::size_t>;
  CHECK(cut_lines("/// A line that ends\n/// before its time.\n") == Lines{1});
  CHECK(cut_lines("  // One, two,\n  // three.\n") == Lines{1});
  CHECK(cut_lines("int a; // what is\n       // meant\n") == Lines{1});
  CHECK(cut_lines("  Double3x3\n      name; // cofactors\n") == Lines{1});
  CHECK(cut_lines("  std::array<double, 3>\n      weight{}; // of each\n") == Lines{1});
  const std::string full = "// " + std::string(110, 'x') + "\n";
  CHECK(cut_lines(full + "// another\n").empty());
  CHECK(cut_lines("// A sentence.\n// another one, which begins small\n").empty());
  CHECK(cut_lines("// A sentence\n/// of another kind\n").empty());
  CHECK(cut_lines("//   table   a\n//   row     b\n").empty());
  CHECK(cut_lines("int a; // one\nint b; // two\n").empty());
  CHECK(cut_lines("  else\n    f(); // here\n") == Lines{1});
  CHECK(cut_lines("call(a,\n     b); // here\n").empty());
}
