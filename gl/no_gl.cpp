// Stands in for the renderer in a program that was built without OpenGL headers.

#include "gl/context/driver.h"
#include "gl/gl_session.h"
#include "gl/probe/probe_device.h"

namespace refraster {
namespace {

[[noreturn]] void fail() {
  throw NoOpenGl("this program was built without OpenGL; install the headers (Debian: libegl-dev libgl-dev), then run "
                 "cmake and build again");
}

} // namespace

GlFrame render_gl(const Scene&, const GlOptions&) {
  fail();
}

GlDriver driver_of(GlRenderer) {
  fail();
}

DeviceFacts probe_device(GlRenderer) {
  fail();
}

struct GlSession::State {
  GlDriver driver;
};
GlSession::GlSession(const Scene&, const GlOptions&) {
  fail();
}
GlSession::~GlSession() = default;
const GlDriver& GlSession::driver() const {
  return state_->driver;
}
GlTimes GlSession::draw_timed() {
  fail();
}

} // namespace refraster
