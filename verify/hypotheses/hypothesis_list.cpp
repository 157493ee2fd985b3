#include "verify/hypotheses/hypothesis_list.h"

#include "raster/frame_context.h"
#include "verify/hypotheses/prepared.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace refraster::hypotheses {
namespace {

/// Sets one member.
template <auto member, auto value>
void set(Steps& steps) {
  steps.*member = value;
}
template <auto... members>
void none(Steps&) {}

constexpr auto view = &Steps::view;
template <View value>
constexpr auto seen = set<view, value>;
template <Output value>
constexpr auto put = set<&Steps::output, value>;
template <Attenuation value>
constexpr auto attenuated = set<&Steps::attenuation, value>;

using enum Concerns;

constexpr Declared declared[] = {
    // The transformations of `compare` that an image without alpha can have.
    {"srgb_curve_added", "the sRGB curve applied once too often", any, put<Output::srgb_encoded>},
    {"srgb_curve_missing", "the sRGB curve missing, or undone", any, put<Output::srgb_decoded>},
    {"upside_down", "the image turned upside down", any, seen<View::upside_down>},
    {"mirrored", "the image mirrored, left to right", any, seen<View::mirrored>},
    {"red_blue_exchanged", "red and blue exchanged", any, put<Output::red_blue_exchanged>},
    {"shifted", "the image shifted by whole pixels", any, seen<View::shifted>},
    {"video_range", "the image in video range, 16 to 235", any, put<Output::video_range>},
    {"video_range_removed", "the image stretched as if it were in video range", any, put<Output::video_range_removed>},
    {"scaled", "the image scaled by a constant", any, put<Output::scaled>},
    {"half_size", "drawn at half size and enlarged", any, seen<View::half_size>},
    {"every_second_pixel", "only every second pixel and row drawn, and repeated", any, seen<View::every_second_pixel>},
    {"double_size", "drawn at double size and reduced", any, seen<View::double_size>},
    // Gamma in the shader.
    {"gamma_encoded", "the colour raised to 1/2.2 in the shader", any, put<Output::gamma_encoded>},
    {"gamma_decoded", "the colour raised to 2.2 in the shader", any, put<Output::gamma_decoded>},
    // View and window.
    {"fov_in_radians", "the field of view in degrees taken as radians", any, seen<View::fov_in_radians>},
    {"fov_horizontal", "the field of view taken as the horizontal one", any, seen<View::fov_horizontal>},
    {"fov_half", "half the field of view", any, seen<View::fov_half>},
    {"fov_twice", "twice the field of view", any, seen<View::fov_twice>},
    {"aspect_one", "a projection for a square image", any, seen<View::aspect_one>},
    {"aspect_inverted", "a projection with height / width for width / height", any, seen<View::aspect_inverted>},
    {"half_pixel_left_up", "everything half a pixel to the left and up", any, seen<View::half_pixel_left_up>},
    {"half_pixel_left_down", "everything half a pixel to the left and down", any, seen<View::half_pixel_left_down>},
    {"half_pixel_right_up", "everything half a pixel to the right and up", any, seen<View::half_pixel_right_up>},
    {"half_pixel_right_down", "everything half a pixel to the right and down", any, seen<View::half_pixel_right_down>},
    // What is seen.
    {"near_plane_farther", "the near plane ten times as far", any,
     set<&Steps::depth_planes, DepthPlanes::near_farther>},
    {"near_plane_nearer", "the near plane at a tenth of its distance", any,
     set<&Steps::depth_planes, DepthPlanes::near_nearer>},
    {"far_plane_nearer", "the far plane at a tenth of its distance", any,
     set<&Steps::depth_planes, DepthPlanes::far_nearer>},
    {"far_plane_farther", "the far plane ten times as far", any, set<&Steps::depth_planes, DepthPlanes::far_farther>},
    {"depth_lequal", "the depth test LEQUAL: of equal depths the last is seen", any,
     set<&Steps::depth_test, DepthTest::lequal>},
    {"depth_test_off", "no depth test: the last triangle drawn is seen", any,
     set<&Steps::depth_test, DepthTest::always>},
    {"depth_reversed", "the depth test reversed: the farthest triangle is seen", any,
     set<&Steps::depth_test, DepthTest::greater>},
    {"culling_off", "back faces drawn where they are to be culled", any, set<&Steps::culling, Culling::off>},
    {"culling_back", "back faces culled", any, set<&Steps::culling, Culling::back>},
    {"culling_front", "front faces culled", any, set<&Steps::culling, Culling::front>},
    {"opacity_missing", "what the opacity map cuts out drawn all the same", cut_outs,
     set<&Steps::opacity, Opacity::missing>},
    {"opacity_inverted", "the opacity map taken for transparency: what is there is cut out", cut_outs,
     set<&Steps::opacity, Opacity::inverted>},
    {"object_missing", "an object missing", each_object, none<>},
    // Interpolation and vertices.
    {"varyings_not_perspective", "varyings interpolated without perspective correction", any,
     set<&Steps::interpolation, Interpolation::without_perspective>},
    {"half_float_varyings", "varyings in half precision", any, set<&Steps::varyings, Varyings::in_half_precision>},
    {"normals_by_model_matrix", "normals transformed by the model matrix instead of its inverse transpose", any,
     set<&Steps::normal_matrix, NormalMatrix::model>},
    {"normals_not_transformed", "normals left in object space", any, set<&Steps::normal_matrix, NormalMatrix::none>},
    {"normal_not_normalised", "the normal not normalised, as the inverse transpose gives it", any,
     set<&Steps::normal_length, NormalLength::inverse_transpose>},
    {"normal_not_normalised_cofactors", "the normal not normalised, as normalMatrix gives it", any,
     set<&Steps::normal_length, NormalLength::cofactors>},
    {"normal_normalised_at_corners", "the normal normalised at vertices, and not again where it is interpolated", any,
     set<&Steps::normal_length, NormalLength::unit_at_corners>},
    {"normals_reversed", "normals that point inward", any, set<&Steps::normal_side, NormalSide::reversed>},
    {"normals_turned_to_eye", "normals of back faces turned toward the eye", any,
     set<&Steps::normal_side, NormalSide::toward_eye>},
    {"two_sided_missing", "two-sided objects lit from one side only", two_sided,
     set<&Steps::both_sides, BothSides::one_only>},
    {"normal_maps_missing", "normals as the mesh has them: the normal or bump map missing", normal_maps,
     set<&Steps::normal_maps, NormalMaps::missing>},
    {"normal_map_red_reversed", "red of a normal map, or slopes along u, counted from the other end", normal_maps,
     set<&Steps::normal_maps, NormalMaps::red_reversed>},
    {"bitangents_reversed", "green of a normal map counted from the other end: its bitangents reversed", normal_maps,
     set<&Steps::normal_maps, NormalMaps::green_reversed>},
    {"tangents_reversed", "the tangents reversed, and with them bitangents: dents for bumps", normal_maps,
     set<&Steps::normal_maps, NormalMaps::both_reversed>},
    {"vertex_colors_missing", "the vertices' colours missing", Concerns::vertex_colours,
     set<&Steps::vertex_colours, VertexColours::missing>},
    // Lights.
    {"light_not_normalised", "the direction to point lights not normalised", point_lights,
     set<&Steps::light_direction, LightDirection::not_normalised>},
    {"light_directions_reversed", "the direction to all lights reversed", any,
     set<&Steps::light_direction, LightDirection::all_reversed>},
    {"point_lights_reversed", "the direction to point lights reversed", point_lights,
     set<&Steps::light_direction, LightDirection::point_lights_reversed>},
    {"direction_lights_reversed", "the direction to direction lights reversed", any,
     set<&Steps::light_direction, LightDirection::direction_lights_reversed>},
    {"attenuation_missing", "attenuation missing", attenuation, attenuated<Attenuation::missing>},
    {"attenuation_without_square", "attenuation without its quadratic term", attenuation,
     attenuated<Attenuation::without_square>},
    {"attenuation_without_linear", "attenuation without its linear term", attenuation,
     attenuated<Attenuation::without_linear>},
    {"attenuation_square_of_d", "attenuation with d for d² in its quadratic term", attenuation,
     attenuated<Attenuation::square_of_d>},
    {"attenuation_linear_of_square", "attenuation with d² for d in its linear term", attenuation,
     attenuated<Attenuation::linear_of_square>},
    {"attenuation_twice", "attenuation applied twice", attenuation, attenuated<Attenuation::twice>},
    {"attenuation_inverse", "attenuation by 1 / d", point_lights, attenuated<Attenuation::inverse>},
    {"attenuation_inverse_square", "attenuation by 1 / d²", point_lights, attenuated<Attenuation::inverse_square>},
    {"radiance_missing", "the lights' radiance not applied", any, set<&Steps::radiance, Radiance::missing>},
    {"shadows_missing", "shadows missing: the maps are not asked", Concerns::shadow_maps,
     set<&Steps::shadow_maps, ShadowMaps::missing>},
    {"shadow_bias_missing", "shadow maps without their bias", Concerns::shadow_maps,
     set<&Steps::shadow_maps, ShadowMaps::bias_missing>},
    {"shadow_bias_reversed", "the bias of shadow maps with its sign reversed", Concerns::shadow_maps,
     set<&Steps::shadow_maps, ShadowMaps::bias_reversed>},
    {"shadow_face_opposite", "the opposite face of a point light's shadow map", point_shadow_maps,
     set<&Steps::shadow_maps, ShadowMaps::opposite_face>},
    {"shadow_rows_reversed", "shadow maps turned over: rows counted from the other end", Concerns::shadow_maps,
     set<&Steps::shadow_maps, ShadowMaps::rows_reversed>},
    {"light_missing", "a light missing", each_light, none<>},
    // Phong and Blinn-Phong.
    {"ambient_missing", "the ambient term missing", plastics, set<&Steps::ambient, Ambient::missing>},
    {"ambient_twice", "the ambient term added twice", plastics, set<&Steps::ambient, Ambient::twice>},
    {"ambient_each_light", "the ambient term added once a light", plastics, set<&Steps::ambient, Ambient::each_light>},
    {"ambient_without_texture", "the ambient term without the texture", textures,
     set<&Steps::ambient, Ambient::without_texture>},
    {"diffuse_missing", "the diffuse term missing", plastics, set<&Steps::diffuse, Diffuse::missing>},
    {"diffuse_not_clamped", "n·l not clamped: light from below is subtracted", plastics,
     set<&Steps::diffuse, Diffuse::not_clamped>},
    {"phong_exchanged", "Phong's highlight where Blinn-Phong's is asked for, or the other way round", plastics,
     set<&Steps::lobe, Lobe::exchanged>},
    {"reflect_reversed", "the reflected direction reversed", plastics, set<&Steps::lobe, Lobe::reflect_reversed>},
    {"half_vector_not_normalised", "the half vector not normalised", plastics,
     set<&Steps::lobe, Lobe::half_not_normalised>},
    {"highlight_missing", "the highlight missing", plastics, set<&Steps::lobe, Lobe::missing>},
    {"specular_gate", "the other setting of specular_gate", plastics, set<&Steps::gate, Gate::other>},
    {"glossiness_times_2", "glossiness doubled", plastics, set<&Steps::glossiness, Glossiness::times_2>},
    {"glossiness_times_4", "glossiness times four, as Blinn-Phong needs it to look like Phong", plastics,
     set<&Steps::glossiness, Glossiness::times_4>},
    {"glossiness_by_2", "glossiness halved", plastics, set<&Steps::glossiness, Glossiness::by_2>},
    {"glossiness_by_4", "glossiness divided by four, as Phong needs it to look like Blinn-Phong", plastics,
     set<&Steps::glossiness, Glossiness::by_4>},
    // Microfacets.
    {"roughness_not_squared", "alpha taken to be the roughness instead of its square", Concerns::microfacets,
     set<&Steps::microfacets, Microfacets::roughness_not_squared>},
    {"fresnel_not_clamped", "the Fresnel factor by a half vector that is not of length 1, its cosine not clamped to 1",
     Concerns::microfacets, set<&Steps::microfacets, Microfacets::fresnel_not_clamped>},
    {"masking_missing", "masking and shadowing of microfacets missing", Concerns::microfacets,
     set<&Steps::microfacets, Microfacets::masking_missing>},
    // Textures.
    {"texture_missing", "the texture missing: white", textures, set<&Steps::texture_use, TextureUse::missing>},
    {"texture_on_highlight", "the texture on the highlight too", textures,
     set<&Steps::texture_use, TextureUse::on_highlight>},
    {"texture_v_turned_over", "the texture turned over: v counted from the other end", textures,
     set<&Steps::texture_place, TexturePlace::v_turned_over>},
    {"texture_u_turned_over", "the texture mirrored: u counted from the other end", textures,
     set<&Steps::texture_place, TexturePlace::u_turned_over>},
    {"texture_uv_exchanged", "u and v exchanged", textures, set<&Steps::texture_place, TexturePlace::exchanged>},
    {"texture_half_texel_more", "the texture read half a texel too far, in u and v", textures,
     set<&Steps::texture_place, TexturePlace::half_texel_more>},
    {"texture_half_texel_less", "the texture read half a texel too early, in u and v", textures,
     set<&Steps::texture_place, TexturePlace::half_texel_less>},
    {"texture_clamped", "the texture clamped instead of repeated", textures,
     set<&Steps::texture_wrap, TextureWrap::clamped>},
    {"texture_mirrored", "the texture mirrored at each repeat", textures,
     set<&Steps::texture_wrap, TextureWrap::mirrored>},
    {"texture_nearest", "the texture's nearest texel instead of its filter", textures,
     set<&Steps::texture_filter, TextureFilter::nearest>},
    {"texture_bilinear", "the texture filtered bilinearly, without its mip levels", textures,
     set<&Steps::texture_filter, TextureFilter::bilinear>},
    {"texture_trilinear", "the texture filtered between mip levels where none are asked for", textures,
     set<&Steps::texture_filter, TextureFilter::trilinear>},
    {"mip_bias_coarser", "mip levels one too coarse", textures, set<&Steps::mip_bias, MipBias::coarser>},
    {"mip_bias_finer", "mip levels one too fine", textures, set<&Steps::mip_bias, MipBias::finer>},
    {"texture_decoded", "the texture raised to 2.2", textures, set<&Steps::texture_curve, TextureCurve::decoded>},
    {"texture_encoded", "the texture raised to 1/2.2", textures, set<&Steps::texture_curve, TextureCurve::encoded>},
    {"srgb_texture_not_decoded", "an sRGB texture's values taken as they are stored", srgb_textures,
     set<&Steps::texture_curve, TextureCurve::srgb_encoded>},
    {"linear_texture_decoded", "a linear texture's values decoded as if they were sRGB", linear_textures,
     set<&Steps::texture_curve, TextureCurve::srgb_decoded>},
    {"specular_map_missing", "the specular map missing: white", specular_maps,
     set<&Steps::specular_map, SpecularMap::missing>},
    {"emission_missing", "the surface's own light missing", Concerns::emission,
     set<&Steps::emission, Emission::missing>},
    // Measured reflection.
    {"merl_axes_exchanged", "θh and θd exchanged in the table", measured,
     set<&Steps::table_axes, TableAxes::theta_exchanged>},
    {"merl_theta_h_without_root", "θh without its square root", measured,
     set<&Steps::table_axes, TableAxes::theta_h_without_root>},
    {"merl_phi_d_cut", "φd below 0 cut off instead of going on at π", measured,
     set<&Steps::table_axes, TableAxes::phi_d_cut>},
    {"merl_phi_d_cut_other", "φd below 0 cut off instead of going on at π, counted from the eye", measured,
     set<&Steps::table_axes, TableAxes::phi_d_cut_other>},
    {"merl_phi_d_mirrored", "φd without its sign", measured, set<&Steps::table_axes, TableAxes::phi_d_mirrored>},
    {"merl_cosine_missing", "the cosine n·l missing", measured, set<&Steps::table_cosine, TableCosine::missing>},
    {"merl_scales_exchanged", "the table's scales of red and blue exchanged", measured,
     set<&Steps::table_scale, TableScale::exchanged>},
    {"merl_scales_twice", "the table's scales applied twice", measured, set<&Steps::table_scale, TableScale::twice>},
    {"merl_scales_missing", "the table's scales not applied", measured, set<&Steps::table_scale, TableScale::missing>},
    {"merl_unmeasured_black", "samples that were never measured taken as black", measured,
     set<&Steps::table_holes, TableHoles::black>},
    {"merl_unmeasured_used", "the negative marks of samples that were never measured used as values", measured,
     set<&Steps::table_holes, TableHoles::as_stored>},
    {"merl_nearest", "the table's nearest sample", measured, set<&Steps::table_lookup, TableLookup::nearest>},
    {"merl_trilinear", "the table read trilinearly", measured, set<&Steps::table_lookup, TableLookup::trilinear>},
    {"merl_trilinear_edge", "the table's samples taken to be at the starts of their bins", measured,
     set<&Steps::table_lookup, TableLookup::edge>},
    {"merl_trilinear_log", "the table's logarithms read trilinearly", measured,
     set<&Steps::table_lookup, TableLookup::logarithm>},
    {"merl_tricubic_log", "the table's logarithms read with splines", measured,
     set<&Steps::table_lookup, TableLookup::cubic>},
    {"merl_arc_cosine", "θh by an arc cosine, which loses half of all digits at a highlight", measured,
     set<&Steps::table_angles, TableAngles::arc_cosine>},
    // The direction to the eye, last: reversed, it is a reversed reflection for Phong alone, and black for a measured
    // surface, as are several faults of its table.
    {"eye_not_normalised", "the direction to the eye not normalised", any, set<&Steps::eye, Eye::not_normalised>},
    {"eye_reversed", "the direction to the eye reversed", any, set<&Steps::eye, Eye::reversed>},
    {"eye_at_origin", "the eye taken to be at the origin", any, set<&Steps::eye, Eye::from_origin>},
};

bool has_diffuse_map(const Material& m) {
  return m.diffuse_map.texture != nullptr && !m.measured();
}

/// Whether any material of a scene is as `has` says.
template <bool (*has)(const Material&)>
bool of_any_material(const Scene& scene) {
  return any_material(scene, has);
}
bool always(const Scene&) {
  return true;
}

struct Concerned {
  Concerns concerns;
  std::string_view words; // in docs
  bool (*is_in)(const Scene& scene);
};

constexpr Concerned concerned[] = {
    {any, "every scene", always},
    {plastics, "Phong, Blinn-Phong",
     of_any_material<[](const Material& m) { return !m.user_function && !m.measured() && !m.microfacets(); }>},
    {Concerns::measured, "measured BRDFs", of_any_material<[](const Material& m) { return m.measured() != nullptr; }>},
    {Concerns::microfacets, "microfacets",
     of_any_material<[](const Material& m) { return m.microfacets() != nullptr; }>},
    {textures, "textures", of_any_material<has_diffuse_map>},
    {srgb_textures, "sRGB textures",
     of_any_material<[](const Material& m) { return has_diffuse_map(m) && is_decoded(*m.diffuse_map.texture); }>},
    {linear_textures, "linear textures",
     of_any_material<[](const Material& m) { return has_diffuse_map(m) && !is_decoded(*m.diffuse_map.texture); }>},
    {specular_maps, "specular maps",
     of_any_material<[](const Material& m) { return m.specular_map.texture && !m.microfacets(); }>},
    {Concerns::emission, "surfaces that emit light",
     of_any_material<[](const Material& m) { return m.emissive != Double3(0); }>},
    {cut_outs, "opacity maps", of_any_material<[](const Material& m) { return m.has_cut_outs(); }>},
    {normal_maps, "normal and bump maps", of_any_material<[](const Material& m) { return m.turns_normals(); }>},
    {Concerns::vertex_colours, "colours of vertices", [](const Scene& scene) { return uses_of(scene).vertex_colours; }},
    {two_sided, "two-sided objects", [](const Scene& scene) { return uses_of(scene).two_sided; }},
    {point_lights, "point lights", [](const Scene& scene) { return !scene.point_lights.empty(); }},
    {attenuation, "attenuated lights",
     [](const Scene& scene) {
       return std::any_of(scene.point_lights.begin(), scene.point_lights.end(),
                          [](const PointLight& light) { return light.linear > 0 || light.quadratic > 0; });
     }},
    {Concerns::shadow_maps, "shadow maps", [](const Scene& scene) { return has_shadows(scene, Shadow::map); }},
    {point_shadow_maps, "shadow maps of point lights",
     [](const Scene& scene) {
       return std::any_of(scene.point_lights.begin(), scene.point_lights.end(),
                          [](const PointLight& light) { return light.shadow == Shadow::map; });
     }},
    {each_object, "each object by itself", always},
    {each_light, "each light by itself", always},
};

const Concerned& about(Concerns concerns) {
  return *std::find_if(std::begin(concerned), std::end(concerned),
                       [&](const Concerned& entry) { return entry.concerns == concerns; });
}

void add_each_object(const Scene& scene, const Declared& entry, std::vector<Hypothesis>& all) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    Hypothesis one{std::string(entry.key), "the object `" + scene.objects[i].name + "` missing", {}};
    one.steps.missing_object = static_cast<std::uint32_t>(i);
    all.push_back(std::move(one));
  }
}

void add_each_light(const Scene& scene, const Declared& entry, std::vector<Hypothesis>& all) {
  std::uint32_t number = 0;
  for_each_light_list(scene, [&]<class Light>(const std::vector<Light>& lights) {
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const std::string name = std::string(Light::names.key) + "/" + std::to_string(i);
      Hypothesis one{std::string(entry.key), "the light `" + name + "` missing", {}};
      one.steps.missing_light = number++;
      all.push_back(std::move(one));
    }
  });
}

} // namespace

std::span<const Declared> declared_hypotheses() {
  return declared;
}

std::vector<Hypothesis> hypotheses_for(const Scene& scene) {
  std::vector<Hypothesis> all;
  for (const Declared& entry : declared) {
    if (!about(entry.concerns).is_in(scene)) continue;
    if (entry.concerns == each_object) add_each_object(scene, entry, all);
    else if (entry.concerns == each_light) add_each_light(scene, entry, all);
    else {
      Hypothesis one{std::string(entry.key), std::string(entry.text), {}};
      entry.change(one.steps);
      all.push_back(std::move(one));
    }
  }
  return all;
}

std::string hypotheses_markdown() {
  std::string text = "| key | what is wrong | tried on |\n|---|---|---|\n";
  for (const Declared& entry : declared)
    text.append("| `")
        .append(entry.key)
        .append("` | ")
        .append(entry.text)
        .append(" | ")
        .append(about(entry.concerns).words) += " |\n";
  return text;
}

} // namespace refraster::hypotheses
