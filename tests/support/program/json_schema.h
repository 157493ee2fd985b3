#pragma once
// Reports of the program against the schemas of the documentation. Who includes it needs rapidjson's headers.

#include <rapidjson/document.h>
#include <rapidjson/schema.h>
#include <rapidjson/stringbuffer.h>

#include <doctest/doctest.h>

#include <string>

namespace refraster {

using Json = rapidjson::Document;

inline Json parsed(const std::string& text) {
  Json json;
  json.Parse(text.c_str());
  REQUIRE_FALSE(json.HasParseError());
  return json;
}

/// Lets no object have members that the schema does not name: for us, who write both.
inline void allow_no_others(rapidjson::Value& schema, Json::AllocatorType& allocator) {
  if (schema.IsArray())
    for (auto& one : schema.GetArray()) allow_no_others(one, allocator);
  if (!schema.IsObject()) return;
  const bool names_members = schema.HasMember("properties") && schema["properties"].IsObject();
  // Counted, since != of iterators that may write is ambiguous in C++20: each converts to one that may only read.
  auto member = schema.MemberBegin();
  for (rapidjson::SizeType left = schema.MemberCount(); left > 0; --left, ++member)
    allow_no_others(member->value, allocator);
  if (names_members) schema.AddMember("additionalProperties", false, allocator);
}

/// Empty, or where the document is not what the schema says; of the text of a schema.
inline std::string schema_fault(const Json& json, const std::string& schema_text) {
  Json schema = parsed(schema_text);
  allow_no_others(schema, schema.GetAllocator());
  const rapidjson::SchemaDocument rules(schema);
  rapidjson::SchemaValidator validator(rules);
  if (json.Accept(validator)) return {};
  rapidjson::StringBuffer where;
  validator.GetInvalidDocumentPointer().StringifyUriFragment(where);
  return std::string(where.GetString()) + ": " + validator.GetInvalidSchemaKeyword();
}

} // namespace refraster
