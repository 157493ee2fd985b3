#pragma once
// Cameras, one a frame.

#include <refraster/scene.h>

#include "raster/vertex/scene_view.h"

#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// A camera, or one that is still to be placed.
struct PathCamera {
  Camera camera;
  std::optional<CameraFit> fit;
};

/// Reads a JSON list of cameras, each an object as "camera" of a scene file: docs/scene-format.md. What one leaves out,
/// but for its position and target, is as in `otherwise`. At least one. Throws InputError with all faults.
std::vector<PathCamera> read_cameras(const std::string& path, const Camera& otherwise);

} // namespace refraster
