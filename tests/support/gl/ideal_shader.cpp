#include "tests/support/gl/ideal_shader.h"

#include <numbers>

namespace refraster {

static constexpr double u = float_rounding;

std::pair<Rgb<double>, double> highlights(const IdealShader& shader, const Varyings& at) {
  return std::visit(
      [&](const auto& function) -> std::pair<Rgb<double>, double> {
        if constexpr (requires { function.ks; }) {
          auto dull = function;
          dull.ks = Double3(0);
          return {shader.colour(function, at) - shader.colour(dull, at), function.glossiness};
        }
        return {Rgb<double>(0), 0};
      },
      shader.material.fragment_function);
}

MerlPoint<double> table_error(const IdealShader& shader, const Varyings& at, double atan_ulp) {
  const Merl* const function = std::get_if<Merl>(&shader.material.fragment_function);
  MerlPoint<double> most{0, 0, 0};
  if (!function) return most;
  const Fragment<double> here = shader.fragment(at);
  const auto widen_for = [&](const Incident<double>& light) {
    const Double3 n = here.normal, i = light.direction, o = here.to_eye;
    const HalfDifference<double> angles = half_difference(function->angles, n, i, o);
    constexpr double bins_per_radian = 180 / std::numbers::pi;
    const double s = length(i + o), d = length(i - o);
    const double theta_h_error = atan_ulp * u * angles.theta_h + 8 * u;
    const double highest = 90 * std::sqrt((angles.theta_h + theta_h_error) * 2 / std::numbers::pi);
    most.u = std::max(most.u,
                      highest - 90 * std::sqrt(std::max(angles.theta_h - theta_h_error, 0.0) * 2 / std::numbers::pi));
    most.v = std::max(most.v, bins_per_radian * (atan_ulp * u * angles.theta_d + 8 * u));
    const double azimuth = length(Double3(s * dot(n, i - o), 2 * dot(n, cross(i, o)), 0));
    const double turn =
        azimuth > 0 ? std::min(16 * u * s * std::max(d, 4 * u) / azimuth, std::numbers::pi / 2) : std::numbers::pi / 2;
    most.w = std::max(most.w, bins_per_radian * (atan_ulp * u * angles.phi_d + 4 * u + turn));
  };
  for_each_light_list(shader.scene, [&](const auto& lights) {
    for (const auto& light : lights) widen_for(arriving(light, here));
  });
  return most;
}

} // namespace refraster
