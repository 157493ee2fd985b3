#include "raster/shade/shadow/fragment_point.h"

#include "raster/shade/corner_values.h"
#include "raster/visibility/bin.h"
#include "raster/visibility/snapped_setup.h"

namespace refraster {

FragmentPoints::FragmentPoints(const FrameContext& context, std::uint32_t number) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const std::array<WindowVertex, 3> window = window_corners(context.geometry, ref);
  std::array<WorldVertex, 3> world = world_corners(context.geometry, ref);
  if (context.shadows->has_exact()) { // the very corners that its neighbours in the tree have
    const WorldTriangle in_tree = context.shadows->triangle(number);
    for (std::size_t k = 0; k < 3; ++k) world[k].position = in_tree[k];
  }
  const auto put_in_order = [&](const std::array<std::uint8_t, 3>& corner) {
    for (std::size_t k = 0; k < 3; ++k) corner_[k] = world[corner[k]].position, normal_[k] = world[corner[k]].normal;
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

std::array<double, 3> FragmentPoints::weights_at(std::int32_t x, std::int32_t y) const {
  std::array<double, 3> value{};
  if (projective_) value = projective_values<double>(*projective_, x, y).value;
  else if (snapped_)
    for (std::size_t k = 0; k < 3; ++k) value[k] = static_cast<double>(snapped_->edge[k].at(x, y));
  for (std::size_t k = 0; k < 3; ++k) value[k] *= weight_[k];
  return value;
}

SurfacePoint FragmentPoints::at(std::int32_t x, std::int32_t y) const {
  SurfacePoint point{corner_, weights_at(x, y)};
  for (double& weight : point.weight) weight = max(weight, 0.0);
  return point;
}

InterpolatedPoint FragmentPoints::interpolated_at(std::int32_t x, std::int32_t y) const {
  const std::array<double, 3> weight = weights_at(x, y);
  const double sum = weight[0] + weight[1] + weight[2];
  InterpolatedPoint point{corner_[0], normal_[0]};
  for (std::size_t k = 1; k < 3; ++k) {
    const double part = weight[k] / sum;
    point.position += (corner_[k] - corner_[0]) * part, point.normal += (normal_[k] - normal_[0]) * part;
  }
  return point;
}

} // namespace refraster
