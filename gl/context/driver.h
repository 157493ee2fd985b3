#pragma once
// The driver, for those who do not draw: as render_gl.h, it can be asked where OpenGL's headers are not.

#include "gl/render_gl.h"

namespace refraster {

/// Who would draw. Throws NoOpenGl. Sets what of the environment render_gl() sets, and is, like that, not to be called
/// from two threads at once.
GlDriver driver_of(GlRenderer renderer);

} // namespace refraster
