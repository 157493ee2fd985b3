#pragma once
// Cameras, one a frame.

#include <refraster/scene.h>

#include <string>
#include <vector>

namespace refraster {

/// Reads a JSON list of cameras, each an object as "camera" of a scene file: docs/scene-format.md. What one leaves out, but
/// for its position and target, is as in `otherwise`. At least one. Throws InputError with all faults.
std::vector<Camera> read_cameras(const std::string& path, const Camera& otherwise);

} // namespace refraster
