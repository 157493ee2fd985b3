#include "verify/explain/fragment_story.h"

#include "raster/shade/shadow/fragment_point.h"
#include "verify/explain/fragment_terms.h"
#include "verify/explain/readings.h"

#include <concepts>
#include <limits>

namespace refraster {
namespace {

using T = DoublePrecision::Number; // that of the frame: the same bits
using Plain = Fragment<T>;

Double2 plain_of(const Vec2<T>& x) {
  return {plain(x.x), plain(x.y)};
}

/// Which submitted corner stands at each place of a triangle that is set up.
std::array<std::uint8_t, 3> corner_order(const FrameContext& context, std::uint32_t number) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const std::array<WindowVertex, 3> window = window_corners(context.geometry, ref);
  if ((window[0].outcode | window[1].outcode | window[2].outcode) & outcode::unsnapped)
    return context.bins.projective_triangle(number).corner;
  return set_up_snapped(window).value().corner;
}

std::array<double, 3> in_order_of_mesh(const Barycentric<T>& at, const std::array<std::uint8_t, 3>& corner) {
  const double b1 = plain(at.b1), b2 = plain(at.b2);
  std::array<double, 3> weights{};
  weights[corner[0]] = 1 - b1 - b2, weights[corner[1]] = b1, weights[corner[2]] = b2;
  return weights;
}

/// Writes down what `fields` shows.
struct Parameters {
  std::vector<ParameterStory>& list;

  void operator()(std::string_view name, const double& value, const auto&...) const {
    list.push_back({std::string(name), {value}, {}});
  }
  void operator()(std::string_view name, const Double3& value, const auto&...) const {
    list.push_back({std::string(name), {value.x, value.y, value.z}, {}});
  }
  template <NamedEnum Enum>
  void operator()(std::string_view name, const Enum& value, const auto&...) const {
    list.push_back({std::string(name), {}, std::string(name_of(value))});
  }
};

struct ParameterVisitor final : FieldVisitor {
  Parameters parameters;

  explicit ParameterVisitor(std::vector<ParameterStory>& list) : parameters{list} {}
  void field(std::string_view name, double& value, const Range&, std::string_view) override { parameters(name, value); }
  void field(std::string_view name, Double3& value, const Range&, std::string_view) override {
    parameters(name, value);
  }
  void field(std::string_view name, NamedValue& value, const Range&, std::string_view) override {
    parameters.list.push_back({std::string(name), {}, std::string(value.names.at(value.index))});
  }
};

template <class Function>
concept PhongLike = std::derived_from<Function, PhongParameters>;

/// <cosine>^s after the gate: what the formula makes of it with ks 1, kd 0 and C 1.
template <PhongLike Function>
double lobe_value(const Function& function, const Plain& at, const Vec3<T>& direction) {
  Function only = function;
  only.kd = Double3(0), only.ks = Double3(1);
  Plain without_maps = at;
  without_maps.maps = nullptr;
  return plain(reflected(only, without_maps, Incident<T>{direction, Rgb<T>(T(1))}).x);
}

LobeStory lobe_story(const Phong& phong, const Plain& at, const Vec3<T>& l) {
  const Vec3<T> r = mirrored(at.normal, l, dot(at.normal, l));
  return {"r", "r.v", plain(r), plain(dot(r, at.to_eye)), lobe_value(phong, at, l)};
}
LobeStory lobe_story(const BlinnPhong& blinn, const Plain& at, const Vec3<T>& l) {
  const Vec3<T> h = half_vector(l, at.to_eye);
  return {"h", "n.h", plain(h), plain(dot(at.normal, h)), lobe_value(blinn, at, l)};
}

MerlStory merl_story(const Merl& merl, const Plain& at, const Vec3<T>& l) {
  const HalfDifference<T> angles = half_difference(merl.angles, at.normal, l, at.to_eye);
  const MerlPoint<T> point = merl_point(angles);
  const MerlValue<T> value = merl_value(*merl.table, merl.lookup, point);
  MerlStory story{plain(angles.theta_h),
                  plain(angles.theta_d),
                  plain(angles.phi_d),
                  plain(point.u),
                  plain(point.v),
                  plain(point.w),
                  {},
                  plain(value.f)};
  story.unmeasured = any(value.unmeasured & first_lane<T>());
  story.lit = plain(dot(at.normal, l)) > 0 && plain(dot(at.normal, at.to_eye)) > 0;
  story.taps = taps_read(*merl.table, merl.lookup, {story.u, story.v, story.w});
  return story;
}

MicrofacetStory microfacet_story(const Microfacet& function, const Plain& at, const MicrofacetTerms<T>& terms,
                                 const Vec3<T>& l) {
  return {plain(microfacet_surface(function, at).alpha), plain(terms.density), plain(terms.cosine_over_divisor),
          plain(terms.fresnel), plain(dot(at.normal, l)) > 0 && plain(dot(at.normal, at.to_eye)) > 0};
}

/// What the formula makes of the light, in parts.
template <class Function>
void add_parts(const Function& function, const Plain& at, const Vec3<T>& l, LightStory& story) {
  if constexpr (requires(Function f) { f.kd = f.ks; }) {
    Function part = function;
    const auto per_unit = [&] { return plain(reflected(part, at, Incident<T>{l, Rgb<T>(T(1))})); };
    part.ks = Double3(0);
    story.diffuse = per_unit();
    part = function, part.kd = Double3(0);
    story.specular = per_unit();
  }
  if constexpr (PhongLike<Function>) story.lobe = lobe_story(function, at, l);
  if constexpr (std::same_as<Function, Merl>) story.merl = merl_story(function, at, l);
  if constexpr (std::same_as<Function, Microfacet>) {
    const MicrofacetTerms<T> terms = microfacet_terms(function, at, l);
    story.diffuse = plain(terms.diffuse), story.specular = plain(terms.specular);
    story.microfacet = microfacet_story(function, at, terms, l);
  }
}

/// How much of a light without colour arrives.
template <class Light>
double attenuation(const Light& light, const Plain& at) {
  Light white = light;
  white.radiance = Double3(1);
  return plain(arriving(within_range<T>(prepared_light(white)), at).radiance.x);
}

template <class Light>
LightStory light_story(const Light& light, std::size_t index, const Plain& at) {
  const Incident<T> incident = arriving(within_range<T>(prepared_light(light)), at);
  LightStory story;
  const std::string_view many = Light::names.words; // "point lights"
  story.type = many.substr(0, many.size() - 1);
  story.index = index;
  story.direction = plain(incident.direction);
  story.n_l = plain(dot(at.normal, incident.direction));
  Light::fields(light, [&]<class Value>(std::string_view name, const Value& value, const auto&... about) {
    if constexpr (std::is_same_v<Value, CastShadow>) {
      if (value == Shadow::none) return; // no news
      Parameters{story.parameters}(name, value.kind, about...);
      if (value == Shadow::map) ShadowMap::fields(value.map, Parameters{story.parameters});
    } else {
      Parameters{story.parameters}(name, value, about...);
    }
  });
  story.arriving = plain(incident.radiance);
  if constexpr (requires { light.position; }) {
    story.distance = plain(length(as<T>(light.position) - at.position));
    story.attenuation = attenuation(light, at);
  }
  return story;
}

/// What triangle `number` of the frame is asked for at (x, y).
struct ShadowQuestion {
  const FrameContext& context;
  std::uint32_t number;
  std::int32_t x, y;
};

ShadowMapStory shadow_map_story(const DepthMap& map, const InterpolatedPoint& point) {
  ShadowMapStory story;
  const std::size_t face = map.face_of(point.position);
  if (map.view().kind == LightPlace::Kind::point) story.face = cube_face_axes[face].name;
  const MapPlace<double> place = map_place<double>(map.view(), face, point.position, point.normal);
  story.u = place.u, story.v = place.v, story.depth = place.depth;
  const MapTaps taps = map.taps(face, place);
  for (int i = 0; i < taps.count; ++i) {
    const MapTap& tap = taps.tap[static_cast<std::size_t>(i)];
    ShadowTapStory& told = story.taps.emplace_back(ShadowTapStory{tap.column, tap.row, tap.weight, {}, tap.lit});
    if (!tap.outside) told.stored = static_cast<double>(tap.stored);
  }
  return story;
}

/// Of the light with that row.
ShadowStory shadow_story(const ShadowQuestion& at, const FragmentTerms<T>& terms, std::size_t row) {
  ShadowStory story;
  story.visibility = terms.seen[row];
  const SceneShadows& shadows = *at.context.shadows;
  const ShadowedLight& light = shadows.lights()[row];
  const FragmentPoints points(at.context, at.number);
  if (light.kind == Shadow::map) {
    story.map = shadow_map_story(shadows.map(light), points.interpolated_at(at.x, at.y));
  } else if (story.visibility == 0) {
    if (const auto between = shadows.first_between(points.at(at.x, at.y), at.number, light.place))
      story.between = named_triangle(at.context, *between);
  }
  return story;
}

void add_lights(const ShadowQuestion& question, const FragmentTerms<T>& terms, const auto& function,
                FragmentStory& story) {
  const PacketSurface<T>& s = terms.surface;
  const Plain at{s.position, s.normal, s.to_eye, s.texture, nullptr, terms.maps ? &*terms.maps : nullptr};
  std::size_t number = 0, row = 0;
  for_each_light(question.context.scene, [&](const auto& light, std::size_t, std::size_t index) {
    LightStory of = light_story(light, index, at);
    const LightTerm<T>& term = terms.lights[number++];
    of.reflected = plain(term.reflected);
    of.undefined = term.undefined;
    if constexpr (PhongLike<std::remove_cvref_t<decltype(function)>>)
      if (terms.maps) of.specular_map = plain(terms.maps->specular);
    if constexpr (!std::same_as<std::remove_cvref_t<decltype(function)>, UserFunction>)
      add_parts(function, at, arriving(within_range<T>(prepared_light(light)), at).direction, of);
    if (light.shadow != Shadow::none) {
      ShadowStory shadow = shadow_story(question, terms, row++);
      of.arriving *= shadow.visibility;
      if constexpr (!std::same_as<std::remove_cvref_t<decltype(function)>, UserFunction>)
        if (shadow.visibility < 1)
          shadow.reflected = plain(reflected(function, at, arriving(within_range<T>(prepared_light(light)), at)));
      of.shadow = std::move(shadow);
    }
    story.lights.push_back(std::move(of));
  });
}

/// Reads a texture and writes down how.
struct TellReading {
  std::optional<TextureStory>& story;

  Rgb<T> operator()(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& right, const Vec2<T>& down) const {
    const Texture& texture = *map.texture;
    const TextureFilter filter = map.filter;
    TextureStory told;
    const TextureLevel& image = texture.levels[0];
    told.filter = filter;
    told.width = image.width, told.height = image.height;
    told.levels = static_cast<int>(texture.levels.size());
    told.uv_right = plain_of(right), told.uv_down = plain_of(down);
    const auto scaled = [&](const Vec2<T>& by) { return Vec2<T>(by.x * T(map.scale.x), by.y * T(map.scale.y)); };
    if (filter == TextureFilter::trilinear)
      told.level_of_detail = plain(level_of_detail(image, scaled(right), scaled(down)));
    told.texels = texels_read(map, plain_of(uv), told.uv_right, told.uv_down);
    story = std::move(told);
    return sample(map, uv, right, down);
  }
};

/// What lies between the triangle and the formula.
void add_surface(const FrameContext& context, const Material& material, std::uint32_t number, std::int32_t x,
                 std::int32_t y, FragmentStory& story) {
  with_sample<T>(context, number, x, y, [&](const auto& data) {
    const PacketBarycentrics<T> at = barycentrics<Derivatives::yes>(data);
    story.weights = in_order_of_mesh(at.at, corner_order(context, number));
    const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
    story.turned = context.uses.two_sided && is_turned(context, ref, number);
    story.interpolated_normal = plain(attribute_value<&Mesh::normals>(context, data, at.at));
    if (!context.scene.objects[data.object()].mesh->colours.empty())
      story.vertex_colour = plain(vertex_colour(context, data, at));
    if (any(without_uv(data) & first_lane<T>())) return;
    const std::array<double, 2> whole = whole_repeats(context, number);
    const auto uv = [&](int c) { return plain(interpolated_uv(data, c, at)) + whole[static_cast<std::size_t>(c)]; };
    story.uv = Double2(uv(0), uv(1));
    UndefinedCounts uncounted; // the terms have counted these
    const UndefinedTally<T> tally(uncounted, first_lane<T>());
    const auto describe = [&](const TextureMap& map, std::optional<TextureStory>& how) {
      if (map.texture) texture_colour(map, data, at, tally, TellReading{how});
    };
    describe(material.diffuse_map, story.texture);
    if (turns_normals(context, material, data.object())) {
      NormalMapStory maps;
      const auto tangent = attribute_value<&Mesh::tangents>(context, data, at.at);
      maps.unmapped =
          plain(shading_normal(context, data, attribute_value<&Mesh::normals>(context, data, at.at), tally));
      maps.tangent = {plain(tangent.x), plain(tangent.y), plain(tangent.z)}, maps.handedness = plain(tangent.w);
      maps.direction = plain(map_direction(material, data, at, tally));
      describe(material.normal_map, maps.normal_map), describe(material.bump_map, maps.bump_map);
      story.maps_of_normal = std::move(maps);
    }
    if (!material.has_fragment_maps()) return;
    describe(material.emissive_map, story.emissive_map);
    if (!material.microfacets()) return describe(material.specular_map, story.specular_map);
    describe(material.roughness_map, story.roughness_map), describe(material.metallic_map, story.metallic_map);
  });
}

constexpr std::int32_t centre(int pixel) {
  return pixel * subpixels + subpixels / 2;
}

} // namespace

NamedTriangle named_triangle(const FrameContext& context, std::uint32_t number) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  return {ref.object + 1, ref.triangle + 1, context.scene.objects[ref.object].name};
}

std::array<double, 3> corner_weights(const FrameContext& context, std::uint32_t number, std::int32_t x,
                                     std::int32_t y) {
  return with_sample<T>(context, number, x, y, [&](const auto& data) {
    return in_order_of_mesh(barycentrics<Derivatives::no>(data).at, corner_order(context, number));
  });
}

Double3 fragment_radiance(const FrameContext& context, std::uint32_t number, int x, int y) {
  return plain(fragment_terms<T>(context, number, centre(x), centre(y)).radiance);
}

FragmentStory fragment_story(const FrameContext& context, std::uint32_t number, int x, int y, int samples) {
  FragmentStory story;
  story.of = named_triangle(context, number);
  story.samples = samples;
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const Material& material = material_of(context.scene.objects[ref.object], ref.triangle);
  const FragmentTerms<T> terms = fragment_terms<T>(context, number, centre(x), centre(y));
  add_surface(context, material, number, centre(x), centre(y), story);
  story.position = plain(terms.surface.position);
  story.normal = plain(terms.surface.normal);
  story.to_eye = plain(terms.surface.to_eye);
  story.n_v = plain(dot(terms.surface.normal, terms.surface.to_eye));
  story.texture_colour = plain(terms.surface.texture);
  story.material = material.name;
  story.function = material.function_name();
  story.user_function = material.user_function != nullptr;
  if (story.user_function) {
    ParameterVisitor visitor(story.parameters);
    material.user_function->copy()->fields(visitor); // `fields` may change them
  }
  with_function(material, [&]<class Function>(const Function& function) {
    if constexpr (!std::same_as<Function, UserFunction>) Function::fields(function, Parameters{story.parameters});
    add_lights({context, number, centre(x), centre(y)}, terms, function, story);
  });
  story.ambient = plain(terms.ambient);
  if (terms.maps && material.specular_map.texture && !material.microfacets())
    story.specular_colour = plain(terms.maps->specular);
  if (terms.maps && material.emissive != Double3(0)) story.emission = plain(terms.maps->emission);
  story.radiance = plain(terms.radiance);
  story.undefined = terms.undefined;
  story.exact = exact_terms(context, number, centre(x), centre(y));
  return story;
}

} // namespace refraster
