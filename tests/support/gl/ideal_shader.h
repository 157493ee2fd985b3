#pragma once
// What a pixel ought to show: our own fragment functions in double, whose inputs a bound may move one by one.

#include "raster/shade/shade_packet.h"
#include "shading/fragment_functions.h"

#include <utility>

namespace refraster {

inline constexpr double float_rounding = 0x1p-24; // half a unit in the last place of a float at 1

/// Everything that is interpolated.
struct Varyings {
  Double3 position, normal;
  Double2 uv;
};
inline constexpr int varying_components = 8;

inline double& component(Varyings& v, int i) {
  return i < 3 ? v.position[i] : i < 6 ? v.normal[i - 3] : v.uv[i - 6];
}

/// The colour of a surface with these varyings, in double; with a measured BRDF's table point moved, in bins, or with
/// what is cut off at a horizon going on a little below it.
struct IdealShader {
  const Scene& scene;
  const Material& material;
  Double2 uv_right, uv_down; // for the level of detail
  MerlPoint<double> moved{0, 0, 0};
  Double3 texture_moved{0};
  double below_horizon = 0; // a cosine

  /// Whether the colour jumps at a horizon: that of the eye for a measured BRDF, of a light for a gated highlight.
  bool jumps() const {
    return std::visit(
        [](const auto& function) {
          if constexpr (requires { function.specular_gate; }) return function.specular_gate != SpecularGate::open;
          return std::is_same_v<std::decay_t<decltype(function)>, Merl>;
        },
        material.fragment_function);
  }

  Rgb<double> texture(const Varyings& at) const {
    if (!material.texture) return Rgb<double>(1);
    return sample(*material.texture, material.texture_filter, at.uv, uv_right, uv_down) + texture_moved;
  }

  Fragment<double> fragment(const Varyings& at) const {
    return {at.position, normalize(at.normal), normalize(scene.camera.position - at.position), texture(at)};
  }

  Rgb<double> reflected(const Merl& function, const Fragment<double>& at, const Incident<double>& light) const {
    const double n_l = dot(at.normal, light.direction);
    if (!(n_l > 0 && dot(at.normal, at.to_eye) > -below_horizon)) return Rgb<double>(0);
    MerlPoint<double> point = merl_point(half_difference(function.angles, at.normal, light.direction, at.to_eye));
    point.u = std::max(point.u + moved.u, 0.0), point.v += moved.v, point.w += moved.w;
    return merl_value(*function.table, function.lookup, point).f * n_l * light.radiance;
  }
  template <class SomeFunction>
  Rgb<double> reflected(SomeFunction function, const Fragment<double>& at, const Incident<double>& light) const {
    if constexpr (requires { function.specular_gate; })
      if (below_horizon > 0 && dot(at.normal, light.direction) > -below_horizon)
        function.specular_gate = SpecularGate::open;
    return refraster::reflected(function, at, light); // the formula, not this member
  }

  template <class SomeFunction>
  Rgb<double> colour(const SomeFunction& function, const Varyings& at) const {
    const Fragment<double> here = fragment(at);
    Rgb<double> sum = ambient(function, here);
    for_each_light_list(scene, [&](const auto& lights) {
      for (const auto& light : lights) sum += reflected(function, here, arriving(light, here));
    });
    return sum;
  }
  Rgb<double> colour(const Varyings& at) const {
    return std::visit([&](const auto& function) { return colour(function, at); }, material.fragment_function);
  }
};

/// The fraction of a colour that comes from highlights, and their exponent.
std::pair<Rgb<double>, double> highlights(const IdealShader& shader, const Varyings& at);

/// How far float angles may move the point of the table, in bins.
MerlPoint<double> table_error(const IdealShader& shader, const Varyings& at, double atan_ulp);

} // namespace refraster
