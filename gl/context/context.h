#pragma once
// OpenGL without a window.

#include "gl/context/gl_api.h"
#include "gl/render_gl.h"

namespace refraster {

/// A core context of OpenGL 3.3 or later, current on this thread while it lives. All GL objects end with it.
class GlContext {
public:
  /// Throws NoOpenGl if there is no EGL library, no driver, none as new as 3.3, or not the one asked for. A software
  /// driver is asked for by GALLIUM_DRIVER and LIBGL_ALWAYS_SOFTWARE, which stay set in this process, as do the
  /// variables that turn Mesa's cache of shaders off.
  explicit GlContext(GlRenderer wanted);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  const GlApi& gl() const { return gl_; }
  const GlDriver& driver() const { return driver_; }

private:
  void open(GlRenderer wanted, const std::string& what_to_do);
  void close();

  void *display_ = nullptr, *context_ = nullptr; // EGLDisplay, EGLContext
  GlApi gl_;
  GlDriver driver_;
};

} // namespace refraster
