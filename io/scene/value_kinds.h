#pragma once
// What may stand in a scene file for each type of value: how it is named, in messages and in the documentation, and
// how it is read.

#include "io/json/json.h"
#include "io/scene/scene_keys.h"

#include <string>

namespace refraster {

/// "a number >= 0", "three numbers", "a whole number from 3 to 4096".
std::string expected_value(const double&, const Range& range);
std::string expected_value(const int&, const Range& range);
std::string expected_value(const SampleCount&, const Range&);
std::string expected_value(const Double2&, const Range& range);
std::string expected_value(const Double3&, const Range& range);
std::string expected_value(const std::string&, const Range&);
std::string expected_value(const PathText&, const Range&);
std::string expected_value(const FragmentFunctionName& value, const Range&);
std::string expected_value(const NamedValue& value, const Range&);

/// A word as JSON has it: in quotes, but for the literals true and false.
std::string json_word(std::string_view word);

/// What may stand at the key "normals".
std::string expected_normals();

/// What may stand at the key "shadow".
std::string expected_shadow();

/// What may stand where a texture does.
std::string expected_map();

template <NamedEnum Enum>
std::string expected_value(const Enum&, const Range&) {
  std::string result;
  for (const auto& [value, name] : EnumNames<Enum>::names) result += (result.empty() ? "" : " or ") + json_word(name);
  return result;
}

/// Reads the value. False if the JSON is not what expected_value says; then `value` is left as it was.
bool read_value(const JsonDocument&, const JsonNode& node, const Range& range, double& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range& range, int& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range&, SampleCount& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range& range, Double2& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range& range, Double3& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range&, std::string& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range&, PathText& value);
bool read_value(const JsonDocument&, const JsonNode& node, const Range&, FragmentFunctionName& value);
bool read_value(const JsonDocument& document, const JsonNode& node, const Range&, NamedValue& value);

/// Whether a value is this word, as JSON has it.
bool is_word(const JsonDocument& document, const JsonNode& node, std::string_view word);

template <NamedEnum Enum>
bool read_value(const JsonDocument& document, const JsonNode& node, const Range&, Enum& value) {
  for (const auto& [listed, name] : EnumNames<Enum>::names) {
    if (!is_word(document, node, name)) continue;
    value = listed;
    return true;
  }
  return false;
}

} // namespace refraster
