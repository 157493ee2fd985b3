#pragma once
// The run report: what made an image, how long it took, what it met.

#include <refraster/render.h>

#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// Everything in the report of one `refraster render`.
struct RunReport {
  std::string scene;                // as named by the user
  std::vector<std::string> outputs; // files written
  int width = 0, height = 0;        // of the full image
  std::optional<PixelRect> crop;
  std::string precision;
  int samples = 1;
  int tile_size = 0;
  int threads = 0;
  double read_seconds = 0, write_seconds = 0; // of the scene and its files; of the images
  StageSeconds seconds;
  FrameCounts counts;
  std::vector<std::string> notes; // on its files, and on an image that shows nothing
};

/// The report as JSON, members always in the same order. docs/reports.md describes them.
std::string report_json(const RunReport& report);

} // namespace refraster
