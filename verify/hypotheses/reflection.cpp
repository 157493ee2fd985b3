#include "verify/hypotheses/reflection.h"

#include "shading/fragment_batch.h"
#include "shading/fragment_functions.h"
#include "shading/light.h"
#include "shading/srgb_curve.h"
#include "verify/hypotheses/measured.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace refraster::hypotheses {
namespace {

PointLight with_attenuation(PointLight light, Attenuation attenuation) {
  const auto set = [&](double constant, double linear, double quadratic) {
    light.constant = constant, light.linear = linear, light.quadratic = quadratic;
  };
  const double k = light.constant, l = light.linear, q = light.quadratic;
  switch (attenuation) {
  case Attenuation::right:
  case Attenuation::twice:
    break;
  case Attenuation::missing:
    set(1, 0, 0);
    break;
  case Attenuation::without_square:
    set(k, l, 0);
    break;
  case Attenuation::without_linear:
    set(k, 0, q);
    break;
  case Attenuation::square_of_d:
    set(k, l + q, 0);
    break;
  case Attenuation::linear_of_square:
    set(k, 0, l + q);
    break;
  case Attenuation::inverse:
    set(0, 1, 0);
    break;
  case Attenuation::inverse_square:
    set(0, 0, 1);
    break;
  }
  return light;
}

PointLight light_with(const PointLight& light, const Steps& steps) {
  PointLight result = with_attenuation(textbook_light(light), steps.attenuation);
  if (steps.radiance == Radiance::missing) result.radiance = Double3(1);
  return result;
}
DirectionLight light_with(DirectionLight light, const Steps& steps) {
  if (steps.radiance == Radiance::missing) light.radiance = Double3(1);
  return light;
}

/// Turned round, by where the light is.
template <class Light>
constexpr LightDirection reversed_alone = std::is_same_v<Light, PointLight> ? LightDirection::point_lights_reversed
                                                                            : LightDirection::direction_lights_reversed;

/// How much of a light is seen by its map, as the hypothesis has it.
double visibility(const DepthMap& map, const Surface& surface, ShadowMaps maps) {
  if (maps == ShadowMaps::missing) return 1;
  LightView view = map.view();
  if (maps == ShadowMaps::bias_missing) view.map.bias = view.map.slope_bias = 0;
  if (maps == ShadowMaps::bias_reversed) view.map.bias *= -1, view.map.slope_bias *= -1;
  const std::size_t face = map.face_of(surface.position);
  MapPlace<double> place = map_place<double>(view, face, surface.position, surface.mesh_normal);
  if (maps == ShadowMaps::rows_reversed) place.v = view.map.size - place.v;
  const bool turns = maps == ShadowMaps::opposite_face && view.kind == LightPlace::Kind::point;
  return lit_fraction(map.taps(turns ? face ^ 1 : face, place), view.map.filter);
}

/// A light that is already as the hypothesis has it, and how much of it is seen.
template <class Light>
struct SeenLight {
  Light light;
  double visibility = 1;
};

/// What arrives of it.
template <class Light>
Incident<double> incident(const SeenLight<Light>& seen, const Fragment<double>& at, const Steps& steps) {
  const Light& light = seen.light;
  Incident<double> result = arriving(light, at);
  result.radiance *= seen.visibility;
  if (steps.light_direction == LightDirection::all_reversed || steps.light_direction == reversed_alone<Light>)
    result.direction = -result.direction;
  if constexpr (std::is_same_v<Light, PointLight>) {
    if (steps.light_direction == LightDirection::not_normalised) result.direction = light.position - at.position;
    if (steps.attenuation == Attenuation::twice) {
      PointLight white = light;
      white.radiance = Double3(1);
      result.radiance *= arriving(white, at).radiance;
    }
  }
  return result;
}

/// Parameters as the hypothesis has them.
template <class Function>
Function parameters_with(Function function, const Rgb<double>& texture, const Steps& steps) {
  if (steps.ambient == Ambient::twice) function.ka *= 2.0;
  if (steps.ambient == Ambient::missing) function.ka = Double3(0);
  if (steps.ambient == Ambient::without_texture)
    for (int c = 0; c < 3; ++c) function.ka[c] = texture[c] > 0 ? function.ka[c] / texture[c] : function.ka[c];
  if (steps.diffuse == Diffuse::missing) function.kd = Double3(0);
  if (steps.lobe == Lobe::missing) function.ks = Double3(0);
  if (steps.texture_use == TextureUse::on_highlight) function.ks *= texture;
  if (steps.gate == Gate::other)
    function.specular_gate =
        function.specular_gate == SpecularGate::open ? SpecularGate::cut_below_horizon : SpecularGate::open;
  constexpr double factors[] = {1, 2, 4, 0.5, 0.25};
  function.glossiness *= factors[static_cast<std::size_t>(steps.glossiness)];
  return function;
}

/// The two directions whose cosine makes the highlight.
struct LobeDirections {
  Double3 a, b;
};
LobeDirections lobe_directions(const Phong&, const Fragment<double>& at, const Double3& l, Lobe lobe) {
  const Double3 r = at.normal * (2 * dot(at.normal, l)) - l;
  return {lobe == Lobe::reflect_reversed ? -r : r, at.to_eye};
}
LobeDirections lobe_directions(const BlinnPhong&, const Fragment<double>& at, const Double3& l, Lobe lobe) {
  const Double3 h = l + at.to_eye;
  return {at.normal, lobe == Lobe::half_not_normalised ? h : normalize(h)};
}

/// A power of their cosine, and of their lengths, as GLSL has it: cosine_power() takes them to be 1.
double power_of(const LobeDirections& lobe, double exponent, double nudge) {
  const double cosine = dot(lobe.a, lobe.b) + nudge * length(lobe.a) * length(lobe.b);
  return std::pow(max0(cosine), exponent) * (1 + nudge * (exponent + 8));
}

template <class Function>
Rgb<double> reflected_with(const Function& function, const Fragment<double>& at, const Incident<double>& light,
                           const Steps& steps, const Nudge& nudge, bool unit) {
  Rgb<double> result;
  const double n_l = dot(at.normal, light.direction);
  if (unit && steps.lobe != Lobe::reflect_reversed && steps.lobe != Lobe::half_not_normalised) {
    result = reflected(function, at, light);
  } else {
    const LobeDirections lobe = lobe_directions(function, at, light.direction, steps.lobe);
    result = diffuse_and_highlight(function, at, light, n_l, power_of(lobe, function.glossiness, nudge.lobe));
  }
  if (steps.diffuse == Diffuse::not_clamped) result += function.kd * at.texture * std::min(n_l, 0.0) * light.radiance;
  return result;
}

/// What lights a surface.
struct Lighting {
  const Scene& scene;
  const Prepared& prepared;
  const Surface& surface;
  const Steps& steps;
};

/// Calls body(seen light) with all lights as the hypothesis has them, but for the missing one.
template <class Body>
void for_each_light(const Lighting& of, const Body& body) {
  std::uint32_t number = 0;
  std::size_t next_map = 0;
  for_each_light_list(of.scene, [&]<class Light>(const std::vector<Light>& lights) {
    for (const Light& light : lights) {
      SeenLight<Light> seen{light_with(light, of.steps)};
      if (light.shadow == Shadow::map)
        seen.visibility = visibility(of.prepared.shadow_maps()[next_map++], of.surface, of.steps.shadow_maps);
      if (const std::uint32_t i = number++; i != of.steps.missing_light && i != of.steps.other_missing_light)
        body(seen);
    }
  });
}

template <class Function>
Rgb<double> plastic_colour(const Lighting& lighting, const Function& material, const Fragment<double>& at,
                           const Nudge& nudge) {
  const Surface& surface = lighting.surface;
  const Steps& steps = lighting.steps;
  const Function function = parameters_with(material, at.texture, steps);
  const bool unit = surface.unit && steps.light_direction != LightDirection::not_normalised;
  const Rgb<double> own = ambient(function, at);
  Rgb<double> sum = steps.ambient == Ambient::each_light ? Rgb<double>(0) : own;
  if (at.maps) sum += at.maps->emission;
  for_each_light(lighting, [&](const auto& light) {
    const Incident<double> arrived = incident(light, at, steps);
    sum += reflected_with(function, at, arrived, steps, nudge, unit);
    if (steps.ambient == Ambient::each_light) sum += own;
  });
  return sum;
}

/// What microfacets reflect of a light, by the product's own pieces of the formula.
Rgb<double> reflected_with(const Microfacet& function, const Fragment<double>& at, const Incident<double>& light,
                           Microfacets microfacets) {
  Microfacet changed = function;
  Fragment<double> there = at;
  FragmentMaps<double> maps = at.maps ? *at.maps : FragmentMaps<double>{Rgb<double>(1), Rgb<double>(0)};
  if (microfacets == Microfacets::roughness_not_squared) {
    changed.roughness = std::sqrt(changed.roughness), maps.specular.y = std::sqrt(maps.specular.y);
    if (at.maps) there.maps = &maps;
  }
  MicrofacetTerms<double> terms = microfacet_terms(changed, there, light.direction);
  const double n_v = dot(at.normal, at.to_eye);
  const bool lit = dot(at.normal, light.direction) > 0 && n_v > 0;
  if (microfacets == Microfacets::masking_missing && lit) terms.specular = terms.fresnel * (terms.density / (4 * n_v));
  if (microfacets == Microfacets::fresnel_not_clamped && lit && function.fresnel == MicrofacetFresnel::schlick) {
    // What is less than 0 has a sign in its fifth power.
    const double away = 1 - dot(light.direction + at.to_eye, at.to_eye), weight = away * away * away * away * away;
    const MicrofacetSurface<double> surface = microfacet_surface(changed, there);
    const Rgb<double> f0 = Rgb<double>((1 - surface.metallic) * surface.ior_f0) + surface.base * surface.metallic;
    terms.specular = schlick_reflectance(f0, weight) * (terms.density * terms.cosine_over_divisor);
  }
  return (terms.diffuse + terms.specular) * light.radiance;
}

/// A fragment function of the user's is asked as a frame asks it: a batch of one. Its formula is its own; what comes
/// before it may be changed.
Rgb<double> user_colour(const Lighting& lighting, const UserFunction& function, const Fragment<double>& at) {
  constexpr std::size_t stride = FragmentBatch::padding;
  std::vector<double> values(FragmentBatch::rows * stride), rgb(3 * stride);
  const auto put = [&](int row, const Double3& v) {
    for (std::size_t c = 0; c < 3; ++c)
      std::fill_n(&values[(static_cast<std::size_t>(row) + c) * stride], stride, v[static_cast<int>(c)]);
  };
  put(FragmentBatch::position, at.position), put(FragmentBatch::normal, at.normal);
  put(FragmentBatch::to_eye, at.to_eye), put(FragmentBatch::texture, at.texture);
  Scene lights;
  std::vector<double> visibility; // of those with a shadow, a row each
  for_each_light(lighting, [&]<class Light>(const SeenLight<Light>& seen) {
    if constexpr (std::is_same_v<Light, PointLight>) lights.point_lights.push_back(seen.light);
    else lights.direction_lights.push_back(seen.light);
    if (seen.light.shadow != Shadow::none) visibility.insert(visibility.end(), stride, seen.visibility);
  });
  UndefinedCounts counts;
  FragmentBatch batch;
  batch.fragments = 1, batch.stride = stride;
  batch.values = values.data(), batch.rgb = rgb.data();
  batch.lights = light_spans(lights), batch.undefined = &counts;
  if (!visibility.empty()) batch.visibility = {visibility.data(), stride};
  function.shade(batch);
  return {rgb[0], rgb[stride], rgb[2 * stride]};
}

} // namespace

Rgb<double> colour_of(const Scene& scene, const Material& material, const Prepared& prepared, const Surface& surface,
                      const Steps& steps, const Nudge& nudge) {
  const Fragment<double> at{surface.position, surface.normal, surface.to_eye,
                            surface.texture,  nullptr,        surface.maps ? &*surface.maps : nullptr};
  const Lighting lighting{scene, prepared, surface, steps};
  if (material.user_function) return user_colour(lighting, *material.user_function, at);
  const bool exchanged = steps.lobe == Lobe::exchanged;
  if (const Phong* const phong = std::get_if<Phong>(&material.fragment_function))
    return exchanged ? plastic_colour(lighting, BlinnPhong{*phong}, at, nudge)
                     : plastic_colour(lighting, *phong, at, nudge);
  if (const BlinnPhong* const blinn = std::get_if<BlinnPhong>(&material.fragment_function))
    return exchanged ? plastic_colour(lighting, Phong{*blinn}, at, nudge) : plastic_colour(lighting, *blinn, at, nudge);
  Rgb<double> sum(0);
  if (const Microfacet* const function = material.microfacets()) {
    if (at.maps) sum = at.maps->emission;
    for_each_light(lighting, [&](const auto& light) {
      sum += reflected_with(*function, at, incident(light, at, steps), steps.microfacets);
    });
  }
  if (const Merl* const merl = material.measured())
    for_each_light(lighting, [&](const auto& light) {
      sum += reflected_with(*merl, at, incident(light, at, steps), prepared, steps, nudge);
    });
  return sum;
}

Rgb<double> output_of(const Rgb<double>& linear, Output output, double scale) {
  const auto each = [&](const auto& map) -> Rgb<double> { return {map(linear.x), map(linear.y), map(linear.z)}; };
  const auto unit = [](double x) { return std::clamp(x, 0.0, 1.0); };
  switch (output) {
  case Output::right:
    return linear;
  case Output::gamma_encoded:
    return each([](double x) { return std::pow(std::max(x, 0.0), 1 / 2.2); });
  case Output::gamma_decoded:
    return each([](double x) { return std::pow(std::max(x, 0.0), 2.2); });
  case Output::srgb_encoded:
    return each([&](double x) { return srgb_encoded(unit(x)); });
  case Output::srgb_decoded:
    return each([&](double x) { return srgb_decoded(unit(x)); });
  case Output::red_blue_exchanged:
    return {linear.z, linear.y, linear.x};
  case Output::video_range:
    return each([&](double x) { return (16 + 219 * unit(x)) / 255; });
  case Output::video_range_removed:
    return each([](double x) { return (255 * x - 16) / 219; });
  case Output::scaled:
    return linear * scale;
  }
  return linear;
}

} // namespace refraster::hypotheses
