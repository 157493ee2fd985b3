#include "io/parts/settings.h"

#include "io/file/sha256.h"

#include <algorithm>

namespace refraster {
namespace {

/// Long values, as digests, are the same to who reads a message.
std::string shown(std::string_view value) {
  constexpr std::size_t longest = 40;
  if (value.empty()) return "nothing";
  return value.size() <= longest ? std::string(value) : std::string(value.substr(0, longest - 1)) + "…";
}

} // namespace

std::optional<std::string_view> setting(const Settings& settings, std::string_view name) {
  const auto found =
      std::find_if(settings.begin(), settings.end(), [name](const auto& one) { return one.first == name; });
  if (found == settings.end()) return std::nullopt;
  return found->second;
}

std::optional<InputFault> settings_fault(const std::string& path, const Settings& found, const std::string& other,
                                         const Settings& expected) {
  if (found == expected) return std::nullopt;
  for (const auto& [name, value] : expected) {
    const std::string_view here = setting(found, name).value_or("");
    if (here != value) return InputFault{path, 0, 0, name, shown(here), shown(value) + ", as " + other + " has it"};
  }
  return InputFault{path, 0, 0, "settings", "other names", "those of " + other};
}

std::string settings_digest(const Settings& settings) {
  JsonWriter json;
  json.object([&] { write_settings(json, "settings", settings); });
  return text_sha256(json.text());
}

void write_settings(JsonWriter& json, std::string_view name, const Settings& settings) {
  json.object(name, [&] {
    for (const auto& [key, value] : settings) json.member(key, value);
  });
}

std::optional<Settings> settings_from(const JsonDocument& document, JsonIndex object) {
  if (document[object].kind != JsonKind::object) return std::nullopt;
  Settings settings;
  for (JsonIndex i = document[object].first_child; i; i = document[i].next) {
    if (document[i].kind != JsonKind::string) return std::nullopt;
    settings.emplace_back(document[i].key, document[i].string);
  }
  return settings;
}

} // namespace refraster
