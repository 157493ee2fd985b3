#pragma once
// The short vector across a highlight: r - v of Phong, h - n of Blinn-Phong, not spoilt by rounding r or h first.
//
// cosine_power needs a - b, and is as exact as that. Where a is the result of a formula each of its components is
// rounded by up to u = 2^-53 or so, and in a highlight of width x = sqrt(2 / s) that moves the power by 0.9 u / x of
// its peak: little for a glossiness s of 10, but 500 units in the last place for a million. Computed in one go from
// what was given, each component of a - b has an error of a few u of |a - b|, however short that is.

#include <refraster/material.h>

#include "math/elementary/cosine_power.h"
#include "math/elementary/double_double.h"

namespace refraster::inline REFRASTER_KIT {

/// The numbers that promise so much. Float is content with the error of its inputs, bounds have their own.
template <class T>
concept SharpHighlights = Lanes<T> && sizeof(RealOf<T>) == 8;

/// a.b to twice the precision.
template <Lanes T>
DoubleDouble<T> wide_dot(const Vec3<T>& a, const Vec3<T>& b) {
  const DoubleDouble<T> x = two_product(a.x, b.x), y = two_product(a.y, b.y), z = two_product(a.z, b.z);
  const DoubleDouble<T> x_y = two_sum(x.hi, y.hi), sum = two_sum(x_y.hi, z.hi);
  return fast_two_sum(sum.hi, sum.lo + (x_y.lo + ((x.lo + y.lo) + z.lo)));
}

/// Up to this glossiness P a and b as they are rounded are good enough for 4 units in the last place of the peak, and
/// cheaper.
template <class Function>
inline constexpr double plain_glossiness = 8;
template <>
inline constexpr double plain_glossiness<BlinnPhong> = 64; // h is rounded less than r

/// Up to which |a - b|^2 squared_gap takes it from gap(), in a highlight of glossiness s: where that shows, in a
/// highlight sharper than that of P, and in a sharp one only near its middle.
///
/// At a distance q = |a - b|^2 / 2 an error d of a - b moves the power by s sqrt(2 q) e^(-s q) d. At glossiness P that
/// is sqrt(P / e) d at most, and from s q >= ln(2 s / P) on it is no more at any other: as ln(s q) <= s q - 1,
///     ln(s sqrt(2 q)) - s q = (ln(2 s) + ln(s q)) / 2 - s q <= (ln(2 s) - 1 - s q) / 2 <= ln sqrt(P / e).
/// ln x <= (x - 1) / sqrt(x) spares the logarithm. That is in units of the peak; so that the power keeps its own digits
/// too, for as long as they count beside the diffuse part, the gap is taken to where e^-6 less of the peak is left.
inline double sharp_gap(double s, double plain) {
  if (s <= plain) return 0;
  const double x = 2 * (s / plain);
  return 2 * ((x - 1) / sqrt(x) + 6) / s;
}

/// |a - b|^2, by gap() in the lanes in which it is below `sharp`.
template <Lanes T, class Gap>
T squared_gap(const Vec3<T>& a, const Vec3<T>& b, double sharp, const Gap& gap) {
  const T plain = squared_length(a - b);
  const MaskOf<T> close = plain < as<T>(sharp);
  if (!any(close)) [[likely]]
    return plain;
  return select(close, gap(), plain);
}

// Neither is inlined: what few fragments ask for shall not take registers from what all pay for. So each component is
// given by value too: a vector would be written to memory before it is known whether it is asked for.

/// |r - v|^2 with r = 2 (n.l) n - l.
template <Lanes T>
[[gnu::noinline, gnu::flatten]] T squared_mirror_gap(T n_x, T n_y, T n_z, T l_x, T l_y, T l_z, T v_x, T v_y, T v_z) {
  const DoubleDouble<T> n_l = wide_dot(Vec3<T>(n_x, n_y, n_z), Vec3<T>(l_x, l_y, l_z));
  const T twice = T(2) * n_l.hi, twice_low = T(2) * n_l.lo;
  const auto component = [&](const T& n_i, const T& l_i, const T& v_i) {
    const DoubleDouble<T> normal_part = two_product(twice, n_i), r_i = two_sum(normal_part.hi, -l_i);
    // In a highlight r_i and v_i are close: their difference is exact.
    return (r_i.hi - v_i) + (r_i.lo + (normal_part.lo + twice_low * n_i));
  };
  return squared_length(Vec3<T>(component(n_x, l_x, v_x), component(n_y, l_y, v_y), component(n_z, l_z, v_z)));
}

/// |h - n|^2 with h = (l + v) / |l + v|, that is (l + v - c n) / c with c = |l + v|. Rounding c moves the gap only
/// along n, across the gap, so that its length changes by the square of that; and by the division. h may be rounded.
template <Lanes T>
[[gnu::noinline, gnu::flatten]] T squared_half_gap(T c, T n_x, T n_y, T n_z, T l_x, T l_y, T l_z, T v_x, T v_y, T v_z) {
  const T reciprocal = T(1) / c;
  const auto component = [&](const T& n_i, const T& l_i, const T& v_i) {
    const DoubleDouble<T> sum = two_sum(l_i, v_i), normal_part = two_product(c, n_i);
    return ((sum.hi - normal_part.hi) + (sum.lo - normal_part.lo)) * reciprocal;
  };
  return squared_length(Vec3<T>(component(n_x, l_x, v_x), component(n_y, l_y, v_y), component(n_z, l_z, v_z)));
}

} // namespace refraster::inline REFRASTER_KIT
