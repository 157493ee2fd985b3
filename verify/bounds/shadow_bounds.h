#pragma once
// How much of the lights with shadow maps a device may see at a surface.

#include "math/bounds/affine_functions.h"
#include "raster/shade/shadow/fragment_point.h"
#include "raster/shadow/scene_shadows.h"
#include "shading/light_spans.h"
#include "verify/bounds/device_depth_map.h"

#include <memory>
#include <span>
#include <vector>

namespace refraster {

/// Which way comparisons with a map go that a device may decide either way.
enum class OpenComparisons {
  either, ///< each of them
  as_ours ///< as in the reference
};

/// Of a device's frame of a scene with shadow maps.
class DeviceShadows {
public:
  using Bounds = Affine<DeviceArithmetic>;

  /// `frame`: of the scene, laid out; the reference's maps are drawn.
  DeviceShadows(const FrameInput& frame, const Geometry& geometry, const DeviceProfile& profile);

  /// The reference's.
  const SceneShadows& ours() const { return ours_; }

  /// A surface: what a device may have interpolated, the normal of any length; and what the reference has.
  struct At {
    Vec3<Bounds> position, normal;
    InterpolatedPoint ours;
  };
  /// Of each light with a shadow, in the order of the sum; of an exact one anything. Where comparisons are open and
  /// make all or nothing of a light, they are followed each way (Forks). Uses the thread's device arithmetic.
  std::span<const VisibilityRange> ranges(const At& at, OpenComparisons open,
                                          std::vector<VisibilityRange>& memory) const;

private:
  Scene casters_;
  SceneShadows ours_;
  std::vector<std::unique_ptr<DeviceDepthMap>> maps_; // in the order of the reference's
};

} // namespace refraster
