#pragma once
// The text of a small scene file, for messages.

#include "math/vec.h"

#include <optional>
#include <string>

namespace refraster {

/// A box around points, least and greatest coordinates.
struct Box {
  Double3 least, most;
};

/// A box around all vertices of an OBJ file, whatever else is in it; of its first gigabyte, if there is more. Nothing
/// if there is none, or if the file cannot be read.
std::optional<Box> obj_vertex_box(const std::string& path);

/// A scene that shows a lit sphere and needs no other file.
std::string example_scene();

/// A scene that shows this OBJ file, a path relative to the scene's folder, to a camera that sees all of the box.
std::string example_scene(const std::string& obj_file_path, const Box& box);

} // namespace refraster
