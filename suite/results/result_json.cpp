#include "suite/results/result_json.h"

#include <cmath>

namespace refraster::suite {
namespace {

void write_value(JsonWriter& json, std::string_view name, const std::vector<InputDigest>& inputs) {
  json.array(name, [&] {
    for (const InputDigest& input : inputs)
      json.object([&] {
        json.member("path", input.path);
        json.text_or_null("sha256", input.sha256);
      });
  });
}
void write_value(JsonWriter& json, std::string_view name, const std::string& text) {
  json.text_or_null(name, text);
}
template <class Value>
void write_value(JsonWriter& json, std::string_view name, const Value& value) {
  if constexpr (NamedEnum<Value>) json.member(name, name_of(value));
  else json.member(name, value);
}

bool read_member(const JsonDocument&, const JsonNode& node, std::string& text) {
  text = node.string; // nothing, of null
  return node.kind == JsonKind::string || node.kind == JsonKind::null;
}
template <class Number>
  requires std::is_arithmetic_v<Number>
bool read_member(const JsonDocument&, const JsonNode& node, Number& number) {
  number = static_cast<Number>(node.number);
  return node.kind == JsonKind::number && std::isfinite(node.number) && node.number >= 0;
}
template <NamedEnum Enum>
bool read_member(const JsonDocument&, const JsonNode& node, Enum& value) {
  const std::optional<Enum> named = value_named<Enum>(node.string);
  value = named.value_or(value);
  return named.has_value();
}
bool read_member(const JsonDocument& document, const JsonNode& node, InputDigest& input) {
  if (node.kind != JsonKind::object) return false;
  for (JsonIndex i = node.first_child; i; i = document[i].next) {
    if (document[i].key == "path") input.path = document[i].string;
    if (document[i].key == "sha256") input.sha256 = document[i].string;
  }
  return !input.path.empty();
}
template <class Item>
bool read_member(const JsonDocument& document, const JsonNode& node, std::vector<Item>& items) {
  if (node.kind != JsonKind::array) return false;
  for (JsonIndex i = node.first_child; i; i = document[i].next)
    if (!read_member(document, document[i], items.emplace_back())) return false;
  return true;
}

} // namespace

void write_result(JsonWriter& json, const EntryResult& result, MemberOf up_to) {
  json.object([&] {
    EntryResult::fields(result, [&](std::string_view name, const auto& value, MemberOf where, std::string_view) {
      if (where == MemberOf::report || up_to == MemberOf::journal) write_value(json, name, value);
    });
  });
}

std::string result_text(const EntryResult& result) {
  JsonWriter json;
  write_result(json, result, MemberOf::journal);
  return json.text();
}

std::optional<EntryResult> result_from(const JsonDocument& document, JsonIndex object) {
  EntryResult result;
  bool is_whole = document[object].kind == JsonKind::object;
  EntryResult::fields(result, [&](std::string_view name, auto& value, MemberOf, std::string_view) {
    const JsonIndex found = member_of(document, object, name);
    is_whole = is_whole && found && read_member(document, document[found], value);
  });
  if (!is_whole || result.name.empty()) return std::nullopt;
  return result;
}

} // namespace refraster::suite
