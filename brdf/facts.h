#pragma once
// What can be said of a reflectance without drawing it.

#include "brdf/brdf.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

struct ChannelFacts {
  double min = 0, max = 0, mean = 0; // of all samples, 1/sr; each sample counts once
};

/// Light from one direction: the fraction of it that is reflected, by channel.
struct AlbedoFact {
  double degrees; // from the normal
  Rgb<double> albedo;
};

struct BrdfFacts {
  std::uint64_t samples = 0;        // measured ones of a table; of models the table's bins above the surface
  std::uint64_t never_measured = 0; // samples of a table with a negative channel
  std::array<ChannelFacts, 3> channels;
  std::vector<AlbedoFact> albedos;
  double reciprocity_error = 0; // greatest |f(i, o) - f(o, i)| / max(f(i, o), f(o, i)) met
  int reciprocity_pairs = 0;    // of random directions that were tried
};

/// The angles of incidence of BrdfFacts::albedos.
inline constexpr double albedo_degrees[] = {0, 30, 60, 75};

/// All facts. Some seconds of one thread, shared by all there are. The same bits every time, for any number of them.
BrdfFacts brdf_facts(const Brdf& brdf);

/// How finely directional_albedo looks, midpoints of theta_h and of its azimuth.
struct AlbedoSteps {
  int theta = 720, phi = 360;
};

/// Directional albedo: the integral of f(i, o) <n.o> over the hemisphere of o. degrees in [0, 90).
///
/// It is taken over the half vector h, with d omega_o = 4 (o.h) d omega_h, and theta_h spaced as the table spaces it
/// (by the square root): a highlight that fills one bin is seen by as many points as a wide one. Midpoint rule; with
/// 720 x 360 points within 1e-3 for a table without a jump inside the hemisphere (tests/unit/brdf/test_facts.cpp).
Rgb<double> directional_albedo(const Brdf& brdf, double degrees, const AlbedoSteps& steps = {});

/// What no surface does, a sentence each: more light reflected than arrives (beyond the 1e-3 of the quadrature),
/// negative values, f(i, o) that is not f(o, i).
std::vector<std::string> impossibilities(const BrdfFacts& facts);

/// A reflectance, and what is known of it.
struct BrdfInfo {
  Brdf brdf;
  std::string material; // of a table: empty if not one of the database
  BrdfFacts facts;
};

/// Of a table, the label is the path that it was read from. Throws InputError if the file is no longer there.
BrdfInfo brdf_info(const Brdf& brdf);

/// For people.
std::string info_text(const BrdfInfo& info);
/// docs/reports.md.
std::string info_json(const BrdfInfo& info);

} // namespace refraster
