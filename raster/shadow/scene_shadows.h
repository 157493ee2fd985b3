#pragma once
// The shadows of a frame: what every surface point asks.

#include "raster/frame_context.h"
#include "raster/shadow/triangle_tree.h"
#include "raster/vertex/transform.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace refraster {

/// Which lights of a scene have shadows, and what may lie between them and a surface: every triangle of the scene with
/// finite corners, whether it is in view, culled, cut out by an opacity map or not.
class SceneShadows {
public:
  /// Of a frame that is laid out. Throws OutOfMemory where the frame's budget does not allow what it is known to need.
  /// May have been another frame's: its memory is used again.
  void build(const FrameInput& frame, const Geometry& geometry);

  /// The lights with shadows, in the order of the sum.
  std::span<const LightPlace> lights() const { return lights_; }

  /// The corners of a triangle, by its number in the frame, in the order of the mesh.
  WorldTriangle triangle(std::uint32_t number) const { return mesh_.at(number); }

  /// Whether a point of the triangle of that number sees a light of lights().
  bool sees(const SurfacePoint& point, std::uint32_t number, const LightPlace& light) const {
    return !tree_.any_crosses(mesh_, ShadowRay(point, light), number);
  }
  /// The triangle of the lowest number that takes the light; none where it is seen.
  std::optional<std::uint32_t> first_between(const SurfacePoint& point, std::uint32_t number,
                                             const LightPlace& light) const {
    return tree_.first_crossed(mesh_, ShadowRay(point, light), number);
  }

private:
  std::vector<LightPlace> lights_;
  WorldMesh mesh_;
  TriangleTree tree_;
};

} // namespace refraster
