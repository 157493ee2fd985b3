#include "verify/bounds/device_frame.h"

#include "verify/bounds/shadow_bounds.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

Double3 magnitudes(const Float3& v) {
  return {std::abs(static_cast<double>(v.x)), std::abs(static_cast<double>(v.y)), std::abs(static_cast<double>(v.z))};
}
Double4x4 magnitudes(const Double4x4& m) {
  Double4x4 result;
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) result[c][r] = std::abs(m[c][r]);
  return result;
}

/// Roundings that a product of a matrix and a point goes through: of the matrix's own numbers, of the product, and of
/// the three sums behind it. Of three matrices each, in whatever order they are multiplied.
constexpr double roundings_of_one = 5, roundings_of_three = 15;
/// Of a normal matrix that a shader makes itself, as the transpose of an inverse, by way of cofactors: those of the
/// model's numbers, of two products, their difference, the determinant (five operations) and the division.
constexpr double roundings_of_inverse = 10;

/// Of a vector that is made unit: half of those of three squares, two sums and, once each, of products with the root.
constexpr double roundings_of_unit = 4;

} // namespace

DeviceFrame::DeviceFrame(const Scene& scene, const RenderOptions& options, const DeviceProfile& profile,
                         ShaderMatrices matrices)
    : options_(options), profile_(profile), matrices_(matrices), context_{{scene, options_}, geometry_, bins_} {
  lay_out_frame();
  if (!has_shadows(scene, Shadow::map)) return;
  shadows_ = std::make_unique<DeviceShadows>(context_, geometry_, profile);
  context_.shadows = &shadows_->ours();
}

DeviceFrame::DeviceFrame(const Scene& scene, const RenderOptions& options, const DeviceProfile& profile,
                         ShaderMatrices matrices, const Viewpoint& viewpoint)
    : options_(options), profile_(profile), matrices_(matrices), context_{{scene, options_}, geometry_, bins_} {
  context_.viewpoint = viewpoint;
  lay_out_frame();
}

DeviceFrame::~DeviceFrame() = default;

void DeviceFrame::lay_out_frame() {
  transform(context_, geometry_);
  FrameCounts counts;
  bin_triangles(context_, geometry_, bins_, counts);
  const Camera& seen_from = context_.scene.camera;
  const double aspect = static_cast<double>(options_.width) / options_.height;
  const Double4x4 camera = magnitudes(clip_from_view(seen_from, aspect)) * magnitudes(view_from_world(seen_from));
  for (const ObjectTransform& object : geometry_.transforms) {
    const Double4x4 product = matrices_ == ShaderMatrices::one ? magnitudes(object.clip_from_object)
                                                               : camera * magnitudes(object.world_from_object);
    Magnitudes& of_object = magnitudes_.emplace_back();
    for (int r = 0; r < 4; ++r)
      of_object.clip[static_cast<std::size_t>(r)] = {product[0][r], product[1][r], product[2][r], product[3][r]};
  }
}

double DeviceFrame::clip_error(std::size_t object, int row, const Float3& position) const {
  const Double4& m = magnitudes_[object].clip[static_cast<std::size_t>(row)];
  const Double3 p = magnitudes(position);
  const double roundings = matrices_ == ShaderMatrices::one ? roundings_of_one : roundings_of_three;
  return roundings * profile_.operations.relative * (m.x * p.x + m.y * p.y + m.z * p.z + m.w);
}

double DeviceFrame::world_error(std::size_t object, int row, const Float3& position) const {
  const Double4x4& m = geometry_.transforms[object].world_from_object;
  const Double3 p = magnitudes(position);
  return roundings_of_one * profile_.operations.relative *
         (std::abs(m[0][row]) * p.x + std::abs(m[1][row]) * p.y + std::abs(m[2][row]) * p.z + std::abs(m[3][row]));
}

double DeviceFrame::normal_error(std::size_t object, int row, const Float3& normal) const {
  const Double3x3& m = geometry_.transforms[object].world_from_normal;
  const Double3 n = magnitudes(normal);
  const double roundings = roundings_of_one + (matrices_ == ShaderMatrices::three ? roundings_of_inverse : 0);
  return roundings * profile_.operations.relative *
         (std::abs(m[0][row]) * n.x + std::abs(m[1][row]) * n.y + std::abs(m[2][row]) * n.z);
}

/// With a the exact product, d what the device is off by, per component: a / |a| changes by at most |d| / |a| plus
/// |d_row| / |a|, up to |d| / |a| of that again; and unit() is off by its own roundings, of a dot product, its root and
/// the product.
double DeviceFrame::tangent_error(std::size_t object, int row, const Float3& tangent) const {
  const Double4x4& m = geometry_.transforms[object].world_from_object;
  const Double3 t = magnitudes(tangent);
  if (t == Double3(0)) return 0;
  const OperationErrors& operations = profile_.operations;
  Double3 off;
  for (int r = 0; r < 3; ++r)
    off[r] = roundings_of_one * operations.relative *
             (std::abs(m[0][r]) * t.x + std::abs(m[1][r]) * t.y + std::abs(m[2][r]) * t.z);
  const double size = glm::length(Double3x3(m) * Double3(tangent)), part = glm::length(off) / size;
  if (!(part < 0.25)) return std::numeric_limits<double>::infinity();
  const double moved = (part + off[row] / size) / (1 - 2 * part);
  return moved + roundings_of_unit * operations.relative + operations.root_relative + operations.quotient_relative;
}

} // namespace refraster
