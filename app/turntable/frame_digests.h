#pragma once
// What is known of the frames of a turntable: a report beside them, by which an interrupted run goes on, and by which
// shards are joined.

#include <refraster/image.h>

#include "io/parts/settings.h"
#include "io/parts/shard.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Of one turntable.
inline constexpr int max_frames = 100'000;

/// The report. docs/reports.md
struct FrameDigests {
  std::string scene;                // as named by the user
  Settings settings;                // all that decides the frames' pixels and files
  std::vector<std::string> frames;  // their names; of a film "": they are its own
  std::vector<std::string> digests; // sha256 of each: of the file, of a film's the bytes of its pixels; empty: not made
  std::optional<Shard> shard = {};  // if only its frames are made
};

/// As JSON, members always in the same order.
std::string digests_json(const FrameDigests& known);

/// What digests_json has made. Throws InputError for a file that is no report of frames, or that cannot be read.
FrameDigests read_digests(const std::string& path);

/// How many of `wanted` need not be made again: their digests are filled in from the report at `path` where that is of
/// the same settings, and each file is there and whole. 0 where there is no report, or none that can be read.
std::size_t take_known_frames(const std::string& path, FrameDigests& wanted);

/// What a film's frame has for a digest.
std::string pixels_sha256(const Image<std::uint8_t>& rgb8);

/// Whether a file is there, and is what its digest says.
bool is_whole_frame(const std::string& path, std::string_view digest);

} // namespace refraster
