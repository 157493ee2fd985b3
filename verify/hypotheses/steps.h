#pragma once
// What a hypothesis may change on the way from a scene to a pixel. One member a step; as they stand, nothing is
// changed.

#include <refraster/texture.h>

#include <cstdint>
#include <optional>

namespace refraster::hypotheses {

/// From where, and which place of the window, each pixel is taken.
enum class View {
  right,
  fov_in_radians,
  fov_horizontal,
  fov_half,
  fov_twice,
  aspect_one,
  aspect_inverted,
  half_pixel_left_up,
  half_pixel_left_down,
  half_pixel_right_up,
  half_pixel_right_down,
  upside_down,
  mirrored,
  shifted,
  half_size,
  every_second_pixel,
  double_size,
  count_
};

enum class DepthTest { less, lequal, greater, always };
enum class DepthPlanes { right, near_farther, near_nearer, far_nearer, far_farther };
enum class Culling { right, off, back, front };
enum class Opacity { right, missing, inverted };

enum class Interpolation { right, without_perspective };
enum class Varyings { right, in_half_precision };

/// What turns normals into the world's.
enum class NormalMatrix { right, model, none };
/// What length they have when they are used.
enum class NormalLength {
  unit,
  inverse_transpose, ///< that which the inverse transpose gives
  cofactors,         ///< that which the uniform normalMatrix gives
  unit_at_corners    ///< normalised at the corners, and not again
};
enum class NormalSide { right, reversed, toward_eye };
/// Of two-sided objects.
enum class BothSides { right, one_only };
/// What normal and bump maps make of a normal.
enum class NormalMaps { right, missing, red_reversed, green_reversed, both_reversed };
enum class Eye { right, not_normalised, reversed, from_origin };

enum class LightDirection { right, not_normalised, all_reversed, point_lights_reversed, direction_lights_reversed };
enum class Attenuation {
  right,
  missing,
  without_square,
  without_linear,
  square_of_d,
  linear_of_square,
  twice,
  inverse,
  inverse_square
};
enum class Radiance { right, missing };

/// Of shadow maps.
enum class ShadowMaps { right, missing, bias_missing, bias_reversed, opposite_face, rows_reversed };

enum class Ambient { right, missing, twice, each_light, without_texture };
enum class Diffuse { right, missing, not_clamped };
enum class Lobe { right, exchanged, reflect_reversed, half_not_normalised, missing };
enum class Gate { right, other };
enum class Glossiness { right, times_2, times_4, by_2, by_4 };

/// Of microfacets.
enum class Microfacets { right, roughness_not_squared, fresnel_not_clamped, masking_missing };

enum class TexturePlace { right, v_turned_over, u_turned_over, exchanged, half_texel_more, half_texel_less };
enum class TextureWrap { right, clamped, mirrored };
enum class TextureUse { right, missing, on_highlight };
enum class MipBias { right, coarser, finer };
enum class TextureCurve { right, decoded, encoded, srgb_decoded, srgb_encoded };
enum class VertexColours { right, missing };
enum class SpecularMap { right, missing };
enum class Emission { right, missing };

enum class TableAxes { right, theta_exchanged, theta_h_without_root, phi_d_cut, phi_d_cut_other, phi_d_mirrored };
enum class TableCosine { right, missing };
enum class TableScale { right, exchanged, twice, missing };
enum class TableHoles { right, black, as_stored };
enum class TableLookup { right, nearest, trilinear, edge, logarithm, cubic };
enum class TableAngles { right, arc_cosine };

/// Of the colour, last.
enum class Output {
  right,
  gamma_encoded,
  gamma_decoded,
  srgb_encoded,
  srgb_decoded,
  red_blue_exchanged,
  video_range,
  video_range_removed,
  scaled
};

/// No object and no light.
inline constexpr std::uint32_t none_missing = ~0u;

struct Steps {
  View view = View::right;
  DepthTest depth_test = DepthTest::less;
  DepthPlanes depth_planes = DepthPlanes::right;
  Culling culling = Culling::right;
  Opacity opacity = Opacity::right;
  std::uint32_t missing_object = none_missing;       // its index in the scene
  std::uint32_t other_missing_object = none_missing; // of a pair
  Interpolation interpolation = Interpolation::right;
  Varyings varyings = Varyings::right;
  NormalMatrix normal_matrix = NormalMatrix::right;
  NormalLength normal_length = NormalLength::unit;
  NormalSide normal_side = NormalSide::right;
  BothSides both_sides = BothSides::right;
  NormalMaps normal_maps = NormalMaps::right;
  Eye eye = Eye::right;
  LightDirection light_direction = LightDirection::right;
  Attenuation attenuation = Attenuation::right;
  Radiance radiance = Radiance::right;
  std::uint32_t missing_light = none_missing;       // counted through all lists in their order
  std::uint32_t other_missing_light = none_missing; // of a pair
  ShadowMaps shadow_maps = ShadowMaps::right;
  Ambient ambient = Ambient::right;
  Diffuse diffuse = Diffuse::right;
  Lobe lobe = Lobe::right;
  Gate gate = Gate::right;
  Glossiness glossiness = Glossiness::right;
  Microfacets microfacets = Microfacets::right;
  TexturePlace texture_place = TexturePlace::right;
  TextureWrap texture_wrap = TextureWrap::right;
  TextureUse texture_use = TextureUse::right;
  MipBias mip_bias = MipBias::right;
  TextureCurve texture_curve = TextureCurve::right;
  VertexColours vertex_colours = VertexColours::right;
  SpecularMap specular_map = SpecularMap::right;
  Emission emission = Emission::right;
  std::optional<TextureFilter> texture_filter = std::nullopt; // instead of the material's
  TableAxes table_axes = TableAxes::right;
  TableCosine table_cosine = TableCosine::right;
  TableScale table_scale = TableScale::right;
  TableHoles table_holes = TableHoles::right;
  TableLookup table_lookup = TableLookup::right;
  TableAngles table_angles = TableAngles::right;
  Output output = Output::right;

  bool operator==(const Steps&) const = default;
};

/// Calls visit(member) with a pointer to each member.
void for_each_step(auto&& visit) {
  visit(&Steps::view);
  visit(&Steps::depth_test);
  visit(&Steps::depth_planes);
  visit(&Steps::culling);
  visit(&Steps::opacity);
  visit(&Steps::missing_object);
  visit(&Steps::other_missing_object);
  visit(&Steps::interpolation);
  visit(&Steps::varyings);
  visit(&Steps::normal_matrix);
  visit(&Steps::normal_length);
  visit(&Steps::normal_side);
  visit(&Steps::both_sides);
  visit(&Steps::normal_maps);
  visit(&Steps::eye);
  visit(&Steps::light_direction);
  visit(&Steps::attenuation);
  visit(&Steps::radiance);
  visit(&Steps::missing_light);
  visit(&Steps::other_missing_light);
  visit(&Steps::shadow_maps);
  visit(&Steps::ambient);
  visit(&Steps::diffuse);
  visit(&Steps::lobe);
  visit(&Steps::gate);
  visit(&Steps::glossiness);
  visit(&Steps::microfacets);
  visit(&Steps::texture_place);
  visit(&Steps::texture_wrap);
  visit(&Steps::texture_use);
  visit(&Steps::mip_bias);
  visit(&Steps::texture_curve);
  visit(&Steps::vertex_colours);
  visit(&Steps::specular_map);
  visit(&Steps::emission);
  visit(&Steps::texture_filter);
  visit(&Steps::table_axes);
  visit(&Steps::table_cosine);
  visit(&Steps::table_scale);
  visit(&Steps::table_holes);
  visit(&Steps::table_lookup);
  visit(&Steps::table_angles);
  visit(&Steps::output);
}

} // namespace refraster::hypotheses
