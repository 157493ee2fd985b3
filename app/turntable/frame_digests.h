#pragma once
// What is known of the frames of a turntable: a report beside them, by which an interrupted run goes on.

#include <string>
#include <vector>

namespace refraster {

/// The report. docs/reports.md
struct FrameDigests {
  std::string scene;                 // as named by the user
  std::string settings;              // sha256 of all that decides the frames' pixels and files
  std::vector<std::string> frames;   // their names; of a film "": they are its own
  std::vector<std::string> digests;  // sha256 of each: of the file, of a film's the bytes of its pixels; empty: not made
};

/// As JSON, members always in the same order.
std::string digests_json(const FrameDigests& known);

/// How many of `wanted` need not be made again: their digests are filled in from the report at `path` where that is of the
/// same settings, and each file is there and whole. 0 where there is no report, or none that can be read.
std::size_t take_known_frames(const std::string& path, FrameDigests& wanted);

} // namespace refraster
