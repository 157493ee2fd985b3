#pragma once
// Frames that shards of a turntable have made, joined.

#include "app/diagnostics.h"
#include "app/turntable/frame_digests.h"

#include <string>
#include <vector>

namespace refraster {

/// What is known to be all frames: their digests, and where each is.
struct WholeTurn {
  FrameDigests known; // as of one run, but for the names
  std::vector<std::string> paths;
};

/// Reads the reports of shards, in any order, which stand beside their frames, and all frames. Throws InputError with
/// what is missing, there twice, of another scene or other options than the first, or not what the report says.
WholeTurn read_turn(const std::vector<std::string>& reports);

/// Puts all frames at the names of a pattern, and their report beside them: the files of one run. Gives the frames'
/// paths. Throws InputError, OutputError; UsageError for a name of another format.
std::vector<std::string> collect_frames(WholeTurn turn, const std::string& pattern, const Diagnostics& diagnostics);

/// A film of all frames, which are images of 8 bits, and its report. False if it was interrupted. Throws likewise.
bool film_frames(WholeTurn turn, const std::string& path, int frames_per_second, const Diagnostics& diagnostics);

} // namespace refraster
