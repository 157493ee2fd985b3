#pragma once
// How the frames of a benchmark are made: as a program does that shows one after the other.

#include "raster/render.h"

namespace refraster::bench {

class FrameMaker {
public:
  /// Valid until the next call.
  const Frame& draw(const Scene& scene, const RenderOptions& options) {
    frame_ = render(scene, options);
    return frame_;
  }

private:
  Frame frame_;
};

} // namespace refraster::bench
