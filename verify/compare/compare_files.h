#pragma once
// Two image files, compared in every way that a report or a page says something of.

#include <refraster/files.h>

#include "verify/compare/compare_report.h"
#include "verify/images/image_pair.h"

#include <functional>
#include <optional>
#include <string>

namespace refraster {

/// What is compared, and how.
struct CompareRequest {
  std::string a, b;
  PairRequest pair;     // its limit_levels follows from the limits
  CompareLimits limits; // in the unit
  CompareUnit unit = CompareUnit::levels;
  std::string scene = {}; // for the report
  /// What the pixels of images of this size see, where that is known; asked once both are read.
  std::function<std::optional<SeenObjects>(int width, int height, NoteList& notes)> seen = {};
  MemoryBudget memory = {};
};

/// What was found, with what a page needs beside.
struct FileComparison {
  ImagePair images;
  PixelScale scale;
  ComparisonReport report;
  std::optional<SeenObjects> seen;
};

/// Throws InputError as read_image_pair() does.
FileComparison compare_files(const CompareRequest& request);

/// The same of images that are there.
FileComparison compare_pair(ImagePair images, const CompareRequest& request);

/// For CompareRequest::seen: reads the scene, and throws InputError, of `image`, where images are too large for it.
std::function<std::optional<SeenObjects>(int width, int height, NoteList& notes)>
objects_of_scene(const std::string& scene, const SceneOptions& reading, const std::string& image);

/// How different the images look: verify/compare/flip.h. Throws InputError where FLIP is not defined: it takes what a
/// screen shows, and nothing says how that follows from values without bounds, or from channels that are no colour.
double flip_of(const FileComparison& found);

/// The page of it. Some tens of bytes a pixel, asked of `memory`; `path` names it there. Throws OutOfMemory.
std::string comparison_html(const FileComparison& found, const std::string& path, const MemoryBudget& memory);

} // namespace refraster
