#pragma once
// The run report: what made an image, how long it took, what it met.

#include "raster/render.h"

#include <string>
#include <vector>

namespace refraster {

/// The build of this program, as its compiler saw it.
struct BuildInfo {
  std::string version;  // of refraster: "0.1.0"
  std::string compiler; // "g++ 12.2.0"
  std::string type;     // CMake's: "Release"
  std::string march;    // what the build asked for: "native"
  std::string isa;      // what that means here: "x86-64-v4"
  std::string flags;    // of the compiler, for all that makes pixels
};
BuildInfo this_build();

/// Everything in the report of one `refraster render`.
struct RunReport {
  std::string scene;                // as named by the user
  std::vector<std::string> outputs; // files written
  int width = 0, height = 0;        // of the full image
  std::vector<Crop> crop;           // none or one
  std::string rung;
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
