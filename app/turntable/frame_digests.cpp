#include "app/turntable/frame_digests.h"

#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/sha256.h"
#include "io/json/json.h"
#include "io/json/report_parts.h"

#include <filesystem>
#include <string_view>

namespace refraster {
namespace {

/// The member of an object; the root, which is no member, where there is none.
JsonIndex member(const JsonDocument& document, JsonIndex object, std::string_view key) {
  for (JsonIndex i = document[object].first_child; i; i = document[i].next)
    if (document[i].key == key) return i;
  return 0;
}

bool is_whole(const std::string& path, std::string_view digest) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && file_sha256(path) == digest;
}

} // namespace

std::string digests_json(const FrameDigests& known) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("scene", known.scene);
    json.member("settings", known.settings);
    json.array("frames", [&] {
      for (std::size_t i = 0; i < known.digests.size(); ++i)
        json.object([&] {
          json.text_or_null("file", known.frames[i]);
          json.text_or_null("sha256", known.digests[i]);
        });
    });
  });
  return json.text();
}

std::size_t take_known_frames(const std::string& path, FrameDigests& wanted) {
  std::size_t count = 0;
  try {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return 0;
    const JsonDocument document(path, read_file(path, "a report", JsonDocument::max_bytes));
    const JsonIndex settings = member(document, 0, "settings"), frames = member(document, 0, "frames");
    if (!settings || !frames || document[settings].string != wanted.settings) return 0;
    std::size_t number = 0;
    for (JsonIndex i = document[frames].first_child; i && number < wanted.digests.size(); i = document[i].next) {
      const std::string_view digest = document[member(document, i, "sha256")].string;
      if (!digest.empty() && is_whole(wanted.frames[number], digest)) wanted.digests[number] = digest, ++count;
      ++number;
    }
  } catch (const InputError&) { // no report of ours: then every frame is made
  }
  return count;
}

} // namespace refraster
