#include "suite/references/references.h"

#include "io/file/input_file.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "io/json/json.h"
#include "io/json/report_parts.h"
#include "io/scene/scene_reader.h"
#include "io/trace/file_trace.h"

#include <filesystem>

namespace refraster::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t digest_digits = 2 * sha256_bytes;

std::string image_name(const std::string& name) {
  return name + ".png";
}

/// The members of one record.
void reference_keys(Reference& reference, SceneReader& keys) {
  Reference::fields(reference, [&]<class Value>(std::string_view key, Value& value) {
    keys(key, value, Range{}, "", key == "reason" || key == "seconds" ? defaulted : required);
  });
}

std::map<std::string, Reference> records_of(const std::string& path) {
  const JsonDocument document(path, read_file(path, "a file of references", JsonDocument::max_bytes));
  FaultList faults;
  std::map<std::string, Reference> all;
  const auto not_an_object = [&](const JsonNode& node, std::string place, const char* expected) {
    faults.add(document.fault_at(node.begin, std::move(place), document.describe(node), expected));
  };
  if (document[0].kind != JsonKind::object) not_an_object(document[0], "", "an object");
  else {
    SceneReader keys(document, 0, "", faults);
    int schema = 0;
    keys("schema", schema, Range{report_schema, report_schema}, "", required);
    const JsonIndex list = keys.claim("references", required, "an object: references by their names");
    if (list && document[list].kind != JsonKind::object)
      not_an_object(document[list], "/references", "an object: references by their names");
    else if (list)
      for (JsonIndex i = document[list].first_child; i; i = document[i].next) {
        const std::string name(document[i].key), place = keys.path_of("references") + '/' + in_quotes(name);
        if (document[i].kind != JsonKind::object) {
          not_an_object(document[i], place, "an object: a reference");
          continue;
        }
        SceneReader record(document, i, place, faults);
        Reference reference;
        reference_keys(reference, record);
        record.finish();
        if (reference.sha256.size() != digest_digits)
          faults.add(document.fault_at(document[i].begin, place + "/sha256", in_quotes(reference.sha256),
                                       "64 hexadecimal digits"));
        all.emplace(name, std::move(reference));
      }
    keys.finish();
  }
  faults.throw_if_any();
  return all;
}

} // namespace

std::string waiting_name(const std::string& name, std::string_view sha256) {
  constexpr std::size_t digits = 16; // enough to tell the images of one name apart
  return name + "." + std::string(sha256.substr(0, digits)) + ".new.png";
}

References::References(std::string folder) : folder_(std::move(folder)) {
  if (folder_.empty()) return;
  const std::string path = fs::path(folder_) / references_file;
  std::error_code error;
  if (fs::exists(path, error)) all_ = records_of(path);
}

const Reference* References::find(const std::string& name) const {
  const auto found = all_.find(name);
  return found == all_.end() ? nullptr : &found->second;
}

std::string References::image_of(const std::string& name) const {
  if (folder_.empty()) return {};
  std::error_code error;
  if (const Reference* const record = find(name)) {
    if (record->kind != ReferenceKind::image) return {};
    const std::string waiting = fs::path(folder_) / waiting_name(name, record->sha256);
    trace_file(waiting);
    if (fs::is_regular_file(waiting, error)) return waiting;
  }
  const std::string image = fs::path(folder_) / image_name(name);
  trace_file(image); // also where there is none yet
  return fs::exists(image, error) ? image : std::string();
}

std::string references_json(const std::map<std::string, Reference>& all) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("references", [&] {
      for (const auto& [name, reference] : all)
        json.object(name, [&, &fields_of = reference] { // clang 14 captures bindings under a name of their own alone
          Reference::fields(fields_of, [&]<class Value>(std::string_view key, const Value& value) {
            if constexpr (NamedEnum<Value>) json.member(key, name_of(value));
            else json.member(key, value);
          });
        });
    });
  });
  return json.text();
}

std::string float_image_digest(const Image<float>& image) {
  Sha256 sha256;
  for (const int side : {image.width, image.height, image.channels}) sha256.add(&side, sizeof side);
  sha256.add(image.values.data(), image.values.size() * sizeof image.values[0]);
  return in_hexadecimal(sha256.result());
}

} // namespace refraster::suite
