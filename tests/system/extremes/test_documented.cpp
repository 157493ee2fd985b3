// docs/extremes.md and the tests of the extremes agree.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The names of all test cases in tests/system/extremes that begin with a row, by row.
std::map<std::string, std::set<std::string>> tested_rows() {
  const std::regex test_case(R"re(TEST_CASE(?:_TEMPLATE)?\(\s*"(([A-Z][0-9]+): [^"]*)")re");
  std::map<std::string, std::set<std::string>> rows;
  for (const auto& entry : fs::directory_iterator(fs::path(REFRASTER_SOURCE_DIR) / "tests/system/extremes")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string source = text_of(entry.path());
    for (std::sregex_iterator it(source.begin(), source.end(), test_case), end; it != end; ++it)
      rows[(*it)[2]].insert((*it)[1]);
  }
  return rows;
}

/// The test names that the table of docs/extremes.md gives, in backticks in the last cell of a row.
std::map<std::string, std::set<std::string>> documented_rows() {
  const std::regex row(R"(\| ([A-Z][0-9]+) \|.*\| (`.*`) \|)"), name("`([^`]*)`");
  std::map<std::string, std::set<std::string>> rows;
  std::ifstream file(fs::path(REFRASTER_SOURCE_DIR) / "docs/extremes.md");
  REQUIRE(file);
  for (std::string line; std::getline(file, line);) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) continue;
    const std::string tests = match[2];
    for (std::sregex_iterator it(tests.begin(), tests.end(), name), end; it != end; ++it)
      rows[match[1]].insert((*it)[1]);
  }
  return rows;
}

} // namespace

TEST_CASE("every row of the extremes has a test of its name, and docs/extremes.md names it") {
  const std::pair<char, int> letters[] = {{'V', 15}, {'C', 10}, {'Z', 7}, {'I', 9}, {'N', 7}, {'S', 13}, {'M', 10}};
  const auto tested = tested_rows(), documented = documented_rows();
  std::size_t rows = 0;
  for (const auto& [letter, count] : letters)
    for (int number = 1; number <= count; ++number) {
      const std::string row = letter + std::to_string(number);
      CAPTURE(row);
      ++rows;
      CHECK(tested.count(row) == 1);
      CHECK(documented.count(row) == 1);
    }
  CHECK(tested.size() == rows);
  CHECK(documented.size() == rows);
  for (const auto& documented_row : documented) {
    const std::string& row = documented_row.first;
    CAPTURE(row);
    const auto in_sources = tested.find(row);
    REQUIRE(in_sources != tested.end());
    CHECK(documented_row.second == in_sources->second);
  }
  MESSAGE("rows of the extremes: " << rows);
}
