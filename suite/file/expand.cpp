#include "suite/file/expand.h"

#include "io/file/nearest.h"
#include "io/file/text.h"
#include "verify/device/read_profile.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <glob.h>

namespace refraster::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_name_bytes = 128; // a file name has at most 255, and others add to it

/// One item after the other; where there is none, once nothing.
template <class Item>
std::vector<std::optional<Item>> each_or_none(const std::vector<Item>& items) {
  if (items.empty()) return {std::nullopt};
  return {items.begin(), items.end()};
}

/// Whatever is none of the words is a file.
ImageFrom image_from(const std::string& word) {
  return value_named<ImageFrom>(word).value_or(ImageFrom::file);
}

/// What of an entry does not go together; empty if all does.
std::string objection(const Entry& entry) {
  if (entry.action == Action::verify && entry.device.empty() && entry.image_from == ImageFrom::file) return {};
  if (entry.action == Action::compare && entry.image_from == ImageFrom::gl_float)
    return "floats of OpenGL to compare: `verify` judges them, and references have 8 bits";
  if (entry.reference == ReferenceKind::digest) {
    if (entry.action == Action::compare && entry.image_from != ImageFrom::render)
      return "a digest of an image that is not rendered here: only `double`, `float` and `exact` have the same bits "
             "everywhere";
    if (entry.precision == Precision::fast) return "a digest of the precision fast, whose last bits differ";
  }
  return {};
}

/// Name of a device in an entry's: of a file its stem.
std::string device_word(const std::string& device) {
  return fs::path(device).stem().string();
}

} // namespace

std::string path_from(const std::string& folder, const std::string& path) {
  return (fs::path(folder) / path).lexically_normal().string();
}

std::vector<std::string> matching_files(const std::string& pattern) {
  if (pattern.find_first_of("*?[") == std::string::npos) return {pattern};
  std::error_code ignored;
  if (fs::exists(pattern, ignored)) return {pattern}; // a file whose name has such a character
  glob_t found{};
  std::vector<std::string> paths;
  if (glob(pattern.c_str(), GLOB_NOSORT, nullptr, &found) == 0)
    paths.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string file_name_of(std::string_view name) {
  std::string result(name.substr(0, max_name_bytes));
  for (char& c : result) {
    const bool plain = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9');
    if (!plain && std::string_view("-_.@+").find(c) == std::string_view::npos) c = '_';
  }
  if (result.empty() || result.front() == '.') result.insert(0, "_");
  return result;
}

NamedEntries expanded(const EntryText& text, const std::string& folder, const ExpandFault& fault) {
  NamedEntries result;
  const std::vector<std::string_view> shipped = device_profile_names();
  std::vector<std::string> scenes;
  for (const std::string& pattern : text.scenes) {
    const std::vector<std::string> found = matching_files(path_from(folder, pattern));
    if (found.empty()) fault(in_quotes(pattern), "a pattern that a file matches");
    scenes.insert(scenes.end(), found.begin(), found.end());
  }
  for (const std::string& scene : scenes)
    for (const std::string& image : text.images)
      for (const Action action : text.actions)
        for (const auto& device : each_or_none(text.devices))
          for (const auto& size : each_or_none(text.sizes))
            for (const auto& samples : each_or_none(text.samples))
              for (const Precision precision : text.precisions) {
                Entry entry = text.common;
                entry.scene = scene, entry.action = action, entry.precision = precision;
                entry.image_from = image_from(image);
                if (entry.image_from == ImageFrom::file) entry.image_file = path_from(folder, image);
                // What OpenGL draws is what is verified, where nothing else is said.
                if (action == Action::verify && entry.image_from == ImageFrom::render) entry.image_from = ImageFrom::gl;
                if (device) {
                  const bool is_shipped = std::find(shipped.begin(), shipped.end(), *device) != shipped.end();
                  entry.device = is_shipped ? *device : path_from(folder, *device);
                }
                if (size) entry.size = *size;
                if (samples) entry.samples = samples->count;
                std::string suffix;
                if (text.images.size() > 1) suffix += "@" + fs::path(image).stem().string();
                if (text.actions.size() > 1) suffix += "@" + std::string(name_of(action));
                if (text.devices.size() > 1) suffix += "@" + device_word(*device);
                if (text.sizes.size() > 1) suffix += format("@%dx%d", size->width, size->height);
                if (text.samples.size() > 1) suffix += format("@%dspp", samples->count);
                if (text.precisions.size() > 1) suffix += "@" + std::string(name_of(precision));
                if (const std::string wrong = objection(entry); !wrong.empty()) fault(wrong, "an image");
                result.entries.push_back(std::move(entry));
                result.suffixes.push_back(std::move(suffix));
                if (result.entries.size() > max_entries.value) {
                  fault("more than " + std::to_string(max_entries.value) + " entries", at_most(max_entries));
                  return {};
                }
              }
  return result;
}

std::vector<Entry> named_apart(std::vector<NamedEntries> groups,
                               const std::function<void(std::size_t, const std::string&, const std::string&)>& fault) {
  struct Place {
    std::size_t group, index;
    fs::path rest; // folders that are not part of the name so far
    std::string stem;
  };
  std::vector<Place> places;
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t i = 0; i < groups[g].entries.size(); ++i) {
      const Entry& entry = groups[g].entries[i];
      const fs::path scene = fs::path(entry.scene).lexically_normal();
      const bool is_given = !entry.name.empty();
      places.push_back(
          {g, i, is_given ? fs::path() : scene.parent_path(), is_given ? entry.name : scene.stem().string()});
    }
  const auto full_name = [&](const Place& place) {
    return file_name_of(place.stem + groups[place.group].suffixes[place.index]);
  };
  // As long as folders tell anything apart. A folder more for each of those that have one name: which those are does
  // not depend on the order.
  for (bool changed = true; changed;) {
    changed = false;
    std::map<std::string, std::vector<std::size_t>> same;
    for (std::size_t i = 0; i < places.size(); ++i) same[full_name(places[i])].push_back(i);
    for (const auto& [name, those] : same) {
      if (those.size() < 2) continue;
      for (const std::size_t i : those) {
        Place& place = places[i];
        if (place.rest.empty() || place.rest == "/") continue;
        place.stem = place.rest.filename().string() + "-" + place.stem;
        place.rest = place.rest.parent_path();
        changed = true;
      }
    }
  }
  std::map<std::string, const Place*> taken;
  std::vector<Entry> entries;
  for (const Place& place : places) {
    Entry entry = std::move(groups[place.group].entries[place.index]);
    entry.name = full_name(place);
    if (!taken.emplace(entry.name, &place).second)
      fault(place.group, "the name " + in_quotes(entry.name) + " a second time",
            "each entry with a \"name\" of its own");
    entries.push_back(std::move(entry));
  }
  return entries;
}

} // namespace refraster::suite
