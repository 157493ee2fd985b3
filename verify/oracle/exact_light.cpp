#include "verify/oracle/exact_light.h"

#include "verify/oracle/exact_merl.h"
#include "verify/oracle/exact_texture.h"

#include <concepts>

namespace refraster::oracle {
namespace {

/// At one point of a surface: unit vectors away from it, and the texture's colour.
struct At {
  Exact3 n, v, t;
};
struct Arriving {
  Exact3 l, c; // unit vector to the light; radiance with attenuation
};

// What formulas there are. A fragment function that is not among them has no oracle.

Exact cosine_of_highlight(const Phong&, const At& at, const Exact3& l) {
  return dot(at.n * (2 * dot(at.n, l)) - l, at.v);
}
Exact cosine_of_highlight(const BlinnPhong&, const At& at, const Exact3& l) {
  return dot(at.n, unit(l + at.v));
}

template <class Model>
  requires std::derived_from<Model, PhongParameters> Exact3 ambient(const Model& model, const At& at) {
    return exact(model.ka) * at.t;
  }
template <class Model>
  requires std::derived_from<Model, PhongParameters> Exact3 reflected(const Model& model, const At& at,
                                                                      const Arriving& light) {
    const Exact n_l = dot(at.n, light.l);
    const Exact cosine = positive(cosine_of_highlight(model, at, light.l));
    const bool cut = model.specular_gate == SpecularGate::cut_below_horizon && n_l <= 0;
    Exact highlight = 0;
    if (model.glossiness == 0) highlight = 1;
    else if (cosine > 0) highlight = pow(cosine, Exact(model.glossiness));
    if (cut) highlight = 0;
    return (exact(model.kd) * at.t * positive(n_l) + exact(model.ks) * highlight) * light.c;
  }

Exact3 ambient(const Merl&, const At&) {
  return {0, 0, 0};
}
Exact3 reflected(const Merl& merl, const At& at, const Arriving& light) {
  const Exact n_l = dot(at.n, light.l);
  if (n_l <= 0 || dot(at.n, at.v) <= 0) return {0, 0, 0};
  return merl_brdf(*merl.table, merl.lookup, at.n, light.l, at.v) * n_l * light.c;
}

std::optional<Arriving> arriving(const PointLight& light, const Exact3& position) {
  const Exact3 way = exact(light.position) - position;
  const Exact d = length(way);
  if (d == 0) return std::nullopt;
  const Exact divisor = light.constant + d * (light.linear + d * Exact(light.quadratic));
  return Arriving{unit(way), exact(light.radiance) * (divisor > 0 ? 1 / divisor : Exact(1))};
}
std::optional<Arriving> arriving(const DirectionLight& light, const Exact3&) {
  return Arriving{unit(exact(light.direction)) * -1, exact(light.radiance)};
}

} // namespace

std::optional<Exact3> radiance(const Scene& scene, const Object& object, const SurfacePoint& point) {
  const Exact3 to_eye = exact(scene.camera.position) - point.position;
  if (dot(to_eye, to_eye) == 0) return std::nullopt;
  const At at{point.normal, unit(to_eye), texture_colour(object.material, point)};
  return std::visit(
      [&](const auto& model) -> std::optional<Exact3> {
        if constexpr (requires(const Arriving& light) { reflected(model, at, light); }) {
          Exact3 sum = ambient(model, at);
          const auto add_all = [&](const auto& lights) {
            for (const auto& light : lights) {
              const std::optional<Arriving> arrives = arriving(light, point.position);
              if (!arrives) return false;
              const Exact3 l_v = arrives->l + at.v;
              if (dot(l_v, l_v) == 0) return false; // no half vector
              sum = sum + reflected(model, at, *arrives);
            }
            return true;
          };
          if (add_all(scene.point_lights) && add_all(scene.direction_lights)) return sum;
        }
        return std::nullopt;
      },
      object.material.model);
}

} // namespace refraster::oracle
