#include "verify/merl_facts.h"

#include "shading/merl_lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace refraster {
namespace {

constexpr Double3 normal{0, 0, 1};

Rgb<double> brdf(const MerlTable& table, const Double3& i, const Double3& o) {
  return merl_value(table, MerlLookup::trilinear, merl_point(half_difference(MerlAngles::closed, normal, i, o))).f;
}

/// The direction at an angle from the normal and an azimuth, in radians.
Double3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

void note_samples(const MerlTable& table, MerlFacts& facts) {
  std::array<double, 3> sums{};
  for (ChannelFacts& channel : facts.channels) channel.min = std::numeric_limits<double>::infinity();
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 0; d < MerlTable::theta_d_bins; ++d)
      for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
        const Rgb<double> f = table.sample(h, d, p);
        if (std::min({f.x, f.y, f.z}) < 0) {
          ++facts.never_measured;
          continue;
        }
        for (int c = 0; c < 3; ++c) {
          ChannelFacts& channel = facts.channels[static_cast<std::size_t>(c)];
          channel.min = std::min(channel.min, f[c]);
          channel.max = std::max(channel.max, f[c]);
          sums[static_cast<std::size_t>(c)] += f[c];
        }
      }
  const std::uint64_t measured = MerlTable::samples - facts.never_measured;
  for (std::size_t c = 0; c < 3; ++c) {
    if (measured == 0) facts.channels[c].min = 0;
    else facts.channels[c].mean = sums[c] / static_cast<double>(measured);
  }
}

/// A direction above the surface, uniform in solid angle.
Double3 random_direction(std::mt19937& bits) {
  const auto uniform = [&] { return (static_cast<double>(bits()) + 0.5) / 4294967296.0; };
  const double z = uniform(), phi = 2 * std::numbers::pi * uniform();
  return direction(std::acos(z), phi);
}

void note_reciprocity(const MerlTable& table, MerlFacts& facts) {
  std::mt19937 bits; // the same pairs every time; the library's distributions are not the same everywhere
  facts.reciprocity_pairs = 100'000;
  for (int k = 0; k < facts.reciprocity_pairs; ++k) {
    const Double3 i = random_direction(bits), o = random_direction(bits);
    const Rgb<double> there = brdf(table, i, o), back = brdf(table, o, i);
    for (int c = 0; c < 3; ++c) {
      const double larger = std::max(there[c], back[c]);
      if (larger > 0)
        facts.reciprocity_error = std::max(facts.reciprocity_error, std::abs(there[c] - back[c]) / larger);
    }
  }
}

} // namespace

Rgb<double> directional_albedo(const MerlTable& table, double degrees) {
  constexpr int theta_steps = 720, phi_steps = 360;
  const Double3 i = direction(degrees * std::numbers::pi / 180, 0);
  Rgb<double> sum(0);
  for (int step = 0; step < theta_steps; ++step) {
    const double t = (step + 0.5) / theta_steps; // theta_h = pi/2 t^2, d theta_h = pi t dt
    const double theta = std::numbers::pi / 2 * t * t;
    const double ring = std::sin(theta) * std::numbers::pi * t; // of d omega_h, by dt d phi
    for (int turn = 0; turn < phi_steps; ++turn) {
      const Double3 h = direction(theta, 2 * std::numbers::pi * (turn + 0.5) / phi_steps);
      const double i_h = dot(i, h);
      const Double3 o = 2 * i_h * h - i;
      if (i_h > 0 && o.z > 0) sum += brdf(table, i, o) * (o.z * 4 * i_h * ring);
    }
  }
  return sum * (2 * std::numbers::pi / phi_steps / theta_steps);
}

MerlFacts merl_facts(const MerlTable& table) {
  MerlFacts facts;
  note_samples(table, facts);
  for (const double degrees : albedo_degrees) facts.albedos.push_back({degrees, directional_albedo(table, degrees)});
  note_reciprocity(table, facts);
  return facts;
}

} // namespace refraster
