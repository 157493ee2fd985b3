#pragma once
// Noise for generated assets. Integers and + - * only: the same bits on every machine.

#include <cstdint>

namespace refraster {

/// A number in [0, 1) for each lattice point, without a visible pattern. The mixing steps are those that end
/// MurmurHash3 (Appleby, public domain).
inline double lattice_noise(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = x * 0x9e3779b9u + y * 0x85ebca6bu + seed * 0xc2b2ae35u;
  h = (h ^ h >> 16) * 0x85ebca6bu;
  h = (h ^ h >> 13) * 0xc2b2ae35u;
  h ^= h >> 16;
  return h * 0x1p-32;
}

/// Smooth noise in [0, 1) over x, y >= 0: lattice points one unit apart, repeated after `period_x` and `period_y` of
/// them. The blend's first and second derivatives vanish at the lattice, so that no grid shows in a lit surface.
inline double smooth_noise(double x, double y, std::uint32_t period_x, std::uint32_t period_y, std::uint32_t seed) {
  const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
  const auto blend = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double s = blend(x - column), t = blend(y - row);
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return lattice_noise((column + i) % period_x, (row + j) % period_y, seed);
  };
  const double below = at(0, 0) + (at(1, 0) - at(0, 0)) * s;
  const double above = at(0, 1) + (at(1, 1) - at(0, 1)) * s;
  return below + (above - below) * t;
}

/// Octaves of noise, each twice as fine and half as strong, in [0, 1). u, v in [0, 1]: one period; the first octave has
/// `cells_x` by `cells_y` lattice cells.
inline double fractal_noise(double u, double v, std::uint32_t cells_x, std::uint32_t cells_y, int octaves,
                            std::uint32_t seed) {
  double sum = 0, strength = 0.5;
  for (int octave = 0; octave < octaves; ++octave, strength /= 2, cells_x *= 2, cells_y *= 2)
    sum +=
        strength * smooth_noise(u * cells_x, v * cells_y, cells_x, cells_y, seed + static_cast<std::uint32_t>(octave));
  return sum / (1 - 2 * strength);
}

} // namespace refraster
