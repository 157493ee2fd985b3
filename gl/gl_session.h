#pragma once
// A scene that stays in OpenGL, to be drawn again and again.

#include "gl/render_gl.h"

#include <memory>

namespace refraster {

/// Set up once: driver, shaders, uploads, an RGBA8 target, and one frame for what drivers put off until then. While one
/// lives no other may be made, and render_gl not be called, in the same process: a context is current, and a driver is
/// chosen by the environment.
class GlSession {
public:
  /// Throws NoOpenGl; InputError for GLSL that does not compile, link or draw. Of the options, size, samples,
  /// renderer and merl_filter count.
  GlSession(const Scene& scene, const GlOptions& options);
  ~GlSession();
  GlSession(const GlSession&) = delete;
  GlSession& operator=(const GlSession&) = delete;

  const GlDriver& driver() const;

  /// Clears and draws, and waits until it is done: wall time and the process's CPU time of that.
  GlTimes draw_timed();

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace refraster
