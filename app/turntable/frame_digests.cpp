#include "app/turntable/frame_digests.h"

#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "io/file/sha256.h"
#include "io/json/json.h"
#include "io/json/report_parts.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace refraster {
namespace {

constexpr std::string_view expected_report = "a report of frames, which `refraster turntable` has written";

[[noreturn]] void refuse_report(const std::string& path, std::string_view member) {
  throw InputError(
      InputFault{path, 0, 0, std::string(member), "what no report has there", std::string(expected_report)});
}

/// The value of a member of this kind, or of null where that may be.
const JsonNode& need(const JsonDocument& document, JsonIndex object, std::string_view name, JsonKind kind,
                     bool may_be_null = false) {
  const JsonIndex found = member_of(document, object, name);
  if (!found || (document[found].kind != kind && !(may_be_null && document[found].kind == JsonKind::null)))
    refuse_report(document.file(), name);
  return document[found];
}

} // namespace

std::string pixels_sha256(const Image<std::uint8_t>& rgb8) {
  Sha256 sha256;
  sha256.add(rgb8.values.data(), rgb8.values.size());
  return in_hexadecimal(sha256.result());
}

bool is_whole_frame(const std::string& path, std::string_view digest) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && file_sha256(path) == digest;
}

std::string digests_json(const FrameDigests& known) {
  JsonWriter json;
  json.object([&] {
    json.member("schema", report_schema);
    json.object("refraster", [&] { write_build(json, this_build()); });
    json.member("scene", known.scene);
    if (known.shard) {
      json.member("shard", shard_text(*known.shard));
      json.member("of_frames", known.frames.size());
    }
    json.member("settings", settings_digest(known.settings));
    write_settings(json, "options", known.settings);
    json.array("frames", [&] {
      for (std::size_t i = 0; i < known.digests.size(); ++i) {
        // A thousand shards that each write all names once a second would be more to write than their frames.
        if (known.shard && !has_frame(*known.shard, i)) continue;
        json.object([&] {
          json.text_or_null("file", known.frames[i]);
          json.text_or_null("sha256", known.digests[i]);
        });
      }
    });
  });
  return json.text();
}

FrameDigests read_digests(const std::string& path) {
  const JsonDocument document(path, read_file(path, expected_report, JsonDocument::max_bytes));
  FrameDigests known;
  if (document[0].kind != JsonKind::object) refuse_report(path, "");
  known.scene = need(document, 0, "scene", JsonKind::string).string;
  if (const JsonIndex shard = member_of(document, 0, "shard"); shard) {
    known.shard = shard_from(document[shard].string);
    if (!known.shard) refuse_report(path, "shard");
    const double count = need(document, 0, "of_frames", JsonKind::number).number;
    if (!(count >= 1 && count <= max_frames) || count != std::floor(count)) refuse_report(path, "of_frames");
    known.frames.resize(static_cast<std::size_t>(count));
    known.digests.resize(known.frames.size());
  }
  const std::optional<Settings> settings = settings_from(document, member_of(document, 0, "options"));
  if (!settings || settings->empty()) refuse_report(path, "options");
  known.settings = *settings;
  const JsonNode& frames = need(document, 0, "frames", JsonKind::array);
  if (!known.shard) known.frames.resize(frames.children), known.digests.resize(frames.children);
  std::size_t number = known.shard ? static_cast<std::size_t>(known.shard->part - 1) : 0;
  for (JsonIndex i = frames.first_child; i; i = document[i].next) {
    if (document[i].kind != JsonKind::object || number >= known.frames.size()) refuse_report(path, "frames");
    known.frames[number] = need(document, i, "file", JsonKind::string, true).string;
    known.digests[number] = need(document, i, "sha256", JsonKind::string, true).string;
    number += known.shard ? static_cast<std::size_t>(known.shard->of) : 1;
  }
  return known;
}

std::size_t take_known_frames(const std::string& path, FrameDigests& wanted) {
  std::size_t count = 0;
  try {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return 0;
    const FrameDigests known = read_digests(path);
    if (known.settings != wanted.settings) return 0;
    for (std::size_t i = 0; i < std::min(known.digests.size(), wanted.digests.size()); ++i) {
      if (wanted.shard && !has_frame(*wanted.shard, i)) continue;
      if (known.digests[i].empty() || !is_whole_frame(wanted.frames[i], known.digests[i])) continue;
      wanted.digests[i] = known.digests[i];
      ++count;
    }
  } catch (const InputError&) { // no report of ours: then every frame is made
  }
  return count;
}

} // namespace refraster
