#pragma once
// The reading of suite_keys.h that takes values out of a JSON file.

#include "io/file/nearest.h"
#include "io/scene/scene_reader.h"
#include "suite/file/suite_keys.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace refraster::suite {

/// What may stand in a suite for each type of value that a scene file does not have.
std::string expected_item(const PixelSize&);
std::string expected_item(const Samples&);
std::string expected_item(const std::string&);
template <NamedEnum Enum>
std::string expected_item(const Enum& value) {
  return expected_value(value, Range{});
}
bool read_item(const JsonDocument& document, const JsonNode& node, PixelSize& value);
bool read_item(const JsonDocument& document, const JsonNode& node, Samples& value);
bool read_item(const JsonDocument& document, const JsonNode& node, std::string& value);
template <NamedEnum Enum>
bool read_item(const JsonDocument& document, const JsonNode& node, Enum& value) {
  return read_value(document, node, Range{}, value);
}

/// The words of an enum; of other types none.
std::vector<std::string_view> words_of(const auto&) {
  return {};
}
template <NamedEnum Enum>
std::vector<std::string_view> words_of(const Enum&) {
  std::vector<std::string_view> words;
  for (const auto& [value, name] : EnumNames<Enum>::names) words.push_back(name);
  return words;
}

/// Reads one object of the file by a reader of scenes, with the kinds of values that only suites have.
class SuiteReader {
public:
  explicit SuiteReader(SceneReader& reader) : reader_(reader) {}

  template <class Value>
  void operator()(std::string_view key, Value&& value, const Range& range, std::string_view meaning,
                  Presence presence) {
    reader_(key, value, range, meaning, presence);
  }

  template <class Declare>
  void object(std::string_view key, Presence presence, std::string_view meaning, Declare&& declare) {
    reader_.object(key, presence, meaning, [&](SceneReader& inner) {
      SuiteReader keys(inner);
      declare(keys);
    });
  }

  template <class Item, class Declare>
  void list(std::string_view key, Presence presence, const Limit& most, std::string_view meaning,
            std::vector<Item>& items, Declare&& declare) {
    reader_.list(key, presence, most, meaning, items, [&](Item& item, SceneReader& inner) {
      SuiteReader keys(inner);
      declare(item, keys);
    });
  }

  template <class Item>
  void some(std::string_view key, std::vector<Item>& items, std::string_view, Presence presence) {
    const std::string expected = expected_item(Item{}) + ", or a list of such";
    const JsonIndex found = reader_.claim(key, presence, expected);
    if (!found) return;
    const JsonNode& node = reader_.document()[found];
    Item one{};
    if (read_item(reader_.document(), node, one)) {
      items = {one};
      return;
    }
    if (node.kind != JsonKind::array || node.children == 0) return refuse<Item>(found, reader_.path_of(key), expected);
    if (node.children > max_listed.value) return reader_.not_expected(found, key, at_most(max_listed));
    items.clear();
    std::vector<std::pair<JsonIndex, int>> wrong;
    int number = 0;
    for (JsonIndex i = node.first_child; i; i = reader_.document()[i].next, ++number)
      if (read_item(reader_.document(), reader_.document()[i], one)) items.push_back(one);
      else wrong.emplace_back(i, number);
    // Where none is right, the list itself is what is wrong: [0, 4] is no list of sizes.
    if (items.empty() && wrong.size() > 1) return refuse<Item>(found, reader_.path_of(key), expected);
    for (const auto& [index, place] : wrong)
      refuse<Item>(index, reader_.path_of(key) + '/' + std::to_string(place), expected_item(Item{}));
  }

  template <NamedEnum Enum>
  void choice(std::string_view key, std::optional<Enum>& value, std::string_view, Presence presence) {
    const JsonIndex found = reader_.claim(key, presence, expected_item(Enum{}));
    if (!found) return;
    Enum read{};
    if (read_item(reader_.document(), reader_.document()[found], read)) value = read;
    else refuse<Enum>(found, reader_.path_of(key), expected_item(Enum{}));
  }

  void words(std::string_view key, std::vector<std::string>& words, std::string_view meaning);

  void place(std::size_t& offset, std::string& json_path) const {
    offset = reader_.document()[reader_.object_node()].begin;
    json_path = reader_.path();
  }

private:
  /// With the word that was meant, where one is near.
  template <class Item>
  void refuse(JsonIndex found, std::string path, std::string expected) {
    const JsonNode& node = reader_.document()[found];
    if (node.kind == JsonKind::string) expected += did_you_mean(words_of(Item{}), node.string);
    reader_.not_expected_at(found, std::move(path), expected);
  }

  SceneReader& reader_;
};

/// The keys of a suite file, whose lists are not told apart yet. Throws InputError with all faults.
SuiteText suite_text(const JsonDocument& document);

/// Reads a suite file, and makes its entries: patterns are looked up relative to its folder, and lists become one entry
/// for each combination. Throws InputError with all faults, of keys and of patterns that nothing matches.
Suite read_suite(const std::string& path);

/// Entries for scenes named on the command line, patterns included, as `common` says. Throws InputError as read_suite.
Suite suite_of_scenes(const std::vector<std::string>& scenes, const Entry& common);

} // namespace refraster::suite
