// The key "shadow" of lights: a word, or an object that says what a shadow map is like.

#include <refraster/files.h>

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/text.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace refraster::test {
namespace {

Scene lit_scene(const std::string& point_shadow, const std::string& direction_shadow,
                const SceneOptions& options = {}) {
  const TemporaryFolder folder;
  const auto key = [](const std::string& shadow) { return shadow.empty() ? "" : ", \"shadow\": " + shadow; };
  write_files(folder.path, {{"s.json", R"({"scene": {"camera": {"position": "0 0 6"}, "objects": [], "point_lights": [
        {"position": "0 1 2", "radiance": "1 1 1", "constant": 1, "linear": 0, "quadratic": 0)" +
                                           key(point_shadow) + R"(}],
        "direction_lights": [{"direction": "0 0 -1", "radiance": "1 1 1")" +
                                           key(direction_shadow) + "}]}}"}});
  return read_scene(folder / "s.json", options);
}

std::string fault_of(const std::string& point_shadow, const std::string& direction_shadow = "") {
  try {
    lit_scene(point_shadow, direction_shadow);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

} // namespace

TEST_CASE("a shadow map is a word, or an object with its size and what else is asked for") {
  const Scene plain = lit_scene("", "");
  CHECK(plain.point_lights[0].shadow == Shadow::none);
  const Scene words = lit_scene("\"map\"", "\"exact\"");
  CHECK(words.point_lights[0].shadow == Shadow::map);
  CHECK(words.point_lights[0].shadow.map == ShadowMap{});
  CHECK(words.direction_lights[0].shadow == Shadow::exact);
  const Scene objects = lit_scene(R"({"map": 2048, "filter": "pcf3", "bias": 0.5, "slope_bias": 0, "near": 0.25})",
                                  R"({"map": 16, "filter": "none"})");
  const CastShadow& lamp = objects.point_lights[0].shadow;
  CHECK(lamp == Shadow::map);
  CHECK(lamp.map.size == 2048);
  CHECK(lamp.map.filter == ShadowFilter::pcf3);
  CHECK(lamp.map.bias == 0.5);
  CHECK(lamp.map.slope_bias == 0);
  CHECK(lamp.map.near == 0.25);
  const CastShadow& sun = objects.direction_lights[0].shadow;
  CHECK(sun == Shadow::map);
  CHECK(sun.map.size == 16);
  CHECK(sun.map.filter == ShadowFilter::nearest);
  CHECK(sun.map.bias == ShadowMap{}.bias);
  CHECK(lit_scene("{\"map\": 8192, \"filter\": \"2x2\"}", "").point_lights[0].shadow.map.filter ==
        ShadowFilter::two_by_two);
}

TEST_CASE("what is wrong with a shadow map is said with its place, what was found and what is expected") {
  const std::string at = "/scene/point_lights/0/shadow";
  for (const char* const word : {"\"soft\"", "3", "true", "null", "[]", "[1024]"}) {
    CAPTURE(word);
    CHECK(holds(fault_of(word), at + ": found "));
    CHECK(holds(fault_of(word), "expected \"none\" or \"exact\" or \"map\" or an object with map"));
  }
  CHECK(holds(fault_of("{}"), at + "/map: found nothing, expected a whole number from 16 to 8192"));
  for (const char* const size : {"15", "8193", "-1024", "100.5", "1e9", "\"1024\"", "null", "{}"}) {
    CAPTURE(size);
    CHECK(holds(fault_of(std::string("{\"map\": ") + size + "}"),
                at + "/map: found " + (*size == '"' || *size == 'n' || *size == '{' ? "" : size)));
  }
  for (const char* const key : {"bias", "slope_bias", "near"}) {
    CAPTURE(key);
    CHECK(holds(fault_of("{\"map\": 64, \"" + std::string(key) + "\": -0.5}"),
                at + "/" + key + ": found -0.5, expected a number >= 0"));
    CHECK(holds(fault_of("{\"map\": 64, \"" + std::string(key) + "\": \"1\"}"), at + "/" + key + ": found \"1\""));
  }
  CHECK(holds(fault_of("{\"map\": 64, \"filter\": \"linear\"}"),
              at + "/filter: found \"linear\", expected \"none\" or \"2x2\" or \"pcf3\""));
  CHECK(holds(fault_of("{\"map\": 64, \"size\": 3}"), at + "/size: found an unknown key"));
  CHECK(holds(fault_of("{\"map\": 64, \"map\": 64}"), at + "/map: found the key a second time"));
  CHECK(
      holds(fault_of("", "{\"map\": 64, \"near\": 1}"), "/scene/direction_lights/0/shadow/near: found an unknown key"));
}

TEST_CASE("all lights that have a shadow may be given another, and a note says how many are") {
  const auto with = [](Shadow shadow, std::optional<int> size, NoteList* notes = nullptr) {
    return lit_scene(R"({"map": 64, "bias": 3})", "\"exact\"",
                     {.notes = notes, .shadow = shadow, .shadow_map_size = size});
  };
  NoteList notes;
  const Scene maps = with(Shadow::map, 256, &notes);
  CHECK(maps.point_lights[0].shadow.map.size == 256);
  CHECK(maps.point_lights[0].shadow.map.bias == 3);
  CHECK(maps.direction_lights[0].shadow == Shadow::map);
  CHECK(maps.direction_lights[0].shadow.map.size == 256);
  std::string text;
  for (const Note& note : notes.notes()) text += note.text() + "\n";
  CHECK_MESSAGE(holds(text, "shadow, 1 light has another than the file says: map"), text);
  CHECK(with(Shadow::map, {}).point_lights[0].shadow.map.size == 64);
  CHECK(with(Shadow::exact, {}).point_lights[0].shadow == Shadow::exact);
  CHECK_FALSE(has_shadows(with(Shadow::none, {})));
  CHECK_FALSE(has_shadows(lit_scene("", "", {.shadow = Shadow::map})));
}

} // namespace refraster::test
