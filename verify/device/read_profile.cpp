#include "verify/device/read_profile.h"

#include "io/file/input_file.h"
#include "io/file/nearest.h"
#include "io/scene/scene_reader.h"
#include "verify/device/shipped_profiles.h"

#include <filesystem>
#include <optional>
#include <variant>

namespace refraster {

// A text that may be left out: for SceneReader, which finds these by their arguments.
static std::string expected_value(const std::optional<std::string>&, const Range&) {
  return "a string";
}
static bool read_value(const JsonDocument& document, const JsonNode& node, const Range& range,
                       std::optional<std::string>& value) {
  std::string text;
  if (!read_value(document, node, range, text)) return false;
  value = std::move(text);
  return true;
}

namespace {

constexpr int max_version = 99'999;

/// The shipped profile that the file is based on, if it names one.
std::optional<DeviceProfile> base_of(const JsonDocument& document) {
  for (JsonIndex i = document[0].first_child; i; i = document[i].next)
    if (document[i].key == "based_on" && document[i].kind == JsonKind::string)
      for (const ShippedProfile& shipped : shipped_profiles())
        if (document[i].string == shipped.name) return device_profile(std::string(shipped.name));
  return std::nullopt;
}

void read_environment(SceneReader& keys, DeviceProfile& profile) {
  for (const std::string_view name : driver_switches) {
    std::optional<std::string> value;
    keys(name, value, Range{}, "", defaulted);
    if (value) profile.environment[std::string(name)] = *value;
  }
}

void read_measured(SceneReader& keys, DeviceProfile& profile) {
  MeasuredDevice& measured = profile.measured.emplace();
  MeasuredDevice::fields(measured, [&](std::string_view key, std::string& value, std::string_view meaning) {
    keys(key, value, Range{}, meaning, required);
  });
  keys("probe_version", measured.probe_version, Range{1, max_version}, "", required);
}

/// The sources that the file gives.
std::map<std::string, std::string> read_sources(SceneReader& keys, DeviceProfile& profile) {
  std::map<std::string, std::string> sources;
  DeviceProfile::groups(profile, [&](std::string_view name, auto& group, std::string_view) {
    keys.object(name, defaulted, "", [&](SceneReader& members) {
      group_fields(group, [&](std::string_view key, auto&, const Range&, Wider, std::string_view) {
        std::optional<std::string> source;
        members(key, source, Range{}, "", defaulted);
        if (source) sources[std::string(name).append("/").append(key)] = *source;
      });
    });
  });
  return sources;
}

/// The source of a number that the file changes is none of the base's.
void keep_sources(const DeviceProfile& base, DeviceProfile& profile) {
  std::map<std::string, std::variant<double, SetupPositions, FillRule, InterpolationAnchor, DepthFormat>> before;
  for_each_member(base, [&](const std::string& place, const auto& value, const Range&, Wider, std::string_view) {
    before.emplace(place, value);
  });
  profile.sources = base.sources;
  for_each_member(profile,
                  [&]<class Value>(const std::string& place, Value& value, const Range&, Wider, std::string_view) {
                    if (std::get<Value>(before.at(place)) != value) profile.sources.erase(place);
                  });
}

} // namespace

DeviceProfile parse_device_profile(const std::string& file, const std::string& text) {
  const JsonDocument document(file, text);
  if (document[0].kind != JsonKind::object)
    throw InputError(
        document.fault_at(document[0].begin, "", document.describe(document[0]), "an object, the profile of a device"));
  const std::optional<DeviceProfile> base = base_of(document);
  const Presence presence = base ? defaulted : required;
  DeviceProfile profile;
  if (base) profile = *base, profile.version = 1;

  FaultList faults;
  SceneReader keys(document, 0, "", faults);
  keys("name", profile.name, Range{}, "", required);
  keys("version", profile.version, Range{1, max_version}, "", defaulted);
  keys("meaning", profile.meaning, Range{}, "", presence);
  NamedValue based_on{device_profile_names()};
  keys("based_on", based_on, Range{}, "", defaulted);
  keys("renderer", profile.renderer, Range{}, "", defaulted);
  keys.object("environment", defaulted, "", [&](SceneReader& inner) { read_environment(inner, profile); });
  keys.object("measured", defaulted, "", [&](SceneReader& inner) { read_measured(inner, profile); });
  DeviceProfile::groups(profile, [&](std::string_view name, auto& group, std::string_view meaning) {
    keys.object(name, presence, meaning, [&](SceneReader& members) {
      group_fields(group, [&](std::string_view key, auto& value, const Range& range, Wider, std::string_view about) {
        members(key, value, range, about, presence);
      });
    });
  });
  std::map<std::string, std::string> sources;
  keys.object("sources", defaulted, "", [&](SceneReader& inner) { sources = read_sources(inner, profile); });
  keys.finish();
  faults.sort_by_place();
  faults.throw_if_any();

  if (base) keep_sources(*base, profile);
  for (auto& [place, source] : sources) profile.sources[place] = std::move(source);
  return profile;
}

DeviceProfile read_device_profile(const std::string& path) {
  return parse_device_profile(path, read_file(path, "a JSON file, the profile of a device", JsonDocument::max_bytes));
}

DeviceProfile device_profile(const std::string& name_or_path) {
  for (const ShippedProfile& shipped : shipped_profiles())
    if (name_or_path == shipped.name) return parse_device_profile(name_or_path + ".json", std::string(shipped.json));
  std::error_code ignored;
  if (name_or_path.find('/') == std::string::npos && extension(name_or_path).empty() &&
      !std::filesystem::exists(name_or_path, ignored))
    throw InputError({name_or_path, 0, 0, "", "neither a file nor a device",
                      one_of(device_profile_names(), name_or_path) + "; or the profile of a device in a JSON file"});
  return read_device_profile(name_or_path);
}

std::vector<std::string_view> device_profile_names() {
  std::vector<std::string_view> names;
  for (const ShippedProfile& shipped : shipped_profiles()) names.push_back(shipped.name);
  return names;
}

} // namespace refraster
