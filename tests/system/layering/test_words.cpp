// One concept, one word: names that the field has no use for do not come back.

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

struct Word {
  std::string_view old_word, word;
};

// As a part of a name or in text, between underscores or as one hump of several.
constexpr Word parts[] = {{"rung", "precision"},      {"rungs", "precisions"},    {"twofold", "DoubleDouble"},
                          {"shelf", "rounding bias"}, {"contender", "candidate"}, {"contenders", "candidates"},
                          {"catalogue", "extremes"},  {"drawers", "buckets"}};

// As a whole name.
constexpr Word names[] = {{"Model", "FragmentFunction"},
                          {"all_models", "all_fragment_functions"},
                          {"is_quick", "is_fast"},
                          {"quick_sum", "fast_two_sum"},
                          {"wide_product", "two_product"},
                          {"Crop", "PixelRect"},
                          {"want_levels", "want_rgb8"},
                          {"SnappedLine", "SnappedEdge"},
                          {"ProjectiveLine", "ProjectiveEdge"},
                          {"ProjectiveLines", "ProjectiveEdges"},
                          {"WrappedLine", "WrappedEdge"},
                          {"LargeLines", "LargeEdges"},
                          {"Line", "EdgeFunction"},
                          {"LineKind", "EdgeKind"},
                          {"SurfaceTriangle", "AttributeSetup"},
                          {"TileSurfaces", "TileAttributes"},
                          {"set_up_surfaces", "set_up_attributes"},
                          {"TileShader", "TileShading"},
                          {"SamplePlace", "SamplePosition"},
                          {"run_and_tell", "run_and_report"},
                          {"let_go_of_memory_limit", "clear_memory_limit"},
                          {"hold_to", "set_memory_limit"},
                          {"keep_mesh", "store_mesh"},
                          {"kept_mesh", "cached_mesh"},
                          {"FrameMaker", "FrameSource"},
                          {"PinnedTeams", "PinnedThreadPool"},
                          {"Rounds", "Repetitions"},
                          {"refraster_floor", "refraster_layer"},
                          {"REFRASTER_FLOORS", "REFRASTER_LAYERS"}};

// As the beginning of a name.
constexpr Word beginnings[] = {{"most_", "max_"}, {"least_", "min_"}};

// As a function that is called without a qualifier.
constexpr Word functions[] = {{"root", "sqrt"},
                              {"magnitude", "abs"},
                              {"maximum", "max"},
                              {"minimum", "min"},
                              {"positive", "max0"},
                              {"power", "pow"},
                              {"exact_sum", "two_sum"},
                              {"halves", "veltkamp_split"},
                              {"drawer_of", "bucket_of"},
                              {"hides", "is_occluded"},
                              {"identity", "canonical_path"},
                              {"see", "is_visible"},
                              {"lookup", "read_grid"},
                              {"share", "weight"},
                              {"tell", "report"},
                              {"told", "reported"},
                              {"keep", "store"},
                              {"kept", "cached"}};

// Several words of a sentence.
constexpr Word phrases[] = {{"frame maker", "frame source"},
                            {"pinned team", "pinned thread pool"},
                            {"round by round", "repetition by repetition"},
                            {"let go of", "clear"}};

/// "double_rung", "DoubleRung" and "rung 3" hold the part "rung".
std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> result(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool upper = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    const bool after_lower = i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    if (std::isalpha(static_cast<unsigned char>(name[i])) == 0) {
      result.emplace_back();
      continue;
    }
    if (upper && after_lower) result.emplace_back();
    result.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  return result;
}

/// What is wrong with a name; empty if nothing is. `called`: an opening parenthesis follows, and no qualifier is
/// before.
std::string objection(const std::string& name, bool called) {
  const auto instead = [&](const Word& word) {
    return std::string(word.old_word).append(" in ").append(name).append(": say ").append(word.word);
  };
  const std::vector<std::string> all = parts_of(name);
  for (const Word& word : parts)
    if (std::find(all.begin(), all.end(), word.old_word) != all.end()) return instead(word);
  for (const Word& word : names)
    if (name == word.old_word) return instead(word);
  for (const Word& word : beginnings)
    if (name.starts_with(word.old_word)) return instead(word);
  for (const Word& word : functions)
    if (called && name == word.old_word) return instead(word);
  return {};
}

/// Every objection to a text.
std::vector<std::string> objections(const std::string& text) {
  std::vector<std::string> result;
  for (const Word& phrase : phrases)
    if (text.find(phrase.old_word) != std::string::npos)
      result.push_back(std::string(phrase.old_word).append(": say ").append(phrase.word));
  const auto in_name = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (std::size_t at = 0, after = 0; at < text.size(); at = std::max(after, at + 1)) {
    if (!in_name(at) || std::isdigit(static_cast<unsigned char>(text[at])) != 0) continue;
    for (after = at; in_name(after);) ++after;
    const bool qualified = at > 0 && (text[at - 1] == '.' || text[at - 1] == ':' || text[at - 1] == '>');
    const bool called = after < text.size() && text[after] == '(' && !qualified;
    if (std::string wrong = objection(text.substr(at, after - at), called); !wrong.empty())
      result.push_back(std::move(wrong));
  }
  return result;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

TEST_CASE("no name and no page uses a word that has another name here") {
  const fs::path root = REFRASTER_SOURCE_DIR;
  int files = 0;
  for (const char* const folder : {"math", "shading", "scene", "raster", "io", "gl", "verify", "scenes", "brdf",
                                   "bench", "suite", "app", "python", "tests", "docs", "cmake", "scripts"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension(), name = entry.path().filename();
      const bool is_text = extension == ".h" || extension == ".cpp" || extension == ".md" || extension == ".cmake" ||
                           extension == ".json" || name == "CMakeLists.txt" || name == "run" || name == "page" ||
                           (extension.empty() && entry.path().parent_path().filename() == "scripts");
      if (!is_text || !entry.is_regular_file() || name == "test_words.cpp" || name == "old_names.h") continue;
      ++files;
      for (const std::string& wrong : objections(text_of(entry.path())))
        FAIL_CHECK(entry.path().lexically_relative(root).string() << ": " << wrong);
    }
  CHECK(files > 400);
}

TEST_CASE("a word that has another name here is found") {
  CHECK(objections("for (const Rung& rung : rungs)").size() == 3);
  CHECK(objections("double_rung = DoubleRung::name").size() == 2);
  CHECK(objections("return root(x) + magnitude(y);").size() == 2);
  CHECK(objections("most_pixels + at_most(x)").size() == 1);
  CHECK(objections("of each frame maker, round by round").size() == 2);
  CHECK(objections("const Line line = see(x);").size() == 2);
  CHECK(objections("root / path; random.power(2); std::maximum(1); strung").empty());
}
