// The house stands: includes go down the floors only, and no file grows beyond what can be read at a sitting.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::string_view floors[] = {"math", "shading", "raster", "io", "verify", "app"}; // from the ground up
constexpr int most_lines = 450;

std::optional<std::size_t> floor_of(std::string_view name) {
  const auto* found = std::find(std::begin(floors), std::end(floors), name);
  if (found == std::end(floors)) return std::nullopt;
  return static_cast<std::size_t>(found - std::begin(floors));
}

std::vector<fs::path> files_of_floor(std::string_view floor) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(REFRASTER_SOURCE_DIR) / floor)) {
    const std::string extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> lines_of(const fs::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// "raster" for `#include "raster/scene.h"`; the whole path where there is no folder.
std::optional<std::string> included_folder(const std::string& line) {
  static const std::regex include(R"rx(^\s*#\s*include\s*"([^"]+)")rx");
  std::smatch match;
  if (!std::regex_search(line, match, include)) return std::nullopt;
  const std::string path = match[1];
  return path.substr(0, path.find('/'));
}

/// What is wrong with an include of this folder from a file of this floor; empty if nothing is.
std::string objection(std::size_t from, const std::string& folder) {
  const auto to = floor_of(folder);
  if (!to) return "names no floor: include as \"floor/file.h\"";
  if (*to > from) return "goes up, from " + std::string(floors[from]) + " to " + folder;
  return {};
}

} // namespace

TEST_CASE("includes go down the floors only") {
  for (std::size_t floor = 0; floor < std::size(floors); ++floor) {
    const std::vector<fs::path> files = files_of_floor(floors[floor]);
    CHECK_MESSAGE(!files.empty(), floors[floor]);
    for (const fs::path& path : files) {
      int number = 0;
      for (const std::string& line : lines_of(path)) {
        ++number;
        const auto folder = included_folder(line);
        if (!folder) continue;
        const std::string wrong = objection(floor, *folder);
        CHECK_MESSAGE(wrong.empty(), path.string() << ":" << number << ": " << wrong);
      }
    }
  }
}

TEST_CASE("an include that goes up, or names no floor, is found") {
  const std::size_t raster = *floor_of("raster");
  const auto judged = [&](const std::string& line) { return objection(raster, included_folder(line).value()); };
  CHECK(judged("#include \"shading/light.h\"").empty());
  CHECK(judged("#include \"raster/scene.h\"").empty());
  CHECK_FALSE(judged("#include \"io/input_error.h\"").empty());
  CHECK_FALSE(judged("  #  include \"verify/gl/context.h\" // why").empty());
  CHECK_FALSE(judged("#include \"scene.h\"").empty());
  CHECK_FALSE(included_folder("#include <vector>"));
}

TEST_CASE("no file of the floors is longer than 450 lines") {
  for (const std::string_view floor : floors)
    for (const fs::path& path : files_of_floor(floor)) {
      const std::size_t lines = lines_of(path).size();
      CHECK_MESSAGE(lines <= most_lines, path.string() << " has " << lines << " lines");
    }
}

TEST_CASE("every header begins with #pragma once") {
  for (const std::string_view floor : floors)
    for (const fs::path& path : files_of_floor(floor)) {
      if (path.extension() != ".h") continue;
      const std::vector<std::string> lines = lines_of(path);
      CHECK_MESSAGE((!lines.empty() && lines.front() == "#pragma once"), path.string());
    }
}
