#pragma once
// Files that are given where a scene is expected: what they are, and how to get a scene.

#include <refraster/notes.h>

#include <optional>
#include <string>

namespace refraster {

/// An error with advice (InputError::advice) if the file is something else than a scene: a mesh of a known format, an
/// image, a measured table, GLSL, UTF-16 text, another binary file, an empty file, or a folder. Told by the first
/// bytes, and by the name where they say nothing. Nothing for text that may be JSON, and for a file that cannot be
/// read: what reads the scene has its own errors for both.
///
/// The advice holds a whole scene file that can be copied, for an OBJ file one that shows it; for another mesh it says
/// how to make an OBJ file of it.
std::optional<InputError> not_a_scene(const std::string& path);

/// The same for a file that has turned out to be glTF, which is JSON as scenes are.
InputError gltf_is_no_scene(const std::string& path);

/// Whether a file begins as JSON does, with comments: then it is judged as a scene, whatever its name is. For a regular
/// file.
bool holds_json(const std::string& path);

} // namespace refraster
