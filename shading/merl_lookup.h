#pragma once
// Reading a MERL table between its samples.

#include <refraster/material.h>

#include "math/elementary.h"
#include "math/half.h"
#include "math/read_grid.h"
#include "shading/half_difference.h"

#include <array>

namespace refraster::inline REFRASTER_KIT {

/// A point in the table, in bins: bin k covers [k, k + 1). The table has its finest bins where theta_h is small.
template <class T>
struct MerlPoint {
  T u, v, w;
};

/// u = 90 sqrt(theta_h / (pi/2)), v = 90 theta_d / (pi/2), w = 180 phi_d / pi.
template <Number T>
MerlPoint<T> merl_point(const HalfDifference<T>& angles) {
  const T bins_per_radian = constant<T>(constants::degrees_per_radian); // of theta_d and phi_d: a bin is one degree
  return {T(90) * sqrt(angles.theta_h * constant<T>(constants::two_over_pi)), angles.theta_d * bins_per_radian,
          angles.phi_d * bins_per_radian};
}

/// What was read. Where no sample around the point was ever measured, f is 0.
template <class T>
struct MerlValue {
  Rgb<T> f; // 1/sr
  MaskOf<T> unmeasured;

  /// What may be either, of a bounds number.
  friend MerlValue join(const MerlValue& a, const MerlValue& b) requires(!NumberTraits<T>::decides) {
    return {join(a.f, b.f), join(a.unmeasured, b.unmeasured)};
  }
  /// Of a bounds number, what is read at a place that is hardly known (read_walk).
  friend MerlValue anything_like(const MerlValue& value) requires(!NumberTraits<T>::decides) {
    return {anything_like(value.f), MaskOf<T>::unknown};
  }
};

/// The axes of the table: the border samples of theta_h and theta_d continue to infinity, phi_d goes round.
inline constexpr std::array<GridAxis, 3> merl_axes = {{{GridAxis::Beyond::clamped, MerlTable::theta_h_bins},
                                                       {GridAxis::Beyond::clamped, MerlTable::theta_d_bins},
                                                       {GridAxis::Beyond::repeated, MerlTable::phi_d_bins}}};

/// The `count` samples of one axis that a point lies among, and how far the point is from the first of the middle two
/// to the second, in [0, 1).
template <class T, int count>
struct Taps {
  std::array<IndexOf<T>, count> index;
  T fraction;
};

/// From the cell of the first of them. Beyond the ends the border samples continue, or the axis goes round.
template <int count, Number T>
Taps<T, count> taps_of(const Cell<T>& at, const GridAxis& axis) {
  Taps<T, count> taps{{}, at.fraction};
  IndexOf<T> k = at.index;
  for (IndexOf<T>& tap : taps.index) {
    tap = axis.beyond == GridAxis::Beyond::repeated ? wrap_index(k, axis.count) : clamp_index(k, 0, axis.count - 1);
    k = next_index(k);
  }
  return taps;
}

/// The weighted mean of what was measured: `sum` as MerlReader adds it up.
template <Number T>
MerlValue<T> merl_mean(const Vec4<T>& sum) {
  const MaskOf<T> unmeasured = sum.w <= T(0);
  const T scale = T(1) / select(unmeasured, T(1), sum.w);
  return {Rgb<T>(sum.x * scale, sum.y * scale, sum.z * scale), unmeasured};
}

/// What is interpolated: f, or g = log2(1 + f / epsilon).
enum class MerlScale { values, logarithms };

/// Reads the samples of one table. Where `scale` is logarithms and T is no IEEE number, `values` hold f, and its
/// logarithm is taken in T: the table of logarithms is rounded.
template <Number T, class Stored = RealOf<T>>
struct MerlReader {
  using Index = IndexOf<T>;
  using Cells = std::array<Cell<T>, 3>;
  const Stored* values;
  MerlScale scale = MerlScale::values;

  Rgb<T> rgb(const Index& h, const Index& d, const Index& p) const {
    const RgbGrid<RealOf<T>, Stored> grid{values, MerlTable::offset(1, 0, 0), MerlTable::offset(0, 1, 0),
                                          MerlTable::offset(0, 0, 1)};
    const Rgb<T> stored = stored_value<T>(grid, h, d, p);
    if constexpr (NumberTraits<T>::is_ieee) return stored;
    else {
      if (scale == MerlScale::values) return stored;
      const auto g = [](const T& f) { // negative where f is, which was never measured
        return select(f < T(0), f, log2(T(1) + max0(f) / as<T>(MerlTable::log_epsilon)));
      };
      return {g(stored.x), g(stored.y), g(stored.z)};
    }
  }

  /// Where nothing was measured, 0.
  MerlValue<T> sample(const Index& h, const Index& d, const Index& p) const {
    const Rgb<T> value = rgb(h, d, p);
    const MaskOf<T> measured = min(value.x, min(value.y, value.z)) >= T(0);
    return {select<T>(measured, value, Rgb<T>(T(0))), !measured};
  }

  /// (r, g, b, 1), or 0 where nothing was measured: a sum with any weights is then the weighted sum of what was
  /// measured, and beside it the sum of the weights.
  Vec4<T> weighted(const Index& h, const Index& d, const Index& p) const {
    const auto [f, unmeasured] = sample(h, d, p);
    return {f.x, f.y, f.z, select(unmeasured, T(0), T(1))};
  }

  MerlValue<T> nearest(const MerlPoint<T>& at) const {
    return read_nearest(std::array{at.u, at.v, at.w}, merl_axes, [&](const Cells& cell) {
      return sample(clamp_index(cell[0].index, 0, MerlTable::theta_h_bins - 1),
                    clamp_index(cell[1].index, 0, MerlTable::theta_d_bins - 1), last_or_first(cell[2].index));
    });
  }

  /// `first` is the coordinate of sample 0 on each axis: 0.5 where samples are at the centres of their bins, else 0.
  MerlValue<T> trilinear(const MerlPoint<T>& at, double first) const {
    const std::array<T, 3> place = {at.u - as<T>(first), at.v - as<T>(first), at.w - as<T>(first)};
    return read_grid(place, merl_axes, [&](const Cells& cell) { return trilinear(cell); });
  }

  MerlValue<T> trilinear(const Cells& cell) const {
    const Cube cube{taps_of<2>(cell[0], merl_axes[0]), taps_of<2>(cell[1], merl_axes[1]),
                    taps_of<2>(cell[2], merl_axes[2])};
    if constexpr (NumberTraits<T>::has_lanes) {
      // Nearly always all was measured. The weights add up to exactly 1 then, and need not be computed.
      T least(0);
      const Rgb<T> mean = cube.mixed([&](const Index& h, const Index& d, const Index& p) {
        const Rgb<T> value = rgb(h, d, p);
        least = min(min(least, value.x), min(value.y, value.z));
        return value;
      });
      if (!any(least < T(0))) [[likely]]
        return {mean, T(0) < T(0)};
    }
    return mean_of_measured(cube);
  }

  /// Samples at the centres of their bins. Where one of the 64 was never measured, trilinear: the weights of a spline
  /// are partly negative, so that scaling them up to a sum of 1 could turn a bright neighbour into anything.
  MerlValue<T> tricubic(const MerlPoint<T>& at) const {
    const std::array<T, 3> place = {at.u - as<T>(0.5) - T(1), at.v - as<T>(0.5) - T(1), at.w - as<T>(0.5) - T(1)};
    return read_grid(place, merl_axes, read_of_many<64>([&](const Cells& cell) { return tricubic(at, cell); }));
  }

  MerlValue<T> tricubic(const MerlPoint<T>& at, const Cells& cell) const {
    const auto h = taps_of<4>(cell[0], merl_axes[0]);
    const auto d = taps_of<4>(cell[1], merl_axes[1]);
    const auto p = taps_of<4>(cell[2], merl_axes[2]);
    T measured(1);
    std::array<Vec4<T>, 4> along_h;
    for (std::size_t i = 0; i < 4; ++i) {
      std::array<Vec4<T>, 4> along_d;
      for (std::size_t j = 0; j < 4; ++j) {
        std::array<Vec4<T>, 4> tap;
        for (std::size_t k = 0; k < 4; ++k) {
          tap[k] = weighted(h.index[i], d.index[j], p.index[k]);
          measured = min(measured, tap[k].w);
        }
        along_d[j] = mix_cubic(tap[0], tap[1], tap[2], tap[3], p.fraction);
      }
      along_h[i] = mix_cubic(along_d[0], along_d[1], along_d[2], along_d[3], d.fraction);
    }
    const Vec4<T> sum = mix_cubic(along_h[0], along_h[1], along_h[2], along_h[3], h.fraction);
    const Rgb<T> smooth(sum.x, sum.y, sum.z);
    const MaskOf<T> incomplete = measured < T(1);
    if (!any(incomplete)) return {smooth, incomplete};
    // A number that does not decide is in this cell, not in all.
    const auto plain_value = [&] {
      if constexpr (NumberTraits<T>::decides) return trilinear(at, 0.5);
      else return trilinear(Cells{second_of(cell[0]), second_of(cell[1]), second_of(cell[2])});
    };
    const MerlValue<T> plain = plain_value();
    return {select<T>(incomplete, plain.f, smooth), static_cast<MaskOf<T>>(incomplete & plain.unmeasured)};
  }

private:
  /// phi_d is in [0, pi) and may round to the end of its last bin; bounds have it in one piece around the seam.
  static Index last_or_first(const Index& bin) {
    if constexpr (NumberTraits<T>::decides) return clamp_index(bin, 0, MerlTable::phi_d_bins - 1);
    else return wrap_index(bin, MerlTable::phi_d_bins);
  }

  /// Of four samples the middle two.
  static Cell<T> second_of(const Cell<T>& first) { return {next_index(first.index), first.fraction}; }

  /// The eight samples around a point.
  struct Cube {
    Taps<T, 2> h, d, p;

    template <class Read>
    auto mixed(const Read& read) const {
      const auto along_p = [&](std::size_t i, std::size_t j) {
        return mix(read(h.index[i], d.index[j], p.index[0]), read(h.index[i], d.index[j], p.index[1]), p.fraction);
      };
      return mix(mix(along_p(0, 0), along_p(0, 1), d.fraction), mix(along_p(1, 0), along_p(1, 1), d.fraction),
                 h.fraction);
    }
  };

  // Not inlined: few points ask for it.
  [[gnu::noinline]] MerlValue<T> mean_of_measured(const Cube& cube) const {
    return merl_mean(cube.mixed([&](const Index& h, const Index& d, const Index& p) { return weighted(h, d, p); }));
  }
};

/// f = epsilon (2^g - 1). A spline may dip below 0; f does not.
template <Number T>
MerlValue<T> from_logarithm(const MerlValue<T>& g) {
  const auto f = [](const T& x) { return as<T>(MerlTable::log_epsilon) * max0(exp2(x) - T(1)); };
  return {Rgb<T>(f(g.f.x), f(g.f.y), f(g.f.z)), g.unmeasured};
}

/// The same f in 1/sr, from units of the table's.
template <class Stored, Number T>
MerlValue<T> from_units(const MerlTable& table, const MerlValue<T>& in_units) {
  if constexpr (std::is_same_v<Stored, RealOf<T>>) return in_units;
  else return {in_units.f * as<T>(table.unit<Stored>()), in_units.unmeasured};
}

/// The BRDF at a point of the table, which is read in the format of `Stored`: that of the precision, if nothing else is
/// said. Reads only the copy of the table that this and the lookup need. Logarithms are always stored in T's own
/// precision.
template <Number T, class Stored = TableRealOf<T>>
MerlValue<T> merl_value(const MerlTable& table, MerlLookup lookup, const MerlPoint<T>& at) {
  using F = RealOf<T>;
  const auto values = [&] { return MerlReader<T, Stored>{table.values<Stored>()}; };
  const auto logarithms = [&] {
    if constexpr (NumberTraits<T>::is_ieee) return MerlReader<T>{table.log_values<F>(), MerlScale::logarithms};
    else return MerlReader<T>{table.values<F>(), MerlScale::logarithms};
  };
  switch (lookup) {
  case MerlLookup::nearest:
    return from_units<Stored>(table, values().nearest(at));
  case MerlLookup::trilinear:
    return from_units<Stored>(table, values().trilinear(at, 0.5));
  case MerlLookup::trilinear_edge:
    return from_units<Stored>(table, values().trilinear(at, 0));
  case MerlLookup::trilinear_log:
    return from_logarithm(logarithms().trilinear(at, 0.5));
  case MerlLookup::tricubic_log:
    return from_logarithm(logarithms().tricubic(at));
  }
  return {Rgb<T>(T(0)), T(0) <= T(0)};
}

} // namespace refraster::inline REFRASTER_KIT
