// Stands in for the renderer in a program that was built without OpenGL headers.

#include "verify/gl/render_gl.h"

namespace refraster {

GlFrame render_gl(const Scene&, const GlOptions&) {
  throw NoOpenGl("this program was built without OpenGL; install the headers (Debian: libegl-dev libgl-dev), then run "
                 "cmake and build again");
}

} // namespace refraster
