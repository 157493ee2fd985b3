// One type, one name: two types of one name in one namespace are undefined behaviour wherever both are linked (C++20,
// [basic.def.odr]), though no linker says so: the functions of a std::vector of either have the same symbols.

#include "tests/system/layering/source_tree.h"

#include <doctest/doctest.h>

#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace refraster::test;

namespace {

/// The types that a source defines in its namespaces, with their names; but for those of namespaces without a name.
/// Sources are formatted: what is in a namespace begins at the left, and the end of a namespace says its name.
std::vector<std::string> types_of(std::string_view text) {
  static const std::regex begin("^(inline )?namespace ([^{}]*?) ?\\{$"), end("^\\} // namespace.*"),
      type("^(?:struct|class|union|enum|enum class) (?:\\S+\\(\\d+\\) )?(\\w+)(?: final)?(?: :.*)? ?\\{.*$");
  std::vector<std::string> found, within;
  for (const std::string_view line : lines_of(text)) {
    if (line.empty() || line.front() == ' ') continue;
    std::match_results<std::string_view::const_iterator> match;
    if (std::regex_match(line.begin(), line.end(), match, begin)) within.push_back(match[2]);
    else if (std::regex_match(line.begin(), line.end(), match, end) && !within.empty()) within.pop_back();
    else if (std::regex_match(line.begin(), line.end(), match, type)) {
      std::string name;
      bool is_named = true;
      for (const std::string& each : within) name += each + "::", is_named = is_named && !each.empty();
      if (is_named) found.push_back(name + match[1].str());
    }
  }
  return found;
}

/// Names that stand in two files, with the files.
std::vector<std::string> twice_named(const std::vector<SourceFile>& files) {
  std::map<std::string, std::set<std::string>> places;
  for (const SourceFile& file : files)
    for (const std::string& type : types_of(file.text)) places[type].insert(file.name);
  std::vector<std::string> twice;
  for (const auto& [type, in] : places) {
    if (in.size() < 2) continue;
    twice.push_back(type);
    for (const std::string& name : in) twice.back() += " " + name;
  }
  return twice;
}

} // namespace

TEST_CASE("no two types have one name") {
  for (const std::string& type : twice_named(source_files({".h", ".cpp"}))) CHECK_MESSAGE(false, type);
}

TEST_CASE("two types of one name are found, in whatever order; those of other namespaces, or of none, are others") {
  const std::string in_one = "namespace a {\n\nstruct Twice {\n  int x;\n};\nclass Once final : public Other {\n};\n"
                             "struct Declared;\n} // namespace a\n";
  const std::string anonymous = "namespace a {\nnamespace {\n\nstruct Twice {\n};\n\n} // namespace\n"
                                "enum class Once { x };\n} // namespace a\n";
  const std::string elsewhere = "namespace b {\nenum class Twice { x };\n} // namespace b\n";
  CHECK(types_of(in_one) == std::vector<std::string>{"a::Twice", "a::Once"});
  CHECK(types_of(elsewhere) == std::vector<std::string>{"b::Twice"});
  CHECK(twice_named({{"1.h", in_one}, {"2.h", elsewhere}}).empty());
  CHECK(twice_named({{"1.h", in_one}, {"2.cpp", anonymous}}) == std::vector<std::string>{"a::Once 1.h 2.cpp"});
}
