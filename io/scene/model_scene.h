#pragma once
// The scene that shows a model: docs/models.md.

#include <refraster/memory.h>

#include <string>

namespace refraster {

/// Whether a path names a model: a file that ends in .obj, in any case, and holds no JSON.
bool is_model(const std::string& path);

/// The text of a scene that shows an OBJ file, a path relative to the scene's folder: with the file's own materials, a
/// camera that sees all of it, and lights that move with the camera.
std::string model_scene_text(const std::string& obj_file_path);

/// The same of a model by its path, for a scene beside it. Throws InputError for a file that cannot be read, an empty
/// one, and a name that is no UTF-8, which JSON cannot hold.
std::string scene_text_of_model(const std::string& path);

/// The text of a scene file, or of the scene that shows a model. Throws InputError for what is neither.
std::string scene_text(const std::string& path, const MemoryBudget& memory);

} // namespace refraster
