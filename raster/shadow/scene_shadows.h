#pragma once
// The shadows of a frame: what every surface point asks.

#include "raster/frame_context.h"
#include "raster/shadow/map/depth_map.h"
#include "raster/shadow/triangle_tree.h"
#include "raster/vertex/transform.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace refraster {

/// A light with a shadow.
struct ShadowedLight {
  Shadow kind = Shadow::exact;
  LightPlace place;
  std::size_t map = 0; // of the frame's depth maps, of one with a map
};

/// Which lights of a scene have shadows, and what may lie between them and a surface: every triangle of the scene with
/// finite corners, whether it is in view, culled, cut out by an opacity map or not.
class SceneShadows {
public:
  /// Of a frame that is laid out. Throws OutOfMemory where the frame's budget does not allow what it is known to need.
  /// May have been another frame's: its memory is used again.
  void build(const FrameInput& frame, const Geometry& geometry);

  /// The lights with shadows, in the order of the sum.
  std::span<const ShadowedLight> lights() const { return lights_; }
  bool has_exact() const { return has_exact_; }
  bool has_maps() const { return used_maps_ > 0; }

  /// The map of a light that has one.
  const DepthMap& map(const ShadowedLight& light) const { return maps_[light.map]; }

  // Of exact shadows; `number`: of the triangle that the point lies on, in the frame.

  /// The corners of a triangle, by its number in the frame, in the order of the mesh.
  WorldTriangle triangle(std::uint32_t number) const { return mesh_.at(number); }
  /// Whether the point sees a light of lights().
  bool sees(const SurfacePoint& point, std::uint32_t number, const LightPlace& light) const {
    return !tree_.any_crosses(mesh_, ShadowRay(point, light), number);
  }
  /// The triangle of the lowest number that takes the light; none where it is seen.
  std::optional<std::uint32_t> first_between(const SurfacePoint& point, std::uint32_t number,
                                             const LightPlace& light) const {
    return tree_.first_crossed(mesh_, ShadowRay(point, light), number);
  }

private:
  void build_tree(const FrameInput& frame, const Geometry& geometry);
  void draw_maps(const FrameInput& frame);

  std::vector<ShadowedLight> lights_;
  bool has_exact_ = false;
  WorldMesh mesh_;
  TriangleTree tree_;
  std::vector<DepthMap> maps_; // more than are used, of frames before
  std::size_t used_maps_ = 0;
  DepthMapScratch scratch_;
};

} // namespace refraster
