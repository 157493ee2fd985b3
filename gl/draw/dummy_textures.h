#pragma once
// What samplers read that nobody sets.

#include "gl/context/gl_api.h"

#include <map>

namespace refraster {

/// One texture and one texture unit for each type of sampler that is asked for: samplers of different types on one unit
/// would make a draw an error (OpenGL 4.6 core, 11.1.3.11), and those of one type share, so that units never run out.
/// Whatever is read of a texture is (0, 0, 0, 1), as of one that is incomplete (8.17), and a comparison is one with
/// depth 1, so that nothing is in shadow.
class DummyTextures {
public:
  /// Units from `first_unit` on are this object's, and must not be bound to otherwise.
  DummyTextures(const GlApi& gl, GLint first_unit) : gl_(gl), first_unit_(first_unit) {}

  /// The unit for samplers of this type, its texture bound. Unit 0 is the active one afterwards. There are 40 types, so
  /// that with first_unit <= 8 all units are among the 48 that every OpenGL 3.3 has (table 23.60).
  GLint unit_of(GLenum sampler_type);

private:
  const GlApi& gl_;
  GLint first_unit_;
  std::map<GLenum, GLint> units_; // by type
};

} // namespace refraster
