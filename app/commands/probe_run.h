#pragma once
// refraster gl --probe

#include "app/command.h"
#include "app/diagnostics.h"
#include "gl/gl_names.h"

#include <string>

namespace refraster {

struct ProbeArguments {
  std::string output; // a JSON file; "-" or nothing: standard output
  std::string device; // the profile to compare with; may be empty
  GlRenderer renderer = GlRenderer::system_default;
  Diagnostics diagnostics;
};

/// Measures the profile of a device and writes it. With a device to compare with, that one's renderer and environment
/// are measured, and the exit code is `differ` if it allows less than was measured.
ExitCode run_probe(const ProbeArguments& arguments);

} // namespace refraster
