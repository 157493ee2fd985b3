#pragma once
// Whether two scenes are the same.

#include <refraster/scene.h>

#include <string>

namespace refraster {

/// 64 hexadecimal digits, different for scenes of which anything differs that a frame may show: the bytes of the file
/// at `path`, and what `scene`, which was read from it, has from other files, meshes, their materials, textures,
/// measured tables; and from options: lights, places of objects, the background. Not the camera, nor what only OpenGL
/// reads. Throws InputError.
std::string scene_digest(const std::string& path, const Scene& scene);

} // namespace refraster
