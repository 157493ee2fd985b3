#pragma once
// Whose GLSL draws an object.

#include "verify/gl/program.h"
#include "verify/gl/render_gl.h"

namespace refraster {

struct ShaderChoice {
  ShaderText vertex, fragment;
  std::string why; // one line for people
};

/// The files that the object names where they exist, each for itself; else ours. Throws InputError if one is there and
/// cannot be read.
ShaderChoice choose_shaders(const Scene& scene, const Object& object, MerlFilter filter);

} // namespace refraster
