// make_mountains FILE.obj: a valley between ridges, 320 000 triangles over [-1, 1]^2, y up, heights 0 to about 0.5.
// v of a vertex is its height over the highest one, for a texture of what grows where (strata.png); u is noise.

#include <refraster/files.h>

#include "scenes/synthesis/noise.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace refraster {
namespace {

constexpr int quads = 400;      // a side
constexpr double summit = 0.55; // world units

/// Noise folded at its middle: a crest where it was 1/2. Finer octaves count more where the coarser ones are high, so
/// that ridges are rough and valleys smooth. After Musgrave, "Texturing and Modeling", 3rd edition, chapter 16.
double ridges(double u, double v) {
  double sum = 0, strength = 0.55, weight = 1;
  std::uint32_t cells = 5;
  for (std::uint32_t octave = 0; octave < 7; ++octave, cells = 2 * cells + 1, strength *= 0.46) {
    const double crest = 1 - std::abs(2 * smooth_noise(u * cells, v * cells, cells, cells, 73 + octave) - 1);
    sum += strength * weight * crest * crest;
    weight = std::clamp(1.6 * crest, 0.25, 1.0);
  }
  return sum;
}

/// Height over the square, u to the right, v away from the viewer.
double height(double u, double v) {
  // A winding valley; the land rises to both sides and to the back.
  const double bend = 0.5 + 0.22 * (smooth_noise(v * 3, 0, 3, 1, 92) - 0.5);
  const double aside = std::abs(u - bend);
  const double rise = std::clamp(0.10 + 2.6 * aside * aside + 0.95 * aside * v + 0.30 * v * v, 0.0, 1.0);
  return summit * rise * ridges(u, v);
}

Mesh mountains() {
  constexpr int points = quads + 1;
  const auto height_at = [](int column, int row) {
    // Beyond the border the noise repeats and is never negative in its arguments; only normals look there.
    return height((column + 1.0) / (points + 1), (row + 1.0) / (points + 1));
  };
  Mesh mesh;
  for (int row = 0; row < points; ++row)
    for (int column = 0; column < points; ++column) {
      const double y = height_at(column, row), spacing = 2.0 / quads;
      mesh.positions.emplace_back(-1 + column * spacing, y, 1 - row * spacing);
      // The normal of a height field: minus its slopes, by central differences; z runs against the rows.
      const double slope_x = (height_at(column + 1, row) - height_at(column - 1, row)) / (2 * spacing);
      const double slope_z = (height_at(column, row - 1) - height_at(column, row + 1)) / (2 * spacing);
      const double length = std::sqrt(slope_x * slope_x + 1 + slope_z * slope_z);
      mesh.normals.emplace_back(-slope_x / length, 1 / length, -slope_z / length);
      const double fraction = std::clamp(y / (0.62 * summit), 0.01, 0.99); // stays off the texture's seam
      mesh.uvs.emplace_back(fractal_noise(column / 401.0, row / 401.0, 24, 24, 2, 80), fraction);
    }
  for (std::uint32_t row = 0; row < quads; ++row)
    for (std::uint32_t column = 0; column < quads; ++column) {
      const std::uint32_t near_left = row * points + column, far_left = near_left + points;
      mesh.triangles.push_back({near_left, near_left + 1, far_left + 1});
      mesh.triangles.push_back({near_left, far_left + 1, far_left});
    }
  return mesh;
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_mountains FILE.obj\n";
    return 2;
  }
  try {
    refraster::write_obj(argv[1], refraster::mountains());
    std::cout << argv[1] << "\n";
  } catch (const std::exception& error) {
    std::cerr << "make_mountains: " << error.what() << "\n";
    return 4;
  }
}
