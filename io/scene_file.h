#pragma once
// The scene file: docs/scene-format.md.

#include "raster/scene.h"

#include <string>

namespace refraster {

/// Reads a scene with every file that it names: meshes, textures, measured tables. A file named twice is loaded once.
/// Throws InputError with all faults: of the scene in the order of the file, then of the files it names.
/// mesh_cache: a folder of large meshes that were read before (io/mesh_cache.h); none if empty.
Scene read_scene(const std::string& path, const std::string& mesh_cache = {});

/// The keys of a scene file as Markdown tables, made from the declaration that the reader follows.
std::string scene_format_markdown();

} // namespace refraster
