// make_waves COLUMNSxROWS FILE.obj: a rough sea of 2 COLUMNS ROWS triangles, which overlaps a 16:9 frame by 3 % on each
// side when seen from (0, 0, 3) with a field of view of 45 degrees. With 1000x500 that is a million, each about a pixel
// at 1280x720.

#include "io/obj_file.h"
#include "scenes/tools/noise.h"

#include <charconv>
#include <cmath>
#include <iostream>
#include <optional>
#include <string_view>

namespace refraster {
namespace {

constexpr double half_height = 1.03 * 3 * 0.41421356237309503; // tan(45 / 2 degrees)
constexpr double half_width = half_height * 16 / 9;

struct Quads {
  std::uint32_t columns, rows;
};

/// u, v in [0, 1] over the frame. Octaves of noise, each turned against the last by the angle of the triangle 3, 4, 5,
/// so that no lattice shows. No slope is steep enough to hide another.
double height(double u, double v) {
  double x = 16 * u + 2, y = 9 * v + 18, sum = 0; // turning leaves both positive, as smooth_noise needs
  double strength = 0.05;
  for (std::uint32_t octave = 0; octave < 4; ++octave, strength *= 0.45) {
    sum += strength * smooth_noise(x, y, 1024, 1024, 11 + octave);
    const double turned = 2 * (0.8 * x + 0.6 * y);
    y = 2 * (0.8 * y - 0.6 * x) + 128;
    x = turned;
  }
  return sum;
}

Mesh waves(const Quads& quads) {
  Mesh mesh;
  for (std::uint32_t row = 0; row <= quads.rows; ++row)
    for (std::uint32_t column = 0; column <= quads.columns; ++column) {
      const double u = static_cast<double>(column) / quads.columns, v = static_cast<double>(row) / quads.rows;
      mesh.positions.emplace_back((2 * u - 1) * half_width, (2 * v - 1) * half_height, height(u, v));
      // The normal of a height field: minus its slopes, by differences over a thousandth of the frame.
      constexpr double step = 0.001;
      const double slope_x = (height(u + step, v) - height(u, v)) / (2 * step * half_width);
      const double slope_y = (height(u, v + step) - height(u, v)) / (2 * step * half_height);
      const double length = std::sqrt(slope_x * slope_x + slope_y * slope_y + 1);
      mesh.normals.emplace_back(-slope_x / length, -slope_y / length, 1 / length);
    }
  const std::uint32_t points = quads.columns + 1;
  for (std::uint32_t row = 0; row < quads.rows; ++row)
    for (std::uint32_t column = 0; column < quads.columns; ++column) {
      const std::uint32_t low_left = row * points + column, high_left = low_left + points;
      mesh.triangles.push_back({low_left, low_left + 1, high_left + 1});
      mesh.triangles.push_back({low_left, high_left + 1, high_left});
    }
  return mesh;
}

std::optional<Quads> quads_from(std::string_view text) {
  Quads quads{};
  const char* const end = text.data() + text.size();
  const auto [x, first_error] = std::from_chars(text.data(), end, quads.columns);
  if (first_error != std::errc{} || x == end || *x != 'x') return std::nullopt;
  const auto [rest, second_error] = std::from_chars(x + 1, end, quads.rows);
  const auto sane = [](std::uint32_t n) { return n >= 1 && n <= 10'000; };
  if (second_error != std::errc{} || rest != end || !sane(quads.columns) || !sane(quads.rows)) return std::nullopt;
  return quads;
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  const auto quads = argc == 3 ? refraster::quads_from(argv[1]) : std::nullopt;
  if (!quads) {
    std::cerr << "usage: make_waves COLUMNSxROWS FILE.obj, each 1 to 10000\n";
    return 2;
  }
  try {
    refraster::write_obj(argv[2], refraster::waves(*quads));
    std::cout << argv[2] << "\n";
  } catch (const std::exception& error) {
    std::cerr << "make_waves: " << error.what() << "\n";
    return 4;
  }
}
