#include "brdf/angles.h"

#include "io/json/json_writer.h"
#include "math/constants.h"
#include "shading/half_difference.h"

#include <cmath>

namespace refraster {
namespace {

double degrees(double radians_of_angle) {
  return radians_of_angle * 180 / std::numbers::pi;
}

} // namespace

DirectionPair directions_of(const InOutAngles& angles) {
  const SineCosine in = sine_cosine_of_degrees(angles.theta_in), out = sine_cosine_of_degrees(angles.theta_out);
  const SineCosine turn = sine_cosine_of_degrees(angles.dphi);
  return {{in.sine, 0, in.cosine}, {out.sine * turn.cosine, out.sine * turn.sine, out.cosine}};
}

DirectionPair directions_of(const HalfDifferenceAngles& angles) {
  return directions_of(sine_cosine_of_degrees(angles.theta_h), sine_cosine_of_degrees(angles.theta_d),
                       sine_cosine_of_degrees(90 - angles.phi_d));
}

InOutAngles in_out_angles(const DirectionPair& pair) {
  const Double3 &i = pair.i, &o = pair.o;
  // From tangents: a cosine near 1 has lost the angle (docs/merl.md).
  const double across = i.x * o.y - i.y * o.x, along = i.x * o.x + i.y * o.y;
  return {degrees(std::atan2(std::hypot(i.x, i.y), i.z)), degrees(std::atan2(std::hypot(o.x, o.y), o.z)),
          degrees(std::atan2(std::abs(across), along))};
}

HalfDifferenceAngles half_difference_angles(const DirectionPair& pair) {
  const HalfDifference<double> angles = half_difference(MerlAngles::closed, Double3(0, 0, 1), pair.i, pair.o);
  return {degrees(angles.theta_h), degrees(angles.theta_d), degrees(angles.phi_d)};
}

void write_members(JsonWriter& json, const InOutAngles& angles) {
  json.member("theta_in", angles.theta_in);
  json.member("theta_out", angles.theta_out);
  json.member("dphi", angles.dphi);
}

void write_members(JsonWriter& json, const HalfDifferenceAngles& angles) {
  json.member("theta_h", angles.theta_h);
  json.member("theta_d", angles.theta_d);
  json.member("phi_d", angles.phi_d);
}

} // namespace refraster
