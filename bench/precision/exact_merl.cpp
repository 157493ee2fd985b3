#include "bench/precision/exact_shading.h"

namespace refraster::precision {
namespace {

/// Difference quotients: with a relative step of 2^-70 of 200 bits, right to 2^-60 or so.
const Exact& step() {
  static const Exact value(0x1p-70);
  return value;
}

} // namespace

Exact distance_around(const Exact& w, const Exact& other) {
  const Exact away = abs(w - other);
  return min(away, Exact(180) - away);
}

MerlPlace exact_merl_place(const Inputs& in) {
  MerlPlace place{lit<Exact>(in), {}, {Exact(0), Exact(0), Exact(0)}};
  Vec3<Exact> n = place.lit.at.normal, i = place.lit.light.direction, o = place.lit.at.to_eye;
  place.at = exact_merl_point(n, i, o);
  for (Vec3<Exact>* direction : {&n, &i, &o})
    for (int c = 0; c < 3; ++c) {
      Exact& x = (*direction)[c];
      const Exact before = x;
      x = before * (Exact(1) + step());
      const ExactPoint there = exact_merl_point(n, i, o);
      x = before;
      place.moved.u += abs(there.u - place.at.u) / step();
      place.moved.v += abs(there.v - place.at.v) / step();
      place.moved.w += distance_around(there.w, place.at.w) / step();
    }
  return place;
}

Exactly exact_merl(const MerlPlace& place, const MerlTable& table, MerlLookup lookup, int channel) {
  const Vec3<Exact>&n = place.lit.at.normal, &l = place.lit.light.direction;
  const Exact radiance = place.lit.light.radiance.x, n_l = dot(n, l);
  const Exact sizes = magnitude_of_dot(n, l) * radiance;
  if (!(n_l > Exact(0)) || !(dot(n, place.lit.at.to_eye) > Exact(0))) return {Exact(0), sizes};
  const ExactPoint &at = place.at, &moved = place.moved;
  const Exact f = merl_value(table, lookup, at).f[channel];
  if (lookup == MerlLookup::nearest) return {f * n_l * radiance, f * sizes};
  // Of the slopes a few digits are enough: they only say how large a rounding is.
  const auto f_at = [&](double du, double dv, double dw) {
    const MerlPoint<double> moved_by = {static_cast<double>(at.u) + du, static_cast<double>(at.v) + dv,
                                        static_cast<double>(at.w) + dw};
    return merl_value(table, lookup, moved_by).f[channel];
  };
  constexpr double bins = 0x1p-20;
  const double here = f_at(0, 0, 0);
  const auto slope = [&](double there) { return Exact(abs(there - here) / bins); };
  Exact terms = f + slope(f_at(bins, 0, 0)) * (at.u + moved.u) + slope(f_at(0, bins, 0)) * (at.v + moved.v) +
                slope(f_at(0, 0, bins)) * (at.w + moved.w);
  if (lookup == MerlLookup::trilinear_log || lookup == MerlLookup::tricubic_log) {
    const Exact epsilon(MerlTable::log_epsilon), ln_of_two(Exact::Value(log(Exact::Value(2))));
    terms += (f + epsilon) * ln_of_two * log2(Exact(1) + f / epsilon);
  }
  return {f * n_l * radiance, terms * sizes};
}

} // namespace refraster::precision
