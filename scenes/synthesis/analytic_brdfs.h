#pragma once
// BRDFs with a formula, as a truth to compare tables with and as a source of tables that anyone may have.
// Each is f(n, i, o) in 1/sr, without cosine, for unit vectors with n.i > 0 and n.o > 0; isotropic, reciprocal to
// the last bit, and reflecting no more than arrives.

#include <refraster/fields.h>

#include "shading/microfacet/fresnel.h"
#include "shading/microfacet/ggx.h"

#include <numbers>
#include <string_view>

namespace refraster {

/// The same in all directions: albedo / pi.
struct Lambert {
  static constexpr std::string_view name = "lambert";
  static constexpr std::string_view meaning = "the same in all directions";

  Double3 albedo{0.5}; // fraction of the light that is reflected, each channel in [0, 1]

  /// Declares the parameters: <refraster/fields.h>.
  static void fields(auto& self, auto&& field) {
    field("albedo", self.albedo, Range{0, 1}, "fraction of the light that is reflected");
  }

  template <Number T>
  Rgb<T> operator()(const Vec3<T>&, const Vec3<T>&, const Vec3<T>&) const {
    return as<T>(albedo / std::numbers::pi);
  }
};

/// D(h), of unit vectors. The sine comes from the cross product: 1 - cos^2 would leave few digits of it where D is
/// largest.
template <Number T>
T ggx_density(const Vec3<T>& n, const Vec3<T>& h, double alpha) {
  const GgxWidth<T> width = ggx_width<T>(alpha);
  return ggx_density(ggx_spread(square(dot(n, h)), squared_length(cross(n, h)), width), width);
}

/// Masking and shadowing over 4 (n.i) (n.o).
template <Number T>
T ggx_visibility(const T& n_i, const T& n_o, double alpha) {
  return as<T>(0.5) / smith_divisor(n_i, n_o, ggx_width<T>(alpha));
}

/// i.h = o.h = |i + o| / 2: written so, exchanging i and o changes no bit.
template <Number T>
T cosine_to_half(const Vec3<T>& i, const Vec3<T>& o) {
  return as<T>(0.5) * sqrt(squared_length(i + o));
}

/// Below 0.0001 a highlight fills less than half of the first bin of theta_h, 1.9e-4 rad: a table shows one sample of
/// it.
inline constexpr Range ggx_alpha_range{0.0001, 1};

/// Rough metal: D G F / (4 n.i n.o), F = f0 + (1 - f0) (1 - i.h)^5, Schlick's.
struct GgxConductor {
  static constexpr std::string_view name = "ggx-conductor";
  static constexpr std::string_view meaning = "rough metal";

  double alpha = 0.1; // width of the density, in (0, 1]: the slope at which it has fallen to a quarter
  Double3 f0{0.9};    // reflectance at normal incidence, each channel in [0, 1]

  /// Declares the parameters: <refraster/fields.h>.
  static void fields(auto& self, auto&& field) {
    field("alpha", self.alpha, ggx_alpha_range, "roughness: slope at which the density has fallen to a quarter");
    field("f0", self.f0, Range{0, 1}, "reflectance at normal incidence");
  }

  template <Number T>
  Rgb<T> operator()(const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) const {
    const Vec3<T> h = normalize(i + o);
    const T away = max0(T(1) - cosine_to_half(i, o));
    const T away_5 = square(square(away)) * away;
    const Rgb<T> fresnel = as<T>(f0) + as<T>(Double3(1) - f0) * away_5;
    return fresnel * (ggx_density(n, h, alpha) * ggx_visibility(dot(n, i), dot(n, o), alpha));
  }
};

/// At cosine c of the angle of incidence; ior > 1.
template <Number T>
T dielectric_fresnel(const T& c, double ior) {
  return dielectric_reflectance(c, as<T>(ior * ior - 1));
}

/// Rough dielectric over a diffuse ground: D G F / (4 n.i n.o) + (1 - F(n.i)) (1 - F(n.o)) albedo / pi. Light that
/// enters meets the ground once; what the surface throws back inside is lost.
struct GgxDielectric {
  static constexpr std::string_view name = "ggx-dielectric";
  static constexpr std::string_view meaning = "rough dielectric over a diffuse ground";

  double alpha = 0.3;  // as for GgxConductor
  double ior = 1.5;    // refractive index, > 1
  Double3 albedo{0.5}; // of the ground, each channel in [0, 1]

  /// Declares the parameters: <refraster/fields.h>.
  static void fields(auto& self, auto&& field) {
    field("alpha", self.alpha, ggx_alpha_range, "roughness: slope at which the density has fallen to a quarter");
    field("ior", self.ior, Range{1.0001, 10}, "refractive index");
    field("albedo", self.albedo, Range{0, 1}, "of the ground: fraction of the light that is reflected");
  }

  template <Number T>
  Rgb<T> operator()(const Vec3<T>& n, const Vec3<T>& i, const Vec3<T>& o) const {
    const Vec3<T> h = normalize(i + o);
    const T n_i = dot(n, i), n_o = dot(n, o);
    const T gloss =
        dielectric_fresnel(cosine_to_half(i, o), ior) * ggx_density(n, h, alpha) * ggx_visibility(n_i, n_o, alpha);
    const T entering = T(1) - dielectric_fresnel(n_i, ior), leaving = T(1) - dielectric_fresnel(n_o, ior);
    return as<T>(albedo / std::numbers::pi) * (entering * leaving) + Rgb<T>(gloss);
  }
};

} // namespace refraster
