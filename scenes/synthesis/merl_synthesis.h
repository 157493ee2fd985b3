#pragma once
// Tables made from formulas: the measured files are large and not free to pass on.

#include <refraster/material.h>

#include "math/elementary/degrees.h"
#include "scenes/synthesis/analytic_brdfs.h"

#include <concepts>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace refraster {

/// Two directions above or below a surface with normal (0, 0, 1). Unit vectors.
struct DirectionPair {
  Double3 i, o;
};

/// The pair that has these half and difference angles; h lies in the x-z plane. With b(x) = (sin x, 0, cos x) and d the
/// direction (theta_d, phi_d) from the pole,
///     h = b(theta_h),  i = d turned from the pole to h about the y axis,  o = i mirrored about h.
/// before_middle: of pi/2 - phi_d, so that exchanging i and o, which mirrors phi_d about pi/2, changes the sign of its
/// sine and nothing else.
DirectionPair directions_of(const SineCosine& theta_h, const SineCosine& theta_d, const SineCosine& before_middle);

/// The pair whose half and difference angles are those of the centre of a bin.
/// Bins p and 179 - p exchange i and o (and mirror them in y), to the last bit of i.z and o.z.
/// Computed without the C library's sine, so that a table has the same bits on every machine.
DirectionPair directions_at_centre(int h, int d, int p);

/// The measured tables do not end at the horizon: samples whose centre lies up to this far below it have values, so
/// that every pair above it is read from measured samples only, by any lookup. (1,152,174 of theirs do; of ours,
/// 1,152,200.)
inline constexpr double rim_sine = 0.06105; // of 3.5 degrees

/// A direction from the rim, raised to a small height above the horizon; one that stands higher is unchanged.
/// A formula that ends at the horizon is so continued below it by its value there.
Double3 raised_above_horizon(const Double3& direction);

/// The table of brdf(n, i, o) -> Rgb<double>, in 1/sr, at the centres of all bins. A bin with i or o below the rim is
/// marked as never measured (-1).
template <class Brdf>
  requires std::invocable<Brdf&, Double3, Double3, Double3> MerlTable merl_table_from(Brdf&& brdf) {
    PaddedVector<double> rgb(3 * MerlTable::samples, -1.0);
    for (int h = 0; h < MerlTable::theta_h_bins; ++h)
      for (int d = 0; d < MerlTable::theta_d_bins; ++d)
        for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
          const auto [i, o] = directions_at_centre(h, d, p);
          if (i.z < -rim_sine || o.z < -rim_sine) continue;
          const Rgb<double> f = brdf(Double3(0, 0, 1), raised_above_horizon(i), raised_above_horizon(o));
          double* const at = rgb.data() + MerlTable::offset(h, d, p);
          at[0] = f.x, at[1] = f.y, at[2] = f.z;
        }
    return MerlTable(std::move(rgb));
  }

using AnalyticBrdf = std::variant<Lambert, GgxConductor, GgxDielectric>;

inline MerlTable merl_table_from(const AnalyticBrdf& brdf) {
  return std::visit([](const auto& formula) { return merl_table_from(formula); }, brdf);
}

/// A formula with parameters that look somewhat like a material. Nothing here is measured.
struct BrdfPreset {
  std::string_view name, meaning;
  AnalyticBrdf brdf;
};

std::span<const BrdfPreset> brdf_presets();

/// Null if there is none of that name.
const BrdfPreset* find_brdf_preset(std::string_view name);

} // namespace refraster
