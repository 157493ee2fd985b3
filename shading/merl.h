#pragma once

#include "shading/fragment.h"
#include "shading/merl_lookup.h"

#include <cassert>
#include <memory>
#include <string_view>

namespace refraster {

/// Measured reflection: radiance toward the eye from one light,
///
///     f(l, v) <n.l> C,     0 unless n.l > 0 and n.v > 0,     <x> = max(x, 0).
///
/// f is read from a MERL table. There is no ambient term, and the texture is not used.
struct Merl {
  static constexpr std::string_view name = "merl";
  static constexpr std::string_view shader_stems[] = {"merl_fs", "merl"};

  std::shared_ptr<const MerlTable> table; // not null when shading
  MerlLookup lookup = MerlLookup::trilinear;
  MerlAngles angles = MerlAngles::closed;

  static void fields(auto& self, auto&& field) {
    field("merl_lookup", self.lookup, Range{}, "how the table is read between its samples");
    field("merl_angles", self.angles, Range{}, "how the half and difference angles are computed");
  }

  template <Number T>
  Rgb<T> ambient(const Fragment<T>&) const {
    return Rgb<T>(T(0));
  }

  template <Number T>
  Rgb<T> operator()(const Fragment<T>& at, const Incident<T>& light) const {
    assert(table);
    const Vec3<T> n = at.normal, l = light.direction, v = at.to_eye;
    const T n_l = dot(n, l);
    const MerlValue<T> brdf = merl_value(*table, lookup, merl_point(half_difference(angles, n, l, v)));
    const MaskOf<T> lit = min(n_l, dot(n, v)) > T(0);
    at.undefined(Undefined::unmeasured_brdf, lit & brdf.unmeasured);
    return select<T>(lit, brdf.f * n_l * light.radiance, Rgb<T>(T(0)));
  }
};

} // namespace refraster
