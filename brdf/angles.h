#pragma once
// Pairs of directions as people name them: by angles, in degrees.

#include "scenes/synthesis/merl_synthesis.h"

namespace refraster {

class JsonWriter;

/// Of light and eye from the normal, 0 to 90 above the surface; and the azimuth from light to eye. 180: opposite each
/// other, as a mirror has them; 0: both on one side.
struct InOutAngles {
  double theta_in = 0, theta_out = 0, dphi = 0; // degrees
};

/// Rusinkiewicz's, as HalfDifference of shading/half_difference.h has them, in degrees: theta_h from the normal to the
/// half vector, theta_d from that to the light, phi_d the light's azimuth around it.
struct HalfDifferenceAngles {
  double theta_h = 0, theta_d = 0, phi_d = 0; // degrees
};

/// Unit vectors over a surface with normal (0, 0, 1); the light in the x-z plane. Exact where the sines are: 0, 30, 90.
DirectionPair directions_of(const InOutAngles& angles);
/// The same, with the half vector in the x-z plane. Either direction may lie below the surface.
DirectionPair directions_of(const HalfDifferenceAngles& angles);

/// theta_in, theta_out in [0, 180]; dphi in [0, 180]: the two sides of the plane of incidence look alike.
InOutAngles in_out_angles(const DirectionPair& pair);
/// theta_h and theta_d in [0, 90], phi_d in [0, 180).
HalfDifferenceAngles half_difference_angles(const DirectionPair& pair);

/// Members of an object that is being written, each under its own name.
void write_members(JsonWriter& json, const InOutAngles& angles);
void write_members(JsonWriter& json, const HalfDifferenceAngles& angles);

} // namespace refraster
