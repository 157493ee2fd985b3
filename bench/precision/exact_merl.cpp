#include "bench/precision/exact_shading.h"

namespace refraster::precision {

ExactPoint exact_merl_point(const Exact3& given_n, const Exact3& given_i, const Exact3& given_o) {
  const Exact3 n = unit(given_n), i = unit(given_i), o = unit(given_o), h = unit(i + o);
  const Exact& pi = exact_pi();
  const auto angle = [](const Exact& cosine) { return acos(Exact(cosine < 1 ? cosine : Exact(1))); };
  const Exact theta_h = angle(inner(n, h)), theta_d = angle(inner(i, h));
  const Exact3 x = h * inner(n, h) - n, y = outer(h, x); // x is as long as y
  Exact phi = atan2(inner(i, y), inner(i, x));
  if (phi < 0) phi += pi;
  if (phi >= pi) phi -= pi;
  return {90 * sqrt(Exact(theta_h / (pi / 2))), 90 * theta_d / (pi / 2), 180 * phi / pi};
}

Exact distance_around(const Exact& w, const Exact& other) {
  const Exact away = abs(Exact(w - other)), around = 180 - away;
  return away < around ? away : around;
}

MerlPlace exact_merl_place(const Inputs& in) {
  MerlPlace place{exactly_lit(in), {}, {0, 0, 0}};
  Exact3 n = place.lit.n, i = place.lit.l, o = place.lit.v;
  place.at = exact_merl_point(n, i, o);
  // Difference quotients: with a relative step of 2^-70 of 200 bits, right to 2^-60 or so.
  const Exact step = ldexp(Exact(1), -70);
  for (Exact3* direction : {&n, &i, &o})
    for (Exact& x : *direction) {
      const Exact kept = x;
      x = kept * (1 + step);
      const ExactPoint there = exact_merl_point(n, i, o);
      x = kept;
      place.moved.u += abs(Exact(there.u - place.at.u)) / step;
      place.moved.v += abs(Exact(there.v - place.at.v)) / step;
      place.moved.w += distance_around(there.w, place.at.w) / step;
    }
  return place;
}

namespace {

int whole(const Exact& x) {
  return static_cast<int>(floor(x).convert_to<double>());
}
int clamped(int k, int last) {
  return k < 0 ? 0 : k > last ? last : k;
}
int wrapped(int k) {
  return (k % 180 + 180) % 180;
}

/// A table's samples as the lookup weights them. Absent where never measured.
struct Tap {
  Exact value;
  bool measured;
};
Tap tap(const MerlTable& table, bool logarithmic, int channel, int h, int d, int p) {
  const Rgb<double> rgb = table.sample(clamped(h, 89), clamped(d, 89), wrapped(p));
  if (!(rgb.x >= 0 && rgb.y >= 0 && rgb.z >= 0)) return {Exact(0), false};
  const Exact f(rgb[channel]);
  if (!logarithmic) return {f, true};
  return {log2(Exact(1 + f / MerlTable::log_epsilon)), true};
}

/// The samples around a point, read once: `size` along each axis from the given first ones.
struct Block {
  int size = 2, h = 0, d = 0, p = 0;
  std::vector<Tap> taps;
  const Tap& at(int i, int j, int k) const { return taps[static_cast<std::size_t>((i * size + j) * size + k)]; }
};
Block block(const MerlTable& table, bool logarithmic, int channel, int size, int h, int d, int p) {
  Block b{size, h, d, p, {}};
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j)
      for (int k = 0; k < size; ++k) b.taps.push_back(tap(table, logarithmic, channel, h + i, d + j, p + k));
  return b;
}

/// The weights of the samples at 0, 1 (of two), or at -1, 0, 1, 2 (of four) for a point at x in [0, 1]: a straight
/// line, or the Catmull-Rom spline as its textbook matrix.
std::vector<Exact> weights(int size, const Exact& x) {
  if (size == 2) return {Exact(1 - x), x};
  const Exact x2 = x * x, x3 = x2 * x;
  return {Exact((-x3 + 2 * x2 - x) / 2), Exact((3 * x3 - 5 * x2 + 2) / 2), Exact((-3 * x3 + 4 * x2 + x) / 2),
          Exact((x3 - x2) / 2)};
}

/// The mean of what was measured at (u, v, w), counted in samples.
Exact mean(const Block& b, const Exact& u, const Exact& v, const Exact& w) {
  const int before = b.size / 2 - 1;
  const auto a = weights(b.size, u - (b.h + before)), c = weights(b.size, v - (b.d + before)),
             e = weights(b.size, w - (b.p + before));
  Exact sum = 0, share = 0;
  for (int i = 0; i < b.size; ++i)
    for (int j = 0; j < b.size; ++j)
      for (int k = 0; k < b.size; ++k) {
        if (!b.at(i, j, k).measured) continue;
        const Exact weight =
            a[static_cast<std::size_t>(i)] * c[static_cast<std::size_t>(j)] * e[static_cast<std::size_t>(k)];
        sum += weight * b.at(i, j, k).value;
        share += weight;
      }
  return share == 0 ? Exact(0) : Exact(sum / share);
}

bool complete(const Block& b) {
  return std::all_of(b.taps.begin(), b.taps.end(), [](const Tap& one) { return one.measured; });
}

} // namespace

Exactly exact_merl(const MerlPlace& place, const MerlTable& table, MerlLookup lookup, int channel) {
  const ExactLit& lit = place.lit;
  const ExactPoint &at = place.at, &moved = place.moved;
  const Exact n_l = inner(lit.n, lit.l);
  if (n_l <= 0 || inner(lit.n, lit.v) <= 0) return {0, inner_magnitude(lit.n, lit.l) * lit.radiance};
  const auto radiance = [&](const Exact& f, const Exact& terms) -> Exactly {
    return {f * n_l * lit.radiance, terms * inner_magnitude(lit.n, lit.l) * lit.radiance};
  };
  if (lookup == MerlLookup::nearest) {
    const Exact f = tap(table, false, channel, whole(at.u), whole(at.v), whole(at.w)).value;
    return radiance(f, f);
  }
  const bool logarithmic = lookup == MerlLookup::trilinear_log || lookup == MerlLookup::tricubic_log;
  const Exact first = lookup == MerlLookup::trilinear_edge ? 0 : 0.5;
  const Exact u = at.u - first, v = at.v - first, w = at.w - first;
  Block around = block(table, logarithmic, channel, 2, whole(u), whole(v), whole(w));
  if (lookup == MerlLookup::tricubic_log) {
    Block wider = block(table, logarithmic, channel, 4, whole(u) - 1, whole(v) - 1, whole(w) - 1);
    if (complete(wider)) around = wider;
  }
  const auto of_logarithm = [](const Exact& g) { return Exact(MerlTable::log_epsilon * (pow(Exact(2), g) - 1)); };
  const Exact step = ldexp(Exact(1), -70);
  const Exact here = mean(around, u, v, w);
  const Exact value = logarithmic ? positive_part(of_logarithm(here)) : here;
  const auto slope = [&](const Exact& there) { return Exact(abs(Exact(there - here)) / step); };
  // What is interpolated, and a change of it by its own terms.
  const Exact terms = abs(here) + slope(mean(around, u + step, v, w)) * (at.u + moved.u) +
                      slope(mean(around, u, v + step, w)) * (at.v + moved.v) +
                      slope(mean(around, u, v, w + step)) * (at.w + moved.w);
  if (!logarithmic) return radiance(value, terms);
  const Exact per_g = (of_logarithm(here) + MerlTable::log_epsilon) * log(Exact(2));
  return radiance(value, value + per_g * terms);
}

} // namespace refraster::precision
