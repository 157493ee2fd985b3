#include "tests/support/slow/slow_shading.h"

#include "tests/support/slow/slow_shadow_maps.h"
#include "tests/support/slow/slow_shadows.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <concepts>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace refraster::slow {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

// Textures.

int wrapped(Real cell, int n) {
  const Real rest = cell - n * std::floor(cell / n);
  return std::min(static_cast<int>(rest), n - 1);
}

int placed(Real cell, int n, TextureWrap wrap) {
  return wrap == TextureWrap::repeat ? wrapped(cell, n)
                                     : static_cast<int>(std::clamp(cell, Real(0), static_cast<Real>(n - 1)));
}

Vec texel(const TextureLevel& level, Real x, Real y, TextureWrap wrap) {
  const auto at = 3 * (static_cast<std::size_t>(placed(y, level.height, wrap)) * static_cast<std::size_t>(level.width) +
                       static_cast<std::size_t>(placed(x, level.width, wrap)));
  return {real(level.rgb[at]), real(level.rgb[at + 1]), real(level.rgb[at + 2])};
}

Vec bilinear(const TextureLevel& level, Real u, Real v, TextureWrap wrap) {
  const Real x = u * level.width - Real(0.5), y = v * level.height - Real(0.5);
  const Real s = x - std::floor(x), t = y - std::floor(y), i = std::floor(x), j = std::floor(y);
  return texel(level, i, j, wrap) * ((1 - s) * (1 - t)) + texel(level, i + 1, j, wrap) * (s * (1 - t)) +
         texel(level, i, j + 1, wrap) * ((1 - s) * t) + texel(level, i + 1, j + 1, wrap) * (s * t);
}

/// Where an image is read, and how that changes by a pixel to the right and down.
struct Place {
  Real u, v, u_right, v_right, u_down, v_down;
};

Vec trilinear(const Texture& texture, const Place& at, TextureWrap wrap) {
  const TextureLevel& image = texture.levels[0];
  const Real right = std::hypot(at.u_right * image.width, at.v_right * image.height);
  const Real down = std::hypot(at.u_down * image.width, at.v_down * image.height);
  const auto last = real(texture.levels.size() - 1);
  const Real detail = std::clamp(std::log2(std::max(right, down)), Real(0), last);
  const auto lower = static_cast<std::size_t>(detail), upper = std::min(lower + 1, texture.levels.size() - 1);
  const Real share = detail - real(lower);
  return bilinear(texture.levels[lower], at.u, at.v, wrap) * (1 - share) +
         bilinear(texture.levels[upper], at.u, at.v, wrap) * share;
}

Vec texture_colour(const TextureMap& map, const Seen& seen) {
  if (!map.texture || !seen.has_uv) return {1, 1, 1};
  const Real a = real(map.scale.x), b = real(map.scale.y);
  const Place at{seen.u * a + real(map.offset.x),
                 seen.v * b + real(map.offset.y),
                 seen.u_right * a,
                 seen.v_right * b,
                 seen.u_down * a,
                 seen.v_down * b};
  const Texture& texture = *map.texture;
  const TextureLevel& image = texture.levels[0];
  const Real scale = 1 / real(texture.full_scale);
  switch (map.filter) {
  case TextureFilter::nearest:
    return texel(image, std::floor(at.u * image.width), std::floor(at.v * image.height), map.wrap) * scale;
  case TextureFilter::bilinear:
    return bilinear(image, at.u, at.v, map.wrap) * scale;
  case TextureFilter::trilinear:
    return trilinear(texture, at, map.wrap) * scale;
  }
  return {};
}

// Normals.

/// By how much a map's value grows over a texel, in its first channel, along u or v of the image.
Real slope(const TextureMap& map, const Seen& seen, int axis) {
  const TextureLevel& image = map.texture->levels[0];
  const Real texel = 1 / real(axis == 0 ? image.width : image.height);
  const auto height = [&](Real to) {
    Seen there = seen; // coordinates of the image itself
    there.u = seen.u * real(map.scale.x) + real(map.offset.x) + (axis == 0 ? to : 0);
    there.v = seen.v * real(map.scale.y) + real(map.offset.y) + (axis == 1 ? to : 0);
    there.u_right *= real(map.scale.x), there.u_down *= real(map.scale.x);
    there.v_right *= real(map.scale.y), there.v_down *= real(map.scale.y);
    TextureMap plain = map;
    plain.scale = Double2(1), plain.offset = Double2(0);
    return texture_colour(plain, there).x;
  };
  return (height(texel) - height(-texel)) / 2;
}

Real sign_of(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// The surface's height over the plane of tangent and bitangent falls by what the maps' normals lean.
Vec mapped_normal(const Seen& seen) {
  const Material& material = *seen.material;
  if (!seen.has_uv || (!material.normal_map.texture && !material.bump_map.texture)) return seen.normal;
  if (seen.object->mesh->tangents.empty()) return seen.normal;
  Vec m{0, 0, 1};
  if (const TextureMap& map = material.normal_map; map.texture) {
    const Vec colour = texture_colour(map, seen);
    const Real strength = real(material.normal_scale);
    m = {(2 * colour.x - 1) * strength * sign_of(map.scale.x), (2 * colour.y - 1) * strength * sign_of(map.scale.y),
         2 * colour.z - 1};
  }
  if (const TextureMap& map = material.bump_map; map.texture) {
    const Real strength = real(material.bump_scale);
    m.x -= slope(map, seen, 0) * strength * sign_of(map.scale.x);
    m.y -= slope(map, seen, 1) * strength * sign_of(map.scale.y);
  }
  // What is seen from behind is the same surface, and its normal the opposite one.
  const Real side = seen.turned ? -1 : 1;
  const Vec n = seen.normal * side, b = cross(n, seen.tangent) * seen.handedness;
  const Vec sum = seen.tangent * m.x + b * m.y + n * m.z;
  return length(sum) > 0 ? unit(sum) * side : seen.normal;
}

// Measured BRDFs.

struct Angles {
  Real theta_h, theta_d, phi_d;
};

/// As the database's own reader has it, in a frame with the normal on the pole: turn i by -phi_h about the normal, then
/// by -theta_h about the y axis.
Angles half_difference(Vec n, Vec i, Vec o) {
  const Vec helper = std::abs(n.x) < Real(0.5) ? Vec{1, 0, 0} : Vec{0, 1, 0};
  const Vec x_axis = unit(cross(helper, n)), y_axis = cross(n, x_axis);
  const Vec h = unit(i + o);
  const Real theta_h = std::acos(std::min(dot(n, h), Real(1))), theta_d = std::acos(std::min(dot(i, h), Real(1)));
  const Real phi_h = std::atan2(dot(h, y_axis), dot(h, x_axis));
  const Vec local = {dot(i, x_axis), dot(i, y_axis), dot(i, n)};
  const Vec turned = {local.x * std::cos(phi_h) + local.y * std::sin(phi_h),
                      -local.x * std::sin(phi_h) + local.y * std::cos(phi_h), local.z};
  const Real difference_x = turned.x * std::cos(theta_h) - turned.z * std::sin(theta_h);
  Real phi_d = std::atan2(turned.y, difference_x);
  if (phi_d < 0) phi_d += pi;
  return {theta_h, theta_d, phi_d};
}

/// A sample, or nothing where none was measured. phi_d repeats, the others stay within the table.
std::optional<Vec> sample(const MerlTable& table, Real h, Real d, Real p) {
  const int h_bin = std::clamp(static_cast<int>(h), 0, MerlTable::theta_h_bins - 1);
  const int d_bin = std::clamp(static_cast<int>(d), 0, MerlTable::theta_d_bins - 1);
  const Vec rgb = vec(table.sample(h_bin, d_bin, wrapped(p, MerlTable::phi_d_bins)));
  if (rgb.x < 0 || rgb.y < 0 || rgb.z < 0) return std::nullopt;
  return rgb;
}

/// `first`: where sample 0 stands on each axis, in bins.
Vec trilinear(const MerlTable& table, Real u, Real v, Real w, Real first) {
  Vec sum;
  Real weights = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Real weight = 1;
    const auto step = [&](Real x, int bit) {
      const Real cell = std::floor(x - first), fraction = x - first - cell;
      weight *= corner >> bit & 1 ? fraction : 1 - fraction;
      return cell + (corner >> bit & 1);
    };
    const Real h = step(u, 0), d = step(v, 1), p = step(w, 2);
    if (const auto rgb = sample(table, h, d, p)) sum = sum + *rgb * weight, weights += weight;
  }
  return weights > 0 ? sum * (1 / weights) : Vec{};
}

std::optional<Vec> brdf(const Merl& merl, Vec n, Vec i, Vec o) {
  const Angles angles = half_difference(n, i, o);
  const Real u = 90 * std::sqrt(angles.theta_h / (pi / 2)), v = 90 * angles.theta_d / (pi / 2);
  const Real w = 180 * angles.phi_d / pi;
  switch (merl.lookup) {
  case MerlLookup::nearest:
    return sample(*merl.table, std::floor(u), std::floor(v), std::min(std::floor(w), Real(179))).value_or(Vec{});
  case MerlLookup::trilinear:
    return trilinear(*merl.table, u, v, w, Real(0.5));
  case MerlLookup::trilinear_edge:
    return trilinear(*merl.table, u, v, w, 0);
  case MerlLookup::trilinear_log:
  case MerlLookup::tricubic_log:
    return std::nullopt;
  }
  return std::nullopt;
}

// Light.

/// What shadows leave of a light.
class Visibility {
public:
  Visibility(const Scene& scene, const Seen& seen) : scene_(scene), seen_(seen) {
    if (has_shadows(scene, Shadow::exact)) casters_.emplace(scene);
  }

  Real of(const auto& light, Vec to, bool is_direction) {
    if (light.shadow == Shadow::none) return 1;
    std::optional<Real> visible;
    if (light.shadow == Shadow::map) visible = SlowShadowMap(scene_, light).visibility(seen_.position, seen_.normal);
    else if (const std::optional<bool> sees = casters_->sees(seen_, to, is_direction)) visible = *sees ? 1 : 0;
    doubtful = doubtful || !visible;
    return visible.value_or(1);
  }
  bool doubtful = false;

private:
  const Scene& scene_;
  const Seen& seen_;
  std::optional<ShadowCasters> casters_;
};

std::vector<Arriving> lights_at(const Scene& scene, const Seen& seen, bool& doubtful) {
  std::vector<Arriving> lights;
  Visibility visibility(scene, seen);
  for (const PointLight& light : scene.point_lights) {
    const Vec way = vec(light.position) - seen.position;
    const Real d = length(way);
    const Real divisor = real(light.constant) + real(light.linear) * d + real(light.quadratic) * d * d;
    const Real seen_light = visibility.of(light, vec(light.position), false);
    lights.push_back({unit(way), vec(light.radiance) * ((divisor > 0 ? 1 / divisor : 1) * seen_light)});
  }
  for (const DirectionLight& light : scene.direction_lights) {
    const Vec to = vec(light.direction) * Real(-1);
    lights.push_back({unit(to), vec(light.radiance) * visibility.of(light, to, true)});
  }
  doubtful = visibility.doubtful;
  return lights;
}

/// The cosine of the highlight: r.v of Phong, n.h of Blinn-Phong.
Real highlight_cosine(const Phong&, Vec n, Vec l, Vec v) {
  return dot(n * (2 * dot(n, l)) - l, v);
}
Real highlight_cosine(const BlinnPhong&, Vec n, Vec l, Vec v) {
  return dot(n, unit(l + v));
}

// The formulas.

template <class Function>
  requires std::derived_from<Function, PhongParameters> std::optional<Shaded> shaded_by(const Function& function,
                                                                                        const Lit& at) {
    Shaded result{vec(function.ka) * at.texture + at.emission, vec(function.ka) + at.emission};
    for (const Arriving& light : at.lights) {
      const Real n_l = dot(at.normal, light.direction);
      const Real cosine = std::max(highlight_cosine(function, at.normal, light.direction, at.to_eye), Real(0));
      const bool cut = function.specular_gate == SpecularGate::cut_below_horizon && !(n_l > 0);
      const Real highlight = cut ? 0 : std::pow(cosine, real(function.glossiness));
      const Vec diffuse = vec(function.kd) * std::max(n_l, Real(0)),
                specular = vec(function.ks) * at.specular * highlight;
      result.radiance = result.radiance + (diffuse * at.texture + specular) * light.radiance;
      result.magnitude = result.magnitude + (diffuse + specular) * light.radiance;
    }
    return result;
  }

std::optional<Shaded> shaded_by(const Merl& merl, const Lit& at) {
  Shaded result;
  for (const Arriving& light : at.lights) {
    const Real n_l = dot(at.normal, light.direction);
    if (n_l <= 0 || dot(at.normal, at.to_eye) <= 0) continue;
    const std::optional<Vec> f = brdf(merl, at.normal, light.direction, at.to_eye);
    if (!f) return std::nullopt;
    result.radiance = result.radiance + *f * light.radiance * n_l;
  }
  result.magnitude = result.radiance;
  return result;
}

Real fifth(Real x) {
  return x * x * x * x * x;
}

/// Fresnel's equations with the angle inside by Snell's law.
Real dielectric(Real cosine, Real ior) {
  const Real inside = std::sqrt(std::max(1 - (1 - cosine * cosine) / (ior * ior), Real(0)));
  const Real s = (cosine - ior * inside) / (cosine + ior * inside),
             p = (ior * cosine - inside) / (ior * cosine + inside);
  return (s * s + p * p) / 2;
}

/// The same with a complex refractive index.
Real conductor(Real cosine, Real eta, Real k) {
  using Complex = std::complex<Real>;
  const Complex index(eta, k), squared = index * index;
  const Complex inside = std::sqrt(squared - (1 - cosine * cosine));
  const Complex s = (cosine - inside) / (cosine + inside),
                p = (squared * cosine - inside) / (squared * cosine + inside);
  return (std::norm(s) + std::norm(p)) / 2;
}

/// With Smith's function of tangents, and the density's of the angle between normal and half vector.
std::optional<Shaded> shaded_by(const Microfacet& m, const Lit& at) {
  Shaded result{at.emission, at.emission};
  const Real n_v = dot(at.normal, at.to_eye), roughness = std::max(real(m.roughness) * at.roughness, Real(1e-4L));
  const Real alpha = roughness * roughness, metallic = real(m.metallic) * at.metallic, ior = real(m.ior);
  const Vec base = vec(m.base_color) * at.texture;
  const bool is_schlick = m.fresnel == MicrofacetFresnel::schlick;
  const Real f0 = (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1));
  const auto lambda = [&](Real cosine) {
    const Real tangent = std::tan(std::acos(std::min(cosine, Real(1))));
    return (std::sqrt(1 + alpha * alpha * tangent * tangent) - 1) / 2;
  };
  const auto into_the_ground = [&](Real cosine) {
    return 1 - (is_schlick ? f0 + (1 - f0) * fifth(1 - cosine) : dielectric(cosine, ior));
  };
  for (const Arriving& light : at.lights) {
    const Real n_l = dot(at.normal, light.direction);
    if (n_l <= 0 || n_v <= 0) continue;
    const Vec h = unit(light.direction + at.to_eye), across = cross(at.normal, h);
    const Real n_h = dot(at.normal, h), l_h = std::min(dot(light.direction, h), Real(1)), sine_2 = dot(across, across);
    const Real peak = 1 / (pi * alpha * alpha), spread = n_h * n_h + sine_2 / (alpha * alpha);
    const Real lobe = peak / (spread * spread) / (1 + lambda(n_l) + lambda(n_v)) / (4 * n_v);
    const auto fresnel = [&](Real of_base, double eta, double k) {
      const Real schlick = of_base + (1 - of_base) * fifth(1 - l_h);
      if (is_schlick) {
        const Real mixed = f0 * (1 - metallic) + of_base * metallic;
        return mixed + (1 - mixed) * fifth(1 - l_h);
      }
      const Real metal = m.fresnel == MicrofacetFresnel::conductor ? conductor(l_h, real(eta), real(k)) : schlick;
      return dielectric(l_h, ior) * (1 - metallic) + metal * metallic;
    };
    const Vec f{fresnel(base.x, m.eta.x, m.k.x), fresnel(base.y, m.eta.y, m.k.y), fresnel(base.z, m.eta.z, m.k.z)};
    const Vec diffuse = base * ((1 - metallic) / pi * into_the_ground(n_l) * into_the_ground(n_v) * n_l);
    result.radiance = result.radiance + (diffuse + f * lobe) * light.radiance;
    // A highlight is as uncertain as its middle: what is lost of the angle is lost of the density there.
    result.magnitude = result.magnitude + (diffuse + f * (lobe * (1 + 1 / alpha))) * light.radiance;
  }
  return result;
}

template <class Function>
concept HasFormula = requires(const Function& function, const Lit& at) {
  shaded_by(function, at);
};

} // namespace

Lit lit(const Scene& scene, const Seen& seen) {
  bool doubtful = false;
  std::vector<Arriving> lights = lights_at(scene, seen, doubtful);
  return {mapped_normal(seen),
          unit(vec(scene.camera.position) - seen.position),
          texture_colour(seen.material->diffuse_map, seen) * seen.colour,
          std::move(lights),
          texture_colour(seen.material->specular_map, seen),
          vec(seen.material->emissive) * texture_colour(seen.material->emissive_map, seen),
          doubtful,
          texture_colour(seen.material->roughness_map, seen).x,
          texture_colour(seen.material->metallic_map, seen).x};
}

std::optional<bool> is_there(const Seen& seen) {
  const Material& material = *seen.material;
  if (!material.opacity_map.texture || material.opacity_threshold == 0) return true; // nothing is below 0
  // Double is good to some 2^-50 of texture coordinates of some repeats, and to less of what is read there, which lies
  // in [0, 1]; the doubt is eight times as much and more.
  constexpr Real place_doubt = 0x1p-40L, value_doubt = 0x1p-30L;
  const Real threshold = real(material.opacity_threshold);
  bool any_there = false, any_cut = false;
  for (const Real du : {-place_doubt, place_doubt})
    for (const Real dv : {-place_doubt, place_doubt}) {
      Seen beside = seen;
      beside.u += du * (1 + std::abs(seen.u)), beside.v += dv * (1 + std::abs(seen.v));
      const Real value = texture_colour(material.opacity_map, beside).x;
      any_there |= value > threshold - value_doubt, any_cut |= value < threshold + value_doubt;
    }
  if (any_there && any_cut) return std::nullopt;
  return any_there;
}

bool has_formula(const FragmentFunction& function) {
  return std::visit([]<class Function>(const Function&) { return HasFormula<Function>; }, function);
}

std::optional<Shaded> shaded(const Scene& scene, const Seen& seen) {
  if (!seen.object) return Shaded{vec(scene.background), vec(scene.background)};
  const Material& material = *seen.material;
  if (material.user_function || !has_formula(material.fragment_function))
    throw std::logic_error("slow_shading.cpp has no formula of " + std::string(material.function_name()));
  const Lit at = lit(scene, seen);
  if (at.doubtful) return std::nullopt;
  return std::visit(
      [&]<class Function>(const Function& function) -> std::optional<Shaded> {
        if constexpr (HasFormula<Function>) return shaded_by(function, at);
        return std::nullopt;
      },
      material.fragment_function);
}

} // namespace refraster::slow
