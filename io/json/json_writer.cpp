#include "io/json/json_writer.h"

#include "io/file/text.h"

#include <rapidjson/prettywriter.h>
#include <rapidjson/stringbuffer.h>

#include <cassert>
#include <cmath>

namespace refraster {

struct JsonWriter::Document {
  rapidjson::StringBuffer buffer;
  rapidjson::PrettyWriter<rapidjson::StringBuffer> writer{buffer};
};

JsonWriter::JsonWriter() : document_(std::make_unique<Document>()) {
  document_->writer.SetIndent(' ', 2);
  document_->writer.SetFormatOptions(rapidjson::kFormatSingleLineArray);
}
JsonWriter::~JsonWriter() = default;

void JsonWriter::begin_object() {
  document_->writer.StartObject();
}
void JsonWriter::end_object() {
  document_->writer.EndObject();
}
void JsonWriter::begin_array() {
  document_->writer.StartArray();
}
void JsonWriter::end_array() {
  document_->writer.EndArray();
}
void JsonWriter::key(std::string_view name) {
  const std::string text = as_utf8(name);
  document_->writer.Key(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}

void JsonWriter::null() {
  document_->writer.Null();
}
void JsonWriter::value(double number) {
  if (std::isfinite(number)) document_->writer.Double(number);
  else null();
}
void JsonWriter::value(std::string_view given) {
  const std::string text = as_utf8(given);
  document_->writer.String(text.data(), static_cast<rapidjson::SizeType>(text.size()));
}
void JsonWriter::write_bool(bool flag) {
  document_->writer.Bool(flag);
}
void JsonWriter::write_integer(std::int64_t number) {
  document_->writer.Int64(number);
}

std::string JsonWriter::text() const {
  assert(document_->writer.IsComplete());
  return document_->buffer.GetString() + std::string("\n");
}

} // namespace refraster
