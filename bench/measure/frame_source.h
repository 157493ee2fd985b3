#pragma once
// How the frames of a benchmark are made: as a program does that shows one after the other.

#include <refraster/render.h>

namespace refraster::bench {

class FrameSource {
public:
  /// Valid until the next call.
  const Frame& draw(const Scene& scene, const RenderOptions& options) {
    renderer_.render(scene, options, frame_);
    return frame_;
  }

private:
  Renderer renderer_;
  Frame frame_;
};

} // namespace refraster::bench
