#include "suite/file/suite_reader.h"

#include "io/file/input_file.h"
#include "suite/file/expand.h"

#include <filesystem>

namespace refraster::suite {

std::string expected_item(const PixelSize&) {
  return "[width, height], each 1 to " + std::to_string(limit::frame_side.value);
}
std::string expected_item(const Samples&) {
  return "1, 2, 4, 8 or 16";
}
std::string expected_item(const std::string&) {
  return "a string";
}

bool read_item(const JsonDocument& document, const JsonNode& node, PixelSize& value) {
  if (node.kind != JsonKind::array || node.children != 2) return false;
  const Range side{1, double(limit::frame_side.value)};
  const JsonNode& width = document[node.first_child];
  return read_value(document, width, side, value.width) &&
         read_value(document, document[width.next], side, value.height);
}
bool read_item(const JsonDocument& document, const JsonNode& node, Samples& value) {
  SampleCount samples{value.count};
  return read_value(document, node, Range{}, samples);
}
bool read_item(const JsonDocument& document, const JsonNode& node, std::string& value) {
  std::string text;
  // A path with a zero byte would name another file than it shows.
  if (!read_value(document, node, Range{}, text) || text.empty() || text.find('\0') != std::string::npos) return false;
  value = std::move(text);
  return true;
}

void SuiteReader::words(std::string_view key, std::vector<std::string>& words, std::string_view) {
  const std::string expected = "a list of words";
  const JsonIndex found = reader_.claim(key, otherwise("none"), expected);
  if (!found) return;
  const JsonNode& node = reader_.document()[found];
  if (node.kind != JsonKind::array) return reader_.not_expected(found, key, expected);
  if (node.children > max_listed.value) return reader_.not_expected(found, key, at_most(max_listed));
  int number = 0;
  for (JsonIndex i = node.first_child; i; i = reader_.document()[i].next, ++number) {
    std::string word;
    if (read_item(reader_.document(), reader_.document()[i], word)) words.push_back(word);
    else reader_.not_expected_at(i, reader_.path_of(key) + '/' + std::to_string(number), "a word");
  }
}

SuiteText suite_text(const JsonDocument& document) {
  FaultList faults;
  SuiteText text;
  if (document[0].kind != JsonKind::object) {
    faults.add(document.fault_at(document[0].begin, "", document.describe(document[0]), "an object"));
    faults.throw_if_any();
  }
  SceneReader reader(document, 0, "", faults);
  SuiteReader keys(reader);
  suite_keys(text, keys);
  reader.finish();
  faults.throw_if_any();
  return text;
}

Suite read_suite(const std::string& path) {
  const JsonDocument document(path, read_file(path, "a suite file", JsonDocument::max_bytes));
  const SuiteText text = suite_text(document);
  FaultList faults;

  const std::string folder = std::filesystem::path(path).parent_path();
  Suite suite;
  suite.path = path;
  if (!text.references.empty()) suite.references = path_from(folder, text.references);
  std::vector<NamedEntries> groups;
  for (const EntryText& entry : text.entries)
    groups.push_back(expanded(entry, folder, [&](const std::string& found, const std::string& expected) {
      faults.add(document.fault_at(entry.offset, entry.json_path, found, expected));
    }));
  suite.entries =
      named_apart(std::move(groups), [&](std::size_t group, const std::string& found, const std::string& expected) {
        faults.add(document.fault_at(text.entries[group].offset, text.entries[group].json_path, found, expected));
      });
  faults.throw_if_any();
  return suite;
}

Suite suite_of_scenes(const std::vector<std::string>& scenes, const Entry& common) {
  FaultList faults;
  EntryText text;
  text.common = common;
  text.actions = {common.action};
  text.precisions = {common.precision};
  if (common.size) text.sizes = {*common.size};
  if (common.samples) text.samples = {{*common.samples}};
  text.scenes = scenes;
  const auto fault = [&](const std::string& found, const std::string& expected) {
    faults.add(InputFault{"the command line", 0, 0, "", found, expected});
  };
  std::vector<NamedEntries> groups = {expanded(text, "", fault)};
  Suite suite;
  suite.entries = named_apart(std::move(groups), [&](std::size_t, const std::string& found,
                                                     const std::string& expected) { fault(found, expected); });
  faults.throw_if_any();
  return suite;
}

} // namespace refraster::suite
