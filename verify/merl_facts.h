#pragma once
// What can be said of a measured BRDF without drawing it.

#include <refraster/material.h>

#include <array>
#include <cstdint>
#include <vector>

namespace refraster {

struct ChannelFacts {
  double min = 0, max = 0, mean = 0; // of all measured samples, 1/sr; each sample counts once
};

/// Light from one direction: the fraction of it that is reflected, by channel.
struct AlbedoFact {
  double degrees; // from the normal
  Rgb<double> albedo;
};

struct MerlFacts {
  std::uint64_t never_measured = 0; // samples with a negative channel
  std::array<ChannelFacts, 3> channels;
  std::vector<AlbedoFact> albedos;
  double reciprocity_error = 0; // greatest |f(i, o) - f(o, i)| / max(f(i, o), f(o, i)) met
  int reciprocity_pairs = 0;    // of random directions that were tried
};

/// The angles of incidence of MerlFacts::albedos.
inline constexpr double albedo_degrees[] = {0, 30, 60, 75};

/// All facts, from the default lookup (trilinear, closed form). About a second. The same bits every time.
MerlFacts merl_facts(const MerlTable& table);

/// Directional albedo: the integral of f(i, o) <n.o> over the hemisphere of o. degrees in [0, 90).
///
/// It is taken over the half vector h, with d omega_o = 4 (o.h) d omega_h, and theta_h spaced as the table spaces it
/// (by the square root): a highlight that fills one bin is seen by as many points as a wide one. Midpoint rule, 720 x
/// 360 points; within 1e-3 for a table without a jump inside the hemisphere (tests/unit/verify/test_merl_facts.cpp).
Rgb<double> directional_albedo(const MerlTable& table, double degrees);

} // namespace refraster
