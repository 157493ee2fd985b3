#pragma once
// The suite file, declared: every key with its type, range and meaning, once. The reader (suite_reader.h) and its error
// messages are readings of these functions, as those of io/scene/scene_keys.h are of a scene file. Beside what is said
// there, `keys` is called
//   keys.some("device", values, "meaning", presence)      a value, or a list of values: one entry for each
//   keys.choice("srgb", value, "meaning", presence)       a word of an enum; nothing where the key is not there
//   keys.words("tags", values, "meaning")                 a list of strings, added to what is there
//   keys.place(offset, json_path)                         where the object stands

#include "io/scene/scene_keys.h"
#include "suite/entry/entry.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster {
template <>
struct EnumNames<Outside> {
  static constexpr std::pair<Outside, std::string_view> names[] = {{Outside::refused, "false"},
                                                                   {Outside::allowed, "true"}};
};
} // namespace refraster

namespace refraster::suite {

/// Of a suite, after its lists and patterns have been told apart.
inline constexpr Limit max_entries{"entries of a suite", 200'000, "entries", "N entries",
                                   "each takes some kilobytes of memory and a place in the page"};

/// Values of one list of an entry, or its tags.
inline constexpr Limit max_listed{"values of a list of a suite's entry", 256, "values", "N values",
                                  "each entry has a copy of those of the defaults"};

/// 1, 2, 4, 8 or 16.
struct Samples {
  int count = 1;
};

/// Entries as the file has them: one for each combination of its lists.
struct EntryText {
  Entry common; // what has no list
  std::vector<std::string> scenes, images = {"render"}, devices;
  std::vector<Action> actions = {Action::compare};
  std::vector<PixelSize> sizes;
  std::vector<Samples> samples;
  std::vector<Precision> precisions = {Precision::double_};
  std::size_t offset = 0; // where it stands in the file, for messages: its byte
  std::string json_path;  // and its key
};

struct SuiteText {
  std::string references;
  EntryText defaults;
  std::vector<EntryText> entries;
};

void limits_keys(EntryLimits& limits, auto&& keys) {
  const auto optional_number = [&](std::string_view key, std::optional<double>& number, std::string_view meaning) {
    double value = number.value_or(-1);
    keys(key, value, Range{}, meaning, otherwise("no limit"));
    if (value >= 0) number = value;
  };
  optional_number("max_abs", limits.compare.max_abs, "of `compare`: largest difference of a value, levels of 1/255");
  optional_number("max_rms", limits.compare.max_rms, "of `compare`: largest root mean square difference, levels");
  int count = limits.compare.max_count ? static_cast<int>(*limits.compare.max_count) : -1;
  keys("max_count", count, Range{0, 2147483647}, "of `compare`: pixels that may differ by more than `max_abs`",
       otherwise("no limit"));
  if (count >= 0) limits.compare.max_count = static_cast<std::uint64_t>(count);
  optional_number("frame_ms", limits.frame_ms, "of `bench`: largest median time of a frame, milliseconds");
  keys.object("fail_on", otherwise("`{\"unexplained\": 0}`"), "of `verify`: pixels of a class that may be",
              [&](auto& inner) {
                for (const auto& [pixel_class, name] : EnumNames<PixelClass>::names) {
                  if (pixel_class == PixelClass::exact) continue;
                  int most = -1;
                  inner(name, most, Range{0, 2147483647}, "pixels", otherwise("no limit"));
                  if (most >= 0) limits.classes.push_back({pixel_class, static_cast<std::uint64_t>(most)});
                }
              });
}

/// Which keys an object of an entry's has: those of the defaults stand for every entry.
enum class EntryKeys { own, defaults };

void entry_keys(EntryText& text, EntryKeys which, auto&& keys) {
  if (which == EntryKeys::own) {
    keys.some("scene", text.scenes, "a scene file or model, or a pattern, as `scenes/*.json`", required);
    keys("name", text.common.name, Range{}, "in place of the scene's", otherwise("the scene's, with what lists add"));
    keys.some("image", text.images,
              "of `compare` and `verify`: `\"render\"`, `\"gl\"`, of `verify` `\"gl-float\"`, or the image file of another "
              "program",
              defaulted);
  }
  keys.some("action", text.actions, "what is done", defaulted);
  keys.some("device", text.devices, "profile of a device, for `verify`; who draws, for `gl`", defaulted);
  keys.some("size", text.sizes, "pixels", otherwise("what the scene says"));
  keys.some("samples", text.samples, "a pixel", otherwise("what the scene says"));
  keys.some("precision", text.precisions, "number type of shading", defaulted);
  keys.choice("srgb", text.common.transfer, "whether the image has the sRGB curve", otherwise("what the scene says"));
  keys.choice("reference", text.common.reference, "what `suite update` stores", otherwise("`\"image\"`"));
  keys.object("limits", otherwise("equal, or explained"), "when it passes",
              [&](auto& inner) { limits_keys(text.common.limits, inner); });
  keys.words("tags", text.common.tags, "words to choose entries by; added to those of the defaults");
  keys("timeout_seconds", text.common.timeout_seconds, Range{0, 1e6, Ends::excluded}, "it is ended then", defaulted);
  int most = static_cast<int>(text.common.max_memory_mib); // 0: not given
  keys("max_memory_mib", most, Range{64, 1 << 30}, "it is ended beyond, MiB", otherwise("its part of --max-memory"));
  text.common.max_memory_mib = static_cast<std::uint64_t>(most);
  keys("allow_outside", text.common.outside, Range{}, "whether the scene may name files outside its folder", defaulted);
}

void suite_keys(SuiteText& suite, auto&& keys) {
  keys("references", suite.references, Range{}, "folder of references", otherwise("--references"));
  keys.object("defaults", otherwise("their own"), "what holds for entries that do not say it",
              [&](auto& inner) { entry_keys(suite.defaults, EntryKeys::defaults, inner); });
  keys.list("entries", required, max_entries, "what is to be done", suite.entries, [&](EntryText& entry, auto& inner) {
    entry = suite.defaults;
    inner.place(entry.offset, entry.json_path);
    entry_keys(entry, EntryKeys::own, inner);
  });
}

} // namespace refraster::suite
