#include "verify/hypotheses/measured.h"

#include "shading/merl.h"

#include <algorithm>
#include <cmath>

namespace refraster::hypotheses {
namespace {

constexpr double two_over_pi = constants::two_over_pi.nearest;

MerlLookup lookup_of(const Merl& merl, TableLookup lookup) {
  switch (lookup) {
  case TableLookup::right:
    return merl.lookup;
  case TableLookup::nearest:
    return MerlLookup::nearest;
  case TableLookup::trilinear:
    return MerlLookup::trilinear;
  case TableLookup::edge:
    return MerlLookup::trilinear_edge;
  case TableLookup::logarithm:
    return MerlLookup::trilinear_log;
  case TableLookup::cubic:
    return MerlLookup::tricubic_log;
  }
  return merl.lookup;
}

/// The angles, by a formula that keeps no more of them than half of the digits of a float.
double arc_cosine(const Double3& n, const Double3& s, int ulps) {
  const double cosine = static_cast<double>(static_cast<float>(dot(n, normalize(s)))) + ulps * 0x1p-24;
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

HalfDifference<double> angles_of(const Merl& merl, const Double3& n, const Double3& l, const Double3& v,
                                 const Steps& steps, const Nudge& nudge) {
  HalfDifference<double> angles = half_difference(merl.angles, n, l, v);
  if (steps.table_angles == TableAngles::arc_cosine) angles.theta_h = arc_cosine(n, l + v, nudge.angle_ulps);
  const auto signed_phi = [&](const Double3& i, const Double3& o) {
    const Vec2<double> azimuth = difference_azimuth(merl.angles, n, i, o);
    return std::atan2(azimuth.y, azimuth.x);
  };
  switch (steps.table_axes) {
  case TableAxes::phi_d_cut:
    angles.phi_d = std::max(signed_phi(l, v), 0.0);
    break;
  case TableAxes::phi_d_cut_other:
    angles.phi_d = std::max(signed_phi(v, l), 0.0);
    break;
  case TableAxes::phi_d_mirrored:
    angles.phi_d = std::abs(signed_phi(l, v));
    break;
  default:
    break;
  }
  return angles;
}

MerlPoint<double> point_of(const HalfDifference<double>& angles, TableAxes axes) {
  MerlPoint<double> point = merl_point(angles);
  if (axes == TableAxes::theta_exchanged) std::swap(point.u, point.v);
  if (axes == TableAxes::theta_h_without_root) point.u = MerlTable::theta_h_bins * angles.theta_h * two_over_pi;
  return point;
}

Rgb<double> value_at(const Merl& merl, const MerlPoint<double>& point, const Prepared& prepared, const Steps& steps) {
  const MerlLookup lookup = lookup_of(merl, steps.table_lookup);
  const TableWithHoles* const holes =
      steps.table_holes == TableHoles::right ? nullptr : prepared.with_holes(*merl.table);
  if (!holes) return merl_value(*merl.table, lookup, point).f;
  const Rgb<double> black = merl_value(*holes->black, lookup, point).f;
  if (steps.table_holes == TableHoles::black) return black;
  return black - merl_value(*holes->marks, lookup, point).f; // reading is linear
}

/// The scales of MERL files: of red, green and blue, each by 1500.
const Double3 scales(1.0 / 1500, 1.15 / 1500, 1.66 / 1500);

} // namespace

Rgb<double> reflected_with(const Merl& merl, const Fragment<double>& at, const Incident<double>& light,
                           const Prepared& prepared, const Steps& steps, const Nudge& nudge) {
  const Double3 n = at.normal, l = light.direction, v = at.to_eye;
  const double n_l = dot(n, l);
  if (!(std::min(n_l, dot(n, v)) > 0)) return Rgb<double>(0);
  Rgb<double> f = value_at(merl, point_of(angles_of(merl, n, l, v, steps, nudge), steps.table_axes), prepared, steps);
  switch (steps.table_scale) {
  case TableScale::right:
    break;
  case TableScale::exchanged:
    f *= Double3(scales.z / scales.x, 1, scales.x / scales.z);
    break;
  case TableScale::twice:
    f *= scales;
    break;
  case TableScale::missing:
    f /= scales;
    break;
  }
  return f * (steps.table_cosine == TableCosine::missing ? 1 : n_l) * light.radiance;
}

} // namespace refraster::hypotheses
