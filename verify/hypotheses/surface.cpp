#include "verify/hypotheses/surface.h"

#include "math/half_of.h"
#include "raster/shade/shade_packet.h"

#include <array>
#include <cmath>

namespace refraster::hypotheses {
namespace {

/// Corners weigh the same wherever they are: what `noperspective` gives.
struct WithoutPerspective {
  using Number = double;
  const SampleData<double>& data;

  std::array<double, 4> row(int r) const {
    std::array<double, 4> row = data.row(r);
    if (r < 3) row[3] = 1;
    return row;
  }
};
template <Derivatives, class T>
EdgeValues<T> edge_values(const WithoutPerspective& data) {
  return data.data.edges();
}
template <Derivatives>
EdgeValues<double> edge_values(const WithoutPerspective& data) {
  return data.data.edges();
}

PacketBarycentrics<double> weights(const SampleData<double>& data, Interpolation interpolation) {
  if (interpolation == Interpolation::right) return barycentrics<Derivatives::yes>(data);
  return barycentrics<Derivatives::yes>(WithoutPerspective{data});
}

Double3 vector_at(const SampleData<double>& data, int row, const Barycentric<double>& at) {
  return {interpolated(data, row, at), interpolated(data, row + 1, at), interpolated(data, row + 2, at)};
}

double in_half_precision(double x) {
  return static_cast<double>(static_cast<float>(half_of(x)));
}
template <class Vector>
Vector in_half_precision(Vector v) {
  for (int c = 0; c < Vector::length(); ++c) v[c] = in_half_precision(v[c]);
  return v;
}

/// What turns the right interpolated normal into this one.
struct NormalChange {
  Double3x3 matrix{1.0};
  double scale = 1; // from cofactors to the inverse transpose
};
NormalChange normal_change(const ObjectTransform& transform, NormalMatrix which) {
  const Double3x3 model(transform.world_from_object), &normal = transform.world_from_normal;
  // cofactors(M) = det(M) transpose(inverse(M)), so that N transpose(M) is a multiple of 1: |det M| times N's factor.
  const double scale = 1 / (normal * glm::transpose(model))[0][0];
  const Double3x3 object_from_normal = glm::transpose(model) * scale;
  switch (which) {
  case NormalMatrix::right:
    return {Double3x3(1.0), scale};
  case NormalMatrix::model:
    return {model * object_from_normal, 1};
  case NormalMatrix::none:
    return {object_from_normal, 1};
  }
  return {};
}

/// As it is interpolated, before it is normalised.
Double3 interpolated_normal(const SampleData<double>& data, const PacketBarycentrics<double>& at,
                            const NormalChange& change, NormalLength length) {
  if (length != NormalLength::unit_at_corners) {
    const double scale = length == NormalLength::inverse_transpose ? change.scale : 1;
    return change.matrix * vector_at(data, normal_row, at.at) * scale;
  }
  const Barycentric<double> corners[3] = {{0, 0}, {1, 0}, {0, 1}};
  const double weight[3] = {1 - at.at.b1 - at.at.b2, at.at.b1, at.at.b2};
  Double3 sum(0);
  for (int k = 0; k < 3; ++k) sum += normalize(change.matrix * vector_at(data, normal_row, corners[k])) * weight[k];
  return sum;
}

/// Texture coordinates and their changes from pixel to pixel.
struct TexturePoint {
  Double2 uv{0}, right{0}, down{0};
};

double half_texel(double u, int side, TexturePlace place) {
  if (place == TexturePlace::half_texel_more) return u + 0.5 / side;
  if (place == TexturePlace::half_texel_less) return u - 0.5 / side;
  return u;
}

TexturePoint texture_point(const FrameContext& context, const SampleData<double>& data,
                           const PacketBarycentrics<double>& at, const TextureMap& map, const Steps& steps,
                           const Nudge& nudge) {
  const TextureLevel& image = map.texture->levels[0];
  const std::array<double, 2> whole =
      whole_repeats(context, context.geometry.first_triangle[data.object()] + data.triangle());
  TexturePoint point;
  for (int c = 0; c < 2; ++c) {
    // Where texture coordinates do not simply repeat, those whole repeats count that interpolation leaves out.
    point.uv[c] = interpolated_uv(data, c, at) + whole[static_cast<std::size_t>(c)];
    point.right[c] = changed(data.row(uv_row + c), at.right), point.down[c] = changed(data.row(uv_row + c), at.down);
  }
  if (steps.varyings == Varyings::in_half_precision) point.uv = in_half_precision(point.uv);
  point.uv = point.uv * map.scale + map.offset;
  point.right *= map.scale, point.down *= map.scale;
  const double bias = nudge.detail + (steps.mip_bias == MipBias::coarser ? 1
                                      : steps.mip_bias == MipBias::finer ? -1
                                                                         : 0);
  if (bias != 0) point.right *= std::exp2(bias), point.down *= std::exp2(bias);
  const auto exchange = [](Double2& v) { v = {v.y, v.x}; };
  switch (steps.texture_place) {
  case TexturePlace::v_turned_over:
    point.uv.y = 1 - point.uv.y;
    break;
  case TexturePlace::u_turned_over:
    point.uv.x = 1 - point.uv.x;
    break;
  case TexturePlace::exchanged:
    exchange(point.uv), exchange(point.right), exchange(point.down);
    break;
  default:
    point.uv = {half_texel(point.uv.x, image.width, steps.texture_place),
                half_texel(point.uv.y, image.height, steps.texture_place)};
  }
  return point;
}

double wrapped(double u, int side, TextureWrap wrap) {
  if (wrap == TextureWrap::mirrored) {
    const double in_pair = u - 2 * std::floor(u / 2);
    u = in_pair <= 1 ? in_pair : 2 - in_pair;
  }
  return std::min(std::max(u, 0.5 / side), 1 - 0.5 / side);
}

/// As sample() of shading/texture.h, with another rule beyond the texture's edges.
Rgb<double> sample_wrapped(const Texture& texture, TextureFilter filter, const TexturePoint& at,
                           refraster::TextureWrap of_map, TextureWrap wrap) {
  if (wrap == TextureWrap::right)
    return of_map == refraster::TextureWrap::repeat
               ? sample(texture, filter, at.uv, at.right, at.down)
               : sample<refraster::TextureWrap::clamp>(texture, filter, at.uv, at.right, at.down);
  const auto place = [&](const TextureLevel& level) {
    return Double2(wrapped(at.uv.x, level.width, wrap), wrapped(at.uv.y, level.height, wrap));
  };
  const TextureLevel& image = texture.levels[0];
  Rgb<double> sum(0);
  if (filter == TextureFilter::nearest) sum = sample_nearest(image, place(image));
  else if (filter == TextureFilter::bilinear) sum = sample_bilinear(image, place(image));
  else {
    const auto last = static_cast<double>(texture.levels.size() - 1);
    const double detail = min(max0(level_of_detail(image, at.right, at.down)), last);
    const Cell<double> level = floor_and_fraction(detail);
    const auto at_level = [&](double k) {
      const TextureLevel& here = texture.levels[static_cast<std::size_t>(min(k, last))];
      return sample_bilinear(here, place(here));
    };
    sum = mix(at_level(level.index), at_level(level.index + 1), level.fraction);
  }
  return sum / texture.full_scale;
}

const Texture& texture_read(const Texture& texture, TextureFilter filter, TextureCurve curve,
                            const Prepared& prepared) {
  const bool decoded = is_decoded(texture);
  if (curve == (decoded ? TextureCurve::srgb_encoded : TextureCurve::srgb_decoded))
    return prepared.with_other_curve(texture);
  return filter == TextureFilter::trilinear ? prepared.with_mip_levels(texture) : texture;
}

Rgb<double> texture_colour(const FrameContext& context, const SampleData<double>& data,
                           const PacketBarycentrics<double>& at, const Prepared& prepared, const Steps& steps,
                           const Nudge& nudge) {
  const Material& material = material_of(context.scene.objects[data.object()], data.triangle());
  if (!material.diffuse_map.texture || material.measured() || !data.may_have_texture_coordinates() ||
      steps.texture_use == TextureUse::missing)
    return Rgb<double>(1);
  const TextureFilter filter = steps.texture_filter.value_or(material.diffuse_map.filter);
  const Texture& texture = texture_read(*material.diffuse_map.texture, filter, steps.texture_curve, prepared);
  const TexturePoint point = texture_point(context, data, at, material.diffuse_map, steps, nudge);
  Rgb<double> colour =
      sample_wrapped(texture, filter, point, material.diffuse_map.wrap, steps.texture_wrap) + nudge.texel;
  if (steps.texture_curve == TextureCurve::decoded || steps.texture_curve == TextureCurve::encoded) {
    const double exponent = steps.texture_curve == TextureCurve::decoded ? 2.2 : 1 / 2.2;
    for (int c = 0; c < 3; ++c) colour[c] = std::pow(max0(colour[c]), exponent);
  }
  return colour;
}

/// Whether normals are those of the other side than is seen, and should not be.
bool shows_wrong_side(const SampleData<double>& data, const Steps& steps) {
  return steps.both_sides == BothSides::one_only && data.has_turned_normals();
}

/// As mapped_normal() of raster/shade, where red or green of the maps' directions may count the other way.
Double3 mapped_normal_with(const FrameContext& context, const Material& material, const SampleData<double>& data,
                           const PacketBarycentrics<double>& at, const Double3& normal, const Steps& steps,
                           const Nudge& nudge) {
  UndefinedCounts uncounted;
  const UndefinedTally<double> tally(uncounted, true);
  auto tangent = attribute_value<&Mesh::tangents>(context, data, at.at);
  if (shows_wrong_side(data, steps)) tangent = -tangent;
  Double3 direction = map_direction(material, data, at, tally);
  const NormalMaps change = steps.normal_maps;
  if (change == NormalMaps::red_reversed || change == NormalMaps::both_reversed) direction.x = -direction.x;
  if (change == NormalMaps::green_reversed || change == NormalMaps::both_reversed) direction.y = -direction.y;
  direction.x += 2 * nudge.texel, direction.y += 2 * nudge.texel; // 2 colour - 1
  bool usable;
  return turned_normal(normal, tangent, direction, usable);
}

} // namespace

Surface surface_at(const FrameContext& context, const SampleData<double>& data, const Prepared& prepared,
                   const Steps& steps, const Nudge& nudge) {
  const PacketBarycentrics<double> at = weights(data, steps.interpolation);
  const std::uint32_t object = data.object();
  Surface surface;
  surface.position = vector_at(data, position_row, at.at);
  surface.mesh_normal = vector_at(data, normal_row, at.at);
  Double3 normal = interpolated_normal(
      data, at, normal_change(context.geometry.transforms[object], steps.normal_matrix), steps.normal_length);
  if (steps.varyings == Varyings::in_half_precision) {
    surface.position = in_half_precision(surface.position);
    normal = in_half_precision(normal);
  }
  if (steps.normal_length == NormalLength::unit) {
    UndefinedCounts counts;
    normal = shading_normal(context, data, normal, UndefinedTally<double>(counts, true));
  }
  if (shows_wrong_side(data, steps)) normal = -normal;
  const Material& material = material_of(context.scene.objects[object], data.triangle());
  if (turns_normals(context, material, object) && steps.normal_maps != NormalMaps::missing)
    normal = mapped_normal_with(context, material, data, at, normal, steps, nudge);
  const Double3 way = context.scene.camera.position - surface.position;
  switch (steps.eye) {
  case Eye::right:
    surface.to_eye = normalize(way);
    break;
  case Eye::not_normalised:
    surface.to_eye = way;
    break;
  case Eye::reversed:
    surface.to_eye = -normalize(way);
    break;
  case Eye::from_origin:
    surface.to_eye = normalize(-surface.position);
    break;
  }
  const bool away = steps.normal_side == NormalSide::toward_eye && dot(normal, way) < 0;
  surface.normal = steps.normal_side == NormalSide::reversed || away ? -normal : normal;
  surface.unit = steps.normal_length == NormalLength::unit && steps.eye != Eye::not_normalised;
  surface.texture = texture_colour(context, data, at, prepared, steps, nudge);
  if (steps.vertex_colours == VertexColours::right) surface.texture *= vertex_colour(context, data, at);
  if (material.has_fragment_maps()) {
    UndefinedCounts uncounted;
    surface.maps = fragment_maps(material, data, UndefinedTally<double>(uncounted, true));
    if (material.specular_map.texture && !material.microfacets()) surface.maps->specular += nudge.texel;
    if (material.emissive_map.texture) surface.maps->emission += material.emissive * nudge.texel;
    if (steps.specular_map == SpecularMap::missing && !material.microfacets()) surface.maps->specular = Rgb<double>(1);
    if (steps.emission == Emission::missing) surface.maps->emission = Rgb<double>(0);
  }
  return surface;
}

} // namespace refraster::hypotheses
