#pragma once
// The point of a triangle that a fragment asks for shadows at.

#include "raster/frame_context.h"
#include "raster/shade/projective_edges.h"
#include "raster/shadow/scene_shadows.h"
#include "raster/visibility/setup.h"

#include <array>
#include <cstdint>
#include <optional>

namespace refraster {

/// A point of a surface as it is interpolated, in double: what a map is asked with.
struct InterpolatedPoint {
  Double3 position, normal; // world space; the normal of any length
};

/// Points of one triangle of a frame.
class FragmentPoints {
public:
  /// Of the triangle of that number, which is drawn, or could be.
  FragmentPoints(const FrameContext& context, std::uint32_t number);

  /// What is seen at (x, y), in subpixels of the window: the values of the edge functions there times the weights of
  /// perspective interpolation, all as the precision `double` has them. Those below 0 count as 0: a pixel's centre may
  /// lie beside the triangle of which only other samples are covered, and then a point of its edge stands for it.
  SurfacePoint at(std::int32_t x, std::int32_t y) const;

  /// The same as attributes are interpolated: no weight is cut off, so that the point may lie beside the triangle.
  InterpolatedPoint interpolated_at(std::int32_t x, std::int32_t y) const;

private:
  std::array<double, 3> weights_at(std::int32_t x, std::int32_t y) const;

  WorldTriangle corner_;          // in the order of the set-up
  std::array<Double3, 3> normal_; // of the same corners
  std::array<double, 3> weight_{1, 1, 1};
  std::optional<SnappedTriangle> snapped_;
  std::optional<ProjectiveEdges> projective_;
};

} // namespace refraster
