// The words that are suggested for those that are not known.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/nearest.h"

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/random.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

using namespace refraster;

namespace {

/// The definition, word for word: exponential, for short words.
std::size_t distance_by_definition(std::string_view a, std::string_view b) {
  if (a.empty() || b.empty()) return a.size() + b.size();
  const std::string_view a1 = a.substr(1), b1 = b.substr(1);
  std::size_t least = std::min(distance_by_definition(a1, b), distance_by_definition(a, b1)) + 1;
  least = std::min(least, distance_by_definition(a1, b1) + (a[0] == b[0] ? 0 : 1));
  if (a.size() > 1 && b.size() > 1 && a[0] == b[1] && a[1] == b[0])
    least = std::min(least, distance_by_definition(a.substr(2), b.substr(2)) + 1);
  return least;
}

const std::vector<std::string_view> some_options = {"--output", "--size",   "--precision", "--samples",
                                                    "--aov",    "--report", "--crop",      "--max-memory"};

} // namespace

TEST_CASE("edit distances, worked out by hand") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("", "abc") == 3);
  CHECK(edit_distance("kitten", "sitting") == 3);  // k>s, e>i, +g
  CHECK(edit_distance("sampels", "samples") == 1); // neighbours exchanged
  CHECK(edit_distance("ca", "abc") == 3);          // no letter is touched twice
  CHECK(edit_distance("Tube_Radius", "tube-radius") == 0);
}

TEST_CASE("the edit distance is its definition") {
  Random random(14);
  const auto word = [&] {
    std::string text;
    for (int letters = random.below(6); letters > 0; --letters) text += static_cast<char>('a' + random.below(3));
    return text;
  };
  for (int trial = 0; trial < 2000; ++trial) {
    const std::string a = word(), b = word();
    INFO(a << " " << b);
    CHECK(edit_distance(a, b) == distance_by_definition(a, b));
  }
}

TEST_CASE("a slip is understood, another word is not") {
  CHECK(nearest_word("--sampels", some_options) == "--samples");
  CHECK(nearest_word("--sample", some_options) == "--samples");
  CHECK(nearest_word("-size", some_options) == "--size");
  CHECK(nearest_word("--max_memory", some_options) == "--max-memory");
  CHECK(nearest_word("--prec", some_options) == "--precision"); // a beginning
  CHECK(nearest_word("--s", some_options) == std::nullopt);     // of two
  CHECK(nearest_word("--colour", some_options) == std::nullopt);
  CHECK(nearest_word("--", some_options) == std::nullopt);
  CHECK(nearest_word("", some_options) == std::nullopt);
  CHECK(nearest_word(std::string(65, 's'), {std::string_view("s")}) == std::nullopt);
  CHECK(nearest_word("samples", {}) == std::nullopt);
}

TEST_CASE("every word with one letter wrong is understood, and so is each as it stands") {
  for (const std::string_view option : some_options) {
    CHECK(nearest_word(option, some_options) == option);
    for (std::size_t i = 2; i < option.size(); ++i) {
      std::string replaced(option), shortened(option), doubled(option);
      replaced[i] = 'z';
      shortened.erase(i, 1);
      doubled.insert(i, 1, option[i]);
      for (const std::string& slip : {replaced, shortened, doubled}) {
        INFO(slip);
        CHECK(nearest_word(slip, some_options) == option);
      }
    }
  }
}

TEST_CASE("what there is is listed, and what was meant is asked") {
  CHECK(one_of({"phong", "merl"}, "fog") == "one of phong, merl");
  CHECK(one_of({"phong", "merl"}, "Phong") == "one of phong, merl; did you mean phong?");
}

TEST_CASE("a mistyped key or shape of a scene is told with the one that is meant") {
  const test::TemporaryFolder folder;
  const std::string path = folder.path / "s.json";
  std::ofstream(path) << R"({"scene": {"camera": {"positon": "0 0 5"}, "background": "0 0 0", "point_lights": [],
    "direction_lights": [], "objects": [{"mesh": {"shpere": {}}}]}})";
  try {
    read_scene(path, {});
    FAIL("read");
  } catch (const InputError& error) {
    const auto expected_at = [&](const std::string& place) {
      const auto is_here = [&](const InputFault& fault) { return fault.path == place; };
      const auto fault = std::find_if(error.faults().begin(), error.faults().end(), is_here);
      return fault == error.faults().end() ? "nothing is said of " + place : fault->expected;
    };
    CHECK(expected_at("/scene/camera/positon").starts_with("one of fit, position, "));
    CHECK(expected_at("/scene/camera/positon").ends_with("; did you mean position?"));
    CHECK(expected_at("/scene/objects/0/mesh").ends_with("; did you mean sphere?"));
  }
}
