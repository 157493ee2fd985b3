#pragma once
// The bins of a MERL table as points of quadrature over all pairs of directions.

#include "scenes/synthesis/merl_synthesis.h"

#include <array>
#include <cmath>
#include <numbers>

namespace refraster {

/// How much of all pairs of directions each bin stands for, in steradian^2: the integral of d omega_i d omega_o over
/// the bin and all azimuths of h,
///     d omega_i d omega_o = 4 cos theta_d  d omega_h d omega_d,
/// since d omega_o = 4 (o.h) d omega_h for a fixed i (Torrance and Sparrow 1967), and d omega_i = d omega_d for a fixed
/// h. phi_d beyond the table's half turn is the other half of it with i and o exchanged, and counts here as well.
struct BinWeights {
  std::array<double, MerlTable::theta_h_bins> of_h{};
  std::array<double, MerlTable::theta_d_bins> of_d{};

  BinWeights() {
    constexpr double pi = std::numbers::pi, half_pi = pi / 2;
    for (std::size_t h = 0; h < of_h.size(); ++h) {
      const auto edge = [&](std::size_t bin) {
        const double root = static_cast<double>(bin) / MerlTable::theta_h_bins;
        return half_pi * root * root;
      };
      // cos a - cos b, as a product: the first bins are 1e-4 wide.
      const double a = edge(h), b = edge(h + 1);
      of_h[h] = 2 * pi * 2 * std::sin((a + b) / 2) * std::sin((b - a) / 2);
    }
    for (std::size_t d = 0; d < of_d.size(); ++d) {
      const auto squared_sine = [&](std::size_t bin) {
        const double sine = std::sin(half_pi * static_cast<double>(bin) / MerlTable::theta_d_bins);
        return sine * sine;
      };
      // The integral of 4 cos sin; a bin of phi_d and the one that stands for it with i and o exchanged.
      of_d[d] = 2 * (squared_sine(d + 1) - squared_sine(d)) * 2 * pi / MerlTable::phi_d_bins;
    }
  }

  double operator()(int h, int d) const {
    return of_h[static_cast<std::size_t>(h)] * of_d[static_cast<std::size_t>(d)];
  }
};

} // namespace refraster
