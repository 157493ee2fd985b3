#pragma once
// What of a scene OpenGL does not draw as it is.

#include <refraster/scene.h>

#include <string>

namespace refraster {

/// Throws InputError, exit code 3, for a scene with an exact shadow, which a rasterizer of triangles has no means to
/// cast. `path`: the scene's file, or empty.
void check_drawn_by_gl(const std::string& path, const Scene& scene);

} // namespace refraster
