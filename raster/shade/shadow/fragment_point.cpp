#include "raster/shade/shadow/fragment_point.h"

#include "raster/shade/corner_values.h"
#include "raster/visibility/bin.h"
#include "raster/visibility/snapped_setup.h"

namespace refraster {

FragmentPoints::FragmentPoints(const FrameContext& context, std::uint32_t number) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const std::array<WindowVertex, 3> window = window_corners(context.geometry, ref);
  const WorldTriangle world = context.shadows->triangle(number);
  const auto put_in_order = [&](const std::array<std::uint8_t, 3>& corner) {
    corner_ = {world[corner[0]], world[corner[1]], world[corner[2]]};
  };
  if ((window[0].outcode | window[1].outcode | window[2].outcode) & outcode::unsnapped) {
    const ProjectiveTriangle& triangle = context.bins.projective_triangle(number);
    put_in_order(triangle.corner);
    projective_.emplace(triangle); // its edge functions bring their weights
    return;
  }
  snapped_ = set_up_snapped(window);
  if (!snapped_) return; // no area: nothing is seen of it
  const auto& corner = snapped_->corner;
  put_in_order(corner);
  const std::array<double, 3> weights = perspective_weights<double>(
      {window[corner[0]].inverse_w, window[corner[1]].inverse_w, window[corner[2]].inverse_w});
  for (std::size_t k = 0; k < 3; ++k) weight_[k] = max(weights[k], min_weight<double>);
}

SurfacePoint FragmentPoints::at(std::int32_t x, std::int32_t y) const {
  std::array<double, 3> value{};
  if (projective_) value = projective_values<double>(*projective_, x, y).value;
  else if (snapped_)
    for (std::size_t k = 0; k < 3; ++k) value[k] = static_cast<double>(snapped_->edge[k].at(x, y));
  SurfacePoint point{corner_, {}};
  for (std::size_t k = 0; k < 3; ++k) point.weight[k] = max(value[k] * weight_[k], 0.0);
  return point;
}

} // namespace refraster
