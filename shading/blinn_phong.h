#pragma once

#include "shading/phong.h"

namespace refraster {

/// Blinn-Phong reflection: radiance toward the eye from one light,
///
///     (kd t <n.l> + ks <n.h>^s) C,     h = (l + v) / |l + v|,     <x> = max(x, 0).
///
/// Blinn, "Models of light reflection for computer synthesized pictures", 1977.
struct BlinnPhong : PhongParameters {
  static constexpr std::string_view name = "blinn_phong";
  static constexpr std::string_view shader_stems[] = {"blinn_phong_fs", "blinn_fs", "blinn_phong", "blinn"};

  template <Number T>
  Rgb<T> operator()(const Fragment<T>& at, const Incident<T>& light) const {
    const Vec3<T> n = at.normal, l = light.direction, v = at.to_eye;
    const Vec3<T> h = normalize(l + v);
    at.undefined(Undefined::no_half_vector, squared_length(l + v) <= T(0)); // h = 0 there
    return reflected(at, light, dot(n, l), lobe(at, n, h, HalfGap<T>{n, l, v, h}));
  }
};

} // namespace refraster
