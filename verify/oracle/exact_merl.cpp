#include "verify/oracle/exact_merl.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace refraster::oracle {
namespace {

MerlPoint<Exact> point(const Exact3& n, const Exact3& i, const Exact3& o) {
  const Exact3 h = unit(i + o);
  const auto angle = [](const Exact& cosine) { return acos(std::min(cosine, Exact(1))); };
  const Exact theta_h = angle(dot(n, h)), theta_d = angle(dot(i, h));
  const Exact3 x = h * dot(n, h) - n, y = cross(h, x); // as long as x
  const Exact along = dot(i, x), across = dot(i, y);
  Exact phi = along == 0 && across == 0 ? pi() / 2 : atan2(across, along);
  if (phi < 0) phi += pi();
  if (phi >= pi()) phi -= pi();
  return {90 * sqrt(theta_h / (pi() / 2)), 90 * theta_d / (pi() / 2), 180 * phi / pi()};
}

/// A sample, or nothing where none was measured. phi_d repeats, the others stay within the table.
std::optional<Exact3> sample(const MerlTable& table, bool logarithmic, long h, long d, long p) {
  const auto within = [](long k, int bins) { return static_cast<int>(std::clamp(k, 0L, bins - 1L)); };
  const Rgb<double> rgb =
      table.sample(within(h, MerlTable::theta_h_bins), within(d, MerlTable::theta_d_bins),
                   static_cast<int>((p % MerlTable::phi_d_bins + MerlTable::phi_d_bins) % MerlTable::phi_d_bins));
  if (!(rgb.x >= 0 && rgb.y >= 0 && rgb.z >= 0)) return std::nullopt;
  Exact3 f = exact(rgb);
  if (logarithmic)
    for (Exact* const channel : {&f.x, &f.y, &f.z}) *channel = log2(1 + *channel / MerlTable::log_epsilon);
  return f;
}

/// The samples of one axis around a point and their weights: two on a straight line, or four on a Catmull-Rom spline.
struct Axis {
  long first;
  std::vector<Exact> weights;
};
Axis axis(int taps, const Exact& x) {
  const long cell = whole(x);
  const Exact t = x - cell;
  if (taps == 2) return {cell, {1 - t, t}};
  const Exact t2 = t * t, t3 = t2 * t;
  return {cell - 1, {(-t3 + 2 * t2 - t) / 2, (3 * t3 - 5 * t2 + 2) / 2, (-3 * t3 + 4 * t2 + t) / 2, (t3 - t2) / 2}};
}

enum class Gaps { left_out, not_allowed };

/// The weighted mean of what was measured; 0 where nothing was. With gaps not allowed, nothing if there is one.
std::optional<Exact3> mean(const MerlTable& table, bool logarithmic, int taps, const MerlPoint<Exact>& at,
                           const Exact& first, Gaps gaps) {
  const Axis u = axis(taps, at.u - first), v = axis(taps, at.v - first), w = axis(taps, at.w - first);
  Exact3 sum{0, 0, 0};
  Exact weights = 0;
  for (int i = 0; i < taps; ++i)
    for (int j = 0; j < taps; ++j)
      for (int k = 0; k < taps; ++k) {
        const auto f = sample(table, logarithmic, u.first + i, v.first + j, w.first + k);
        if (!f && gaps == Gaps::not_allowed) return std::nullopt;
        if (!f) continue;
        const Exact weight = u.weights[static_cast<std::size_t>(i)] * v.weights[static_cast<std::size_t>(j)] *
                             w.weights[static_cast<std::size_t>(k)];
        sum = sum + *f * weight;
        weights += weight;
      }
  return weights == 0 ? Exact3{0, 0, 0} : sum * (1 / weights);
}

Exact3 from_logarithm(Exact3 g) {
  for (Exact* const channel : {&g.x, &g.y, &g.z}) *channel = MerlTable::log_epsilon * positive(exp2(*channel) - 1);
  return g;
}

} // namespace

Exact3 merl_brdf(const MerlTable& table, MerlLookup lookup, const Exact3& n, const Exact3& i, const Exact3& o) {
  const MerlPoint<Exact> at = point(n, i, o);
  const Exact centre(0.5);
  switch (lookup) {
  case MerlLookup::nearest:
    return sample(table, false, whole(at.u), whole(at.v), whole(at.w)).value_or(Exact3{0, 0, 0});
  case MerlLookup::trilinear:
    return *mean(table, false, 2, at, centre, Gaps::left_out);
  case MerlLookup::trilinear_edge:
    return *mean(table, false, 2, at, 0, Gaps::left_out);
  case MerlLookup::trilinear_log:
    return from_logarithm(*mean(table, true, 2, at, centre, Gaps::left_out));
  case MerlLookup::tricubic_log:
    if (const auto smooth = mean(table, true, 4, at, centre, Gaps::not_allowed)) return from_logarithm(*smooth);
    return from_logarithm(*mean(table, true, 2, at, centre, Gaps::left_out));
  }
  return {0, 0, 0};
}

} // namespace refraster::oracle
