#pragma once
// What OpenGL draws of a picture with more samples a pixel than it has.

#include "gl/render_gl.h"

#include <optional>
#include <string>

namespace refraster {

/// What draw(samples) returns, with the samples of the scene's own picture. Where this OpenGL has not as many, and
/// nobody asked for them by an option, they become as many as it has below, and `note` says so. Throws what draw does.
template <class Draw>
auto draw_with_samples(int& samples, const std::optional<int>& asked, std::string& note, const Draw& draw) {
  try {
    return draw(samples);
  } catch (const NoSuchSamples& error) {
    if (asked) throw;
    note = std::string(error.what()) + ": drawn with " + std::to_string(error.fewer());
    samples = error.fewer();
  }
  return draw(samples);
}

} // namespace refraster
