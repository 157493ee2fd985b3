#pragma once
// Which triangles cover a point of the window: all of them, not only the nearest, so that any depth test and any
// culling can be tried on them.

#include <refraster/render.h>

#include "raster/visibility/bin.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster::hypotheses {

/// A place of the window, in subpixels.
struct WindowPoint {
  std::int32_t x = 0, y = 0;
};

/// A triangle that covers a point.
struct Covering {
  std::uint32_t triangle = 0; // its number in the frame
  std::uint32_t object = 0;
  double inverse_w = 0; // 1 / distance along the line of sight
  Facing facing = Facing::front;
  double opacity = 1;   // at the centre of the pixel that holds the point
  double threshold = 0; // below this opacity the surface is cut out
};

/// A scene at a size, through the product's own vertex stage, binning and set-up: coverage is that of a frame. Nothing
/// is culled, and the depth planes stand sixteen times as far apart as the scene's on either side.
class WindowGeometry {
public:
  WindowGeometry(const Scene& scene, int width, int height, int threads);
  WindowGeometry(const WindowGeometry&) = delete;

  /// For each point those that cover it, in the order of submission. Points outside the image are covered by nothing.
  std::vector<std::vector<Covering>> covering(std::span<const WindowPoint> points) const;

  /// The scene with the planes moved; its materials, lights and meshes are those of the scene.
  const FrameContext& context() const { return context_; }

private:
  void add_covering(std::size_t tile, std::span<const std::size_t> in_tile, std::span<const WindowPoint> points,
                    std::vector<std::vector<Covering>>& result) const;

  Scene scene_;
  RenderOptions options_;
  Geometry geometry_;
  Bins bins_;
  FrameContext context_;
};

} // namespace refraster::hypotheses
