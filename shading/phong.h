#pragma once

#include "math/elementary.h"
#include "shading/fields.h"
#include "shading/fragment.h"
#include "shading/highlight_gap.h"

#include <utility>

namespace refraster {

/// Whether a light at or below the horizon (n.l <= 0) still makes a highlight. The textbook formula keeps it.
enum class SpecularGate { open, cut_below_horizon };

template <>
struct EnumNames<SpecularGate> {
  static constexpr std::pair<SpecularGate, std::string_view> names[] = {
      {SpecularGate::open, "false"},
      {SpecularGate::cut_below_horizon, "true"},
  };
};

/// What Phong and Blinn-Phong share: the parameters, and the ambient term.
struct PhongParameters {
  Double3 ka{0.05}, kd{1}, ks{1};
  double glossiness = 8;
  SpecularGate specular_gate = SpecularGate::open;

  static void fields(auto& self, auto&& field) {
    field("ka", self.ka, Range{}, "ambient reflection, r g b");
    field("kd", self.kd, Range{}, "diffuse reflection, r g b");
    field("ks", self.ks, Range{}, "specular reflection, r g b");
    field("glossiness", self.glossiness, Range{}, "exponent of the highlight");
    field("specular_gate", self.specular_gate, Range{}, "true: no highlight from a light at or below the horizon");
  }

  /// There is no ambient light in a scene: the surface's own ka times its colour stands for it.
  template <Number T>
  Rgb<T> ambient(const Fragment<T>& at) const {
    return as<T>(ka) * at.texture;
  }

  /// <a.b>^s. 0^0 is 1: an exponent of 0 makes a highlight that is everywhere. gap() is a - b, more exactly than from a
  /// and b as they are rounded; asked for where that shows.
  template <Number T, class Gap>
  T lobe(const Fragment<T>& at, const Vec3<T>& a, const Vec3<T>& b, const Gap& gap) const {
    if (ks.x == 0 && ks.y == 0 && ks.z == 0) return T(0); // not used, so not paid for
    if (glossiness == 0) at.undefined(Undefined::zero_to_the_zero, dot(a, b) <= T(0));
    if constexpr (SharpHighlights<T>) return cosine_power(a, b, highlight_gap(a, b, glossiness, gap), glossiness);
    else return cosine_power(a, b, glossiness);
  }

  /// (kd t <n.l> + ks highlight) C, <x> = max(x, 0), t the texture colour: the highlight is not coloured by it.
  /// 0 without a normal.
  template <Number T>
  Rgb<T> reflected(const Fragment<T>& at, const Incident<T>& light, const T& n_l, const T& highlight) const {
    const T gated = specular_gate == SpecularGate::open ? highlight : select(n_l > T(0), highlight, T(0));
    const T kept = select(squared_length(at.normal) > T(0), gated, T(0));
    return (as<T>(kd) * at.texture * max0(n_l) + as<T>(ks) * kept) * light.radiance;
  }
};

/// Phong reflection: radiance toward the eye from one light,
///
///     (kd t <n.l> + ks <r.v>^s) C,     r = 2 (n.l) n - l,     <x> = max(x, 0).
///
/// Phong, "Illumination for computer generated pictures", 1975.
struct Phong : PhongParameters {
  static constexpr std::string_view name = "phong";
  static constexpr std::string_view shader_stems[] = {"phong_fs", "phong"};

  template <Number T>
  Rgb<T> operator()(const Fragment<T>& at, const Incident<T>& light) const {
    const Vec3<T> n = at.normal, l = light.direction, v = at.to_eye;
    const T n_l = dot(n, l);
    const Vec3<T> r = n * (T(2) * n_l) - l;
    return reflected(at, light, n_l, lobe(at, r, v, MirrorGap<T>{n, l, v}));
  }
};

} // namespace refraster
