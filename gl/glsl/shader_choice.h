#pragma once
// Whose GLSL draws an object.

#include "gl/program/program.h"
#include "gl/render_gl.h"

namespace refraster {

struct ShaderChoice {
  ShaderText vertex, fragment;
  std::string why; // one line for people
  bool vertex_of_scene = false, fragment_of_scene = false;
};

/// The files that the object names where they exist, each for itself; else ours. Throws InputError if one is there and
/// cannot be read, or none is there of a fragment function that we have no GLSL of. A file that asks for a newer GLSL
/// than `newest_version` (330 for 3.30), as the lecture's 410 may on a driver of OpenGL 3.3, is given to the compiler
/// with that version instead: most such files use nothing newer.
ShaderChoice choose_shaders(const Scene& scene, const Object& object, MerlFilter filter, int newest_version);

} // namespace refraster
