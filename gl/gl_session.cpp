#include "gl/gl_session.h"

#include "gl/context/context.h"
#include "gl/context/frame_timer.h"
#include "gl/context/target.h"
#include "gl/draw/drawing.h"

#include <optional>

namespace refraster {

struct GlSession::State {
  GlContext context;
  std::optional<GlDrawing> drawing;

  State(const Scene& scene, const GlOptions& options) : context(options.renderer) {
    make_target(context.gl(), GL_RGBA8, options);
    drawing.emplace(context.gl(), scene, options);
    drawing->draw_checked();
    context.gl().Finish();
  }

  void draw() const {
    drawing->draw(GlPass::colour);
    context.gl().Finish();
  }
};

GlSession::GlSession(const Scene& scene, const GlOptions& options) : state_(std::make_unique<State>(scene, options)) {}
GlSession::~GlSession() = default;

const GlDriver& GlSession::driver() const {
  return state_->context.driver();
}

GlTimes GlSession::draw_timed() {
  return time_frames(1, [this] { state_->draw(); });
}

} // namespace refraster
