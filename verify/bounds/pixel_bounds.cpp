#include "verify/bounds/pixel_bounds.h"

#include "raster/render_in.h"
#include "raster/shade/opacity.h"
#include "verify/bounds/shadow_bounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

namespace refraster {
namespace {

using Bounds = Affine<DeviceArithmetic>;
using EdgeValue = typename EdgeArithmetic<Bounds>::Value;

/// The device's errors, less the causes that are left out. What is left out of its arithmetic still is done in double.
OperationErrors errors_of(const DeviceProfile& profile, BoundCauses causes) {
  OperationErrors errors = profile.operations;
  if (!causes.has(BoundCause::arithmetic)) {
    errors.relative = errors.quotient_relative = errors.root_relative = DoubleArithmetic::relative;
    // Of these the profile's are in units of its own `relative`.
    const double scale = profile.operations.relative / errors.relative;
    errors.log2_units *= scale, errors.exp2_units *= scale, errors.exp2_units_by_exponent *= scale;
    errors.atan2_units = 2;
  }
  if (!causes.has(BoundCause::powers))
    errors.log2_units = errors.exp2_units = 1, errors.log2_absolute = errors.exp2_units_by_exponent = 0;
  return errors;
}

TextureErrors texture_errors_of(const DeviceProfile& profile, BoundCauses causes) {
  const TextureProfile& from = profile.texture;
  TextureErrors errors;
  if (causes.has(BoundCause::texture))
    errors.place = from.place_error, errors.nearest = from.nearest_error, errors.filter = from.filter_error,
    errors.mip = from.mip_error;
  if (causes.has(BoundCause::level_of_detail))
    errors.detail_below = from.detail_below, errors.detail_above = from.detail_above;
  return errors;
}

/// What a device may interpolate of a triangle at the centre of pixel (x, y); nothing where nothing is known. Sets the
/// device's arithmetic.
std::optional<SampleData<Bounds>> device_sample(const DeviceFrame& frame, const DeviceTriangle& triangle, int x, int y,
                                                BoundCauses causes) {
  const FrameContext& context = frame.context();
  const Object& object = frame.scene().objects[triangle.ref().object];
  const Material& material = material_of(object, triangle.ref().triangle);
  const std::array<WindowVertex, 3> window = window_corners(context.geometry, triangle.ref());
  const bool projective = ((window[0].outcode | window[1].outcode | window[2].outcode) & outcode::unsnapped) != 0;
  if (projective ? !context.bins.find_projective(triangle.number()) : !set_up_snapped(window)) return {};

  const DeviceProfile& profile = frame.profile();
  DeviceArithmetic::use(errors_of(profile, causes), texture_errors_of(profile, causes));
  const double centre_x = x + 0.5, centre_y = y + 0.5;
  std::optional<SampleData<Bounds>> result(std::in_place, context, triangle.number());
  SampleData<Bounds>& data = *result;
  // OpenGL's blocks begin at its row 0, the lowest: in an image of odd height at our odd rows.
  data.set_place_in_block(x & 1, (frame.height() - y) & 1);
  if (causes.has(BoundCause::interpolation)) {
    const Mesh& mesh = *object.mesh;
    const bool reads_uv = data.may_have_texture_coordinates() && is_textured(material);
    const bool reads_tangents = !mesh.tangents.empty() && material.turns_normals();
    for (int r = 0; r < attribute_rows; ++r) {
      if (r >= uv_row && r < uv_row + 2 && !reads_uv) continue;
      if (r >= uv_row + 2 && (r < tangent_row ? mesh.colours.empty() : !reads_tangents)) continue;
      const double error =
          triangle.attribute_error(r, centre_x, centre_y) * (r >= normal_row && r < uv_row ? data.normal_factor() : 1);
      if (!std::isfinite(error)) return {};
      data.add_error(r, error);
    }
  }
  if (causes.has(BoundCause::sample_shift) && any_texture(material, needs_derivatives)) {
    const double turned = triangle.turned();
    if (!(turned < 1)) return {};
    data.set_stretched(turned);
  }
  SampleShift shift = triangle.shift(centre_x, centre_y);
  if (!causes.has(BoundCause::sample_shift)) shift.radius = Double2(0);
  if (!std::isfinite(shift.radius.x + shift.radius.y)) return {};
  data.move_to(x * subpixels + subpixels / 2, y * subpixels + subpixels / 2,
               Affine<DoubleArithmetic>::along(Symbol::shift_x, shift.centre.x, shift.radius.x),
               Affine<DoubleArithmetic>::along(Symbol::shift_y, shift.centre.y, shift.radius.y));
  return result;
}

} // namespace

bool ColourBox::is_finite() const {
  return std::isfinite(lo.x + lo.y + lo.z) && std::isfinite(hi.x + hi.y + hi.z);
}

double ColourBox::width() const {
  const Double3 width = hi - lo;
  return std::max({width.x, width.y, width.z});
}

struct PixelBounder::Scratch {
  PacketBatch<Bounds> batch;
  std::vector<VisibilityRange> visibility;
};

ValueRange opacity_bounds(const DeviceFrame& frame, const DeviceTriangle& triangle, int x, int y) {
  const std::optional<SampleData<Bounds>> data = device_sample(frame, triangle, x, y, BoundCauses::all());
  if (!data) return {};
  const Object& object = frame.scene().objects[triangle.ref().object];
  const Bounds value = opacity(material_of(object, triangle.ref().triangle), *data);
  return {value.lo, value.hi};
}

PixelBounder::PixelBounder(const DeviceFrame& frame) : frame_(frame), scratch_(std::make_unique<Scratch>()) {}
PixelBounder::~PixelBounder() = default;

PixelBounds PixelBounder::bounds(const DeviceTriangle& triangle, int x, int y, BoundCauses causes) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  PixelBounds unknown{{Double3(-infinite), Double3(infinite)}, false, false};
  const FrameContext& context = frame_.context();
  const Object& object = frame_.scene().objects[triangle.ref().object];
  const Material& material = material_of(object, triangle.ref().triangle);
  if (material.user_function) return unknown;
  std::optional<SampleData<Bounds>> sample = device_sample(frame_, triangle, x, y, causes);
  if (!sample) return unknown;
  SampleData<Bounds>& data = *sample;

  const std::uint64_t met = Forks::open_comparisons();
  if (object.two_sided == TwoSided::yes) { // where it is open which side a device sees, either may be lit
    const Bounds facing(triangle.may_face_back() ? -1 : 1, triangle.may_face_front() ? 1 : -1);
    const Certainty front = facing >= Bounds(0);
    data.set_turned(is_mirrored(object) ? front : !front);
  }
  UndefinedCounts undefined;
  PacketBatch<Bounds>& batch = scratch_->batch;
  batch.packets = 1;
  batch.visibility = {};
  batch.in_use[0] = Certainty::yes;
  const UndefinedTally<Bounds> tally(undefined, Certainty::yes);
  packet_surface(context, material, data, tally, batch.surface[0]);
  if (const DeviceShadows* const shadows = frame_.shadows()) {
    const Barycentric<Bounds> at = barycentrics<Derivatives::no>(data).at;
    const std::int32_t centre_x = x * subpixels + subpixels / 2, centre_y = y * subpixels + subpixels / 2;
    batch.visibility.ranges =
        shadows
            ->ranges({batch.surface[0].position, attribute_value<&Mesh::normals>(context, data, at),
                      FragmentPoints(context, triangle.number()).interpolated_at(centre_x, centre_y)},
                     causes.has(BoundCause::shadows) ? OpenComparisons::either : OpenComparisons::as_ours,
                     scratch_->visibility)
            .data();
  }
  with_maps(material, [&]<Maps maps>(std::integral_constant<Maps, maps>, const auto& function) {
    if constexpr (maps == Maps::yes) batch.maps[0] = fragment_maps(material, data, tally);
    sum_light<maps>(light_spans(frame_.scene()), function, batch, undefined);
  });
  PixelBounds result;
  for (int c = 0; c < 3; ++c) result.colour.lo[c] = batch.sum[0][c].lo, result.colour.hi[c] = batch.sum[0][c].hi;
  result.open = Forks::open_comparisons() != met;
  for (const std::uint64_t count : undefined.counts) result.undefined |= count > 0;
  return result;
}

} // namespace refraster
