#include "brdf/facts.h"

#include "io/file/text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace refraster {
namespace {

/// The direction at an angle from the normal and an azimuth, in radians.
Double3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A bin as a table has it, rim included; as models have it above the surface.
BrdfValue at_bin(const Brdf& brdf, int h, int d, int p) {
  if (!brdf.table()) return brdf.value(directions_at_centre(h, d, p));
  const Rgb<double> f = brdf.table()->table->sample(h, d, p);
  return {f, std::min({f.x, f.y, f.z}) >= 0};
}

void note_samples(const Brdf& brdf, BrdfFacts& facts) {
  std::array<double, 3> sums{};
  for (ChannelFacts& channel : facts.channels) {
    channel.min = std::numeric_limits<double>::infinity();
    channel.max = -channel.min;
  }
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 0; d < MerlTable::theta_d_bins; ++d)
      for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
        const BrdfValue value = at_bin(brdf, h, d, p);
        if (!value.measured) continue;
        ++facts.samples;
        for (int c = 0; c < 3; ++c) {
          ChannelFacts& channel = facts.channels[static_cast<std::size_t>(c)];
          channel.min = std::min(channel.min, value.f[c]);
          channel.max = std::max(channel.max, value.f[c]);
          sums[static_cast<std::size_t>(c)] += value.f[c];
        }
      }
  if (brdf.table()) facts.never_measured = MerlTable::samples - facts.samples;
  for (std::size_t c = 0; c < 3; ++c) {
    if (facts.samples == 0) facts.channels[c].min = facts.channels[c].max = 0;
    else facts.channels[c].mean = sums[c] / static_cast<double>(facts.samples);
  }
}

/// A direction above the surface, uniform in solid angle.
Double3 random_direction(std::mt19937& bits) {
  const auto uniform = [&] { return (static_cast<double>(bits()) + 0.5) / 4294967296.0; };
  const double z = uniform(), phi = 2 * std::numbers::pi * uniform();
  return direction(std::acos(z), phi);
}

void note_reciprocity(const Brdf& brdf, BrdfFacts& facts) {
  std::mt19937 bits; // the same pairs every time; the library's distributions are not the same everywhere
  facts.reciprocity_pairs = 100'000;
  for (int k = 0; k < facts.reciprocity_pairs; ++k) {
    const Double3 i = random_direction(bits), o = random_direction(bits);
    const Rgb<double> there = brdf.value({i, o}).f, back = brdf.value({o, i}).f;
    for (int c = 0; c < 3; ++c) {
      const double larger = std::max(there[c], back[c]);
      if (larger > 0)
        facts.reciprocity_error = std::max(facts.reciprocity_error, std::abs(there[c] - back[c]) / larger);
    }
  }
}

} // namespace

Rgb<double> directional_albedo(const Brdf& brdf, double degrees, const AlbedoSteps& steps) {
  const Double3 i = direction(degrees * std::numbers::pi / 180, 0);
  // Rings are added in their order, so that the sum does not depend on who computed them.
  std::vector<Rgb<double>> rings(static_cast<std::size_t>(steps.theta), Rgb<double>(0));
#pragma omp parallel for schedule(dynamic)
  for (int step = 0; step < steps.theta; ++step) {
    const double t = (step + 0.5) / steps.theta; // theta_h = pi/2 t^2, d theta_h = pi t dt
    const double theta = std::numbers::pi / 2 * t * t;
    const double ring = std::sin(theta) * std::numbers::pi * t; // of d omega_h, by dt d phi
    for (int turn = 0; turn < steps.phi; ++turn) {
      const Double3 h = direction(theta, 2 * std::numbers::pi * (turn + 0.5) / steps.phi);
      const double i_h = dot(i, h);
      const Double3 o = 2 * i_h * h - i;
      if (i_h > 0 && o.z > 0) rings[static_cast<std::size_t>(step)] += brdf.value({i, o}).f * (o.z * 4 * i_h * ring);
    }
  }
  Rgb<double> sum(0);
  for (const Rgb<double>& ring : rings) sum += ring;
  return sum * (2 * std::numbers::pi / steps.phi / steps.theta);
}

BrdfFacts brdf_facts(const Brdf& brdf) {
  BrdfFacts facts;
  note_samples(brdf, facts);
  for (const double degrees : albedo_degrees) facts.albedos.push_back({degrees, directional_albedo(brdf, degrees)});
  note_reciprocity(brdf, facts);
  return facts;
}

std::vector<std::string> impossibilities(const BrdfFacts& facts) {
  constexpr double quadrature = 1e-3; // what directional_albedo may be off
  // Formulas round differently with i and o exchanged; a few roundings are no break of the law.
  constexpr double roundings = 0x1p-40;
  std::vector<std::string> sentences;
  const AlbedoFact* greatest = nullptr;
  const auto largest = [](const Rgb<double>& rgb) { return std::max({rgb.x, rgb.y, rgb.z}); };
  for (const AlbedoFact& fact : facts.albedos)
    if (!greatest || largest(fact.albedo) > largest(greatest->albedo)) greatest = &fact;
  if (greatest && largest(greatest->albedo) > 1 + quadrature)
    sentences.push_back(format("reflects more light than arrives: albedo %.4g at %g degrees", largest(greatest->albedo),
                               greatest->degrees));
  const double least = std::min({facts.channels[0].min, facts.channels[1].min, facts.channels[2].min});
  if (least < 0) sentences.push_back(format("has negative values, down to %.4g per steradian", least));
  if (facts.reciprocity_error > roundings)
    sentences.push_back(format("is not reciprocal: f(i, o) and f(o, i) differ by up to %.3g of the larger one",
                               facts.reciprocity_error));
  return sentences;
}

} // namespace refraster
