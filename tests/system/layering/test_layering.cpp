// The rooms of the code base: includes go down the layers only, and no file or folder grows beyond what is read at
// once.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

constexpr std::string_view layers[] = {"math",   "shading", "scene", "raster", "io",     "gl", "verify",
                                       "scenes", "brdf",    "bench", "suite",  "python", "app"}; // from the ground up
// The halves of a frame, in this order; what lies beside them is below them all, but for the frame itself.
constexpr std::string_view halves[] = {"raster/vertex/", "raster/visibility/", "raster/shadow/", "raster/shade/",
                                       "raster/explain/"};
// Programs beside the measuring library: on top of everything, as tests are.
constexpr std::string_view programs[] = {"bench/guard/",     "bench/merl_ladder/", "bench/micro/", "bench/obj_reader/",
                                         "bench/precision/", "bench/shadows/",     "bench/suite/"};
constexpr std::string_view shared_by_tests[] = {"tests/support/"};
constexpr int max_lines = 450, max_files = 24;

/// Where in the list the layer of this name stands.
template <class List>
std::optional<std::size_t> index_in(const List& list, std::string_view name) {
  const auto* found = std::find(std::begin(list), std::end(list), name);
  if (found == std::end(list)) return std::nullopt;
  return static_cast<std::size_t>(found - std::begin(list));
}

/// The first of these that the path begins with.
template <class List>
std::optional<std::size_t> prefix_in(const List& list, std::string_view path) {
  for (std::size_t i = 0; i < std::size(list); ++i)
    if (path.substr(0, list[i].size()) == list[i]) return i;
  return std::nullopt;
}

/// Paths from the root of all headers and sources below a folder.
std::vector<std::string> files_of(std::string_view folder) {
  const fs::path root = REFRASTER_SOURCE_DIR;
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
    const std::string extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp") files.push_back(entry.path().lexically_relative(root));
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> all_files() {
  std::vector<std::string> files = files_of("tests");
  for (std::string& file : files_of("include")) files.push_back(std::move(file));
  for (const std::string_view layer : layers)
    for (std::string& file : files_of(layer)) files.push_back(std::move(file));
  return files;
}

std::vector<std::string> lines_of(const std::string& path) {
  std::ifstream file(fs::path(REFRASTER_SOURCE_DIR) / path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// "io/file/text.h" for `#include "io/file/text.h"`.
std::optional<std::string> included(const std::string& line) {
  static const std::regex include(R"rx(^\s*#\s*include\s*"([^"]+)")rx");
  std::smatch match;
  if (!std::regex_search(line, match, include)) return std::nullopt;
  return match[1];
}

std::string folder_of(std::string_view path) {
  return std::string(path.substr(0, path.rfind('/') + 1));
}

/// "raster" of "raster/visibility/bin.h"; everything where there is no folder.
std::string_view layer_of(std::string_view path) {
  return path.substr(0, path.find('/'));
}

bool is_test(std::string_view path) {
  return layer_of(path) == "tests";
}

/// What is wrong with this include in a test, which may include every layer, tests/support and its own folder.
std::string objection_to_test(std::string_view file, std::string_view header) {
  if (prefix_in(shared_by_tests, header) || folder_of(header) == folder_of(file)) return {};
  return "is neither the test's own nor in tests/support";
}

/// What is wrong with an include of this header in this file; empty if nothing is.
std::string objection(std::string_view file, std::string_view header) {
  if (layer_of(file) == "include") return "is not public: <refraster/...>, the standard library and GLM are";
  if (header.find('/') == std::string_view::npos) return "names no layer: include as \"layer/file.h\"";
  const bool test = is_test(file), program = prefix_in(programs, file).has_value();
  if (is_test(header)) {
    if (!test && !program) return "is a test's";
    return objection_to_test(file, header);
  }
  const auto to = index_in(layers, layer_of(header));
  if (!to) return "names no layer";
  if (test) return {};
  const auto used_program = prefix_in(programs, header);
  if (used_program && folder_of(file) != folder_of(header)) return "is of a program beside the library";
  if (layer_of(header) == "python" && layer_of(file) != "python") return "is the Python module's, which nothing needs";
  const auto from = index_in(layers, layer_of(file));
  if (!program && *to > *from)
    return "goes up, from " + std::string(layer_of(file)) + " to " + std::string(layers[*to]);
  const auto half = prefix_in(halves, file), other_half = prefix_in(halves, header);
  if (half && other_half && *other_half > *half)
    return "goes up within the frame, to " + std::string(halves[*other_half]);
  return {};
}

} // namespace

TEST_CASE("includes go down the layers only") {
  for (const std::string_view layer : layers) CHECK_MESSAGE(!files_of(layer).empty(), layer);
  for (const std::string& path : all_files()) {
    if (path.find("tests/system/package/") == 0) continue; // sees what is installed
    int number = 0;
    for (const std::string& line : lines_of(path)) {
      ++number;
      const auto header = included(line);
      if (!header || !fs::exists(fs::path(REFRASTER_SOURCE_DIR) / *header)) continue; // made by the build
      const std::string wrong = objection(path, *header);
      CHECK_MESSAGE(wrong.empty(), path << ":" << number << ": " << *header << " " << wrong);
    }
  }
}

TEST_CASE("an include that goes up, or names no layer, is found") {
  const auto judged = [](std::string_view file, const std::string& line) {
    return objection(file, included(line).value());
  };
  CHECK(judged("raster/samples.h", "#include \"shading/light.h\"").empty());
  CHECK(judged("raster/shade/attribute_setup.h", "#include \"raster/visibility/bin.h\"").empty());
  CHECK(judged("bench/precision/inputs.h", "#include \"tests/support/random.h\"").empty());
  CHECK(judged("tests/unit/io/test_text.cpp", "#include \"app/output.h\"").empty());
  CHECK_FALSE(judged("raster/samples.h", "#include \"io/file/text.h\"").empty());
  CHECK_FALSE(judged("raster/samples.h", "  #  include \"gl/context/context.h\" // why").empty());
  CHECK_FALSE(judged("raster/samples.h", "#include \"scene.h\"").empty());
  CHECK_FALSE(judged("raster/visibility/bin.h", "#include \"raster/shade/attribute_setup.h\"").empty());
  CHECK_FALSE(judged("include/refraster/scene.h", "#include \"shading/light.h\"").empty());
  CHECK_FALSE(judged("bench/measure/scaling.h", "#include \"tests/support/random.h\"").empty());
  CHECK_FALSE(judged("bench/measure/scaling.h", "#include \"bench/precision/inputs.h\"").empty());
  CHECK_FALSE(judged("bench/measure/scaling.h", "#include \"app/output.h\"").empty());
  CHECK(judged("python/reports.cpp", "#include \"bench/report/report_json.h\"").empty());
  CHECK_FALSE(judged("python/reports.cpp", "#include \"app/output.h\"").empty());
  CHECK_FALSE(judged("app/output.cpp", "#include \"python/work.h\"").empty());
  CHECK_FALSE(judged("tests/unit/io/test_text.cpp", "#include \"tests/unit/math/accuracy.h\"").empty());
  CHECK_FALSE(included("#include <vector>"));
}

TEST_CASE("public headers include each other, the standard library and GLM, and are about ten") {
  static const std::regex include(R"rx(^\s*#\s*include\s*<([^>]+)>)rx");
  int headers = 0;
  for (const std::string& path : files_of("include")) {
    ++headers;
    for (const std::string& line : lines_of(path)) {
      std::smatch match;
      if (!std::regex_search(line, match, include)) continue;
      const std::string name = match[1];
      const std::string_view place = layer_of(name);
      const bool is_public =
          place == "refraster" ? fs::exists(fs::path(REFRASTER_SOURCE_DIR) / "include" / name) : place == "glm";
      CHECK_MESSAGE((name.find('/') == std::string::npos || is_public), path << ": " << name);
    }
  }
  CHECK(headers <= 13);
}

TEST_CASE("no file is longer than 450 lines, and no folder has more than 24 sources side by side") {
  std::map<std::string, int> files;
  for (const std::string& path : all_files()) {
    const std::size_t lines = lines_of(path).size();
    CHECK_MESSAGE(lines <= max_lines, path << " has " << lines << " lines");
    ++files[folder_of(path)];
  }
  for (const auto& folder : files)
    CHECK_MESSAGE(folder.second <= max_files, folder.first << " has " << folder.second << " sources");
}

TEST_CASE("one file of the program includes CLI11, which takes seconds to compile") {
  std::vector<std::string> files;
  for (const std::string& file : files_of("app"))
    for (const std::string& line : lines_of(file))
      if (line.starts_with("#include <CLI/")) files.push_back(file);
  CHECK(files == std::vector<std::string>{"app/options/parse.cpp"});
}

TEST_CASE("every header begins with #pragma once") {
  for (const std::string& path : all_files()) {
    if (path.substr(path.size() - 2) != ".h") continue;
    const std::vector<std::string> lines = lines_of(path);
    CHECK_MESSAGE((!lines.empty() && lines.front() == "#pragma once"), path);
  }
}

TEST_CASE("no file begins with an empty line") {
  for (const std::string& path : all_files()) {
    const std::vector<std::string> lines = lines_of(path);
    CHECK_MESSAGE((!lines.empty() && !lines.front().empty()), path);
  }
}
