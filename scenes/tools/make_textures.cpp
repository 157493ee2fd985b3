// make_textures FOLDER: the textures of the scenes, made from noise, so that the repository holds no picture of unknown
// origin and none that it could not make again. All repeat without a seam.

#include <refraster/files.h>

#include "scenes/synthesis/noise.h"

#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace refraster {
namespace {

using Colour = Double3; // 0 to 255

Colour mix(const Colour& a, const Colour& b, double t) {
  return a + (b - a) * std::clamp(t, 0.0, 1.0);
}

/// 0 below a, 1 above b, smooth between.
double step(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

/// How far x is from the nearest integer, 0 to 0.5.
double from_integer(double x) {
  return std::abs(x - std::floor(x + 0.5));
}

/// u to the right and v up, in [0, 1): the convention of texture coordinates.
template <class ColourAt>
void write_texture(const std::string& path, int width, int height, ColourAt&& colour_at) {
  Image<std::uint8_t> image(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Colour colour = colour_at((x + 0.5) / width, (height - y - 0.5) / height);
      for (int c = 0; c < 3; ++c)
        image.at(x, y)[c] = static_cast<std::uint8_t>(std::floor(std::clamp(colour[c], 0.0, 255.0) + 0.5));
    }
  write_image(path, image);
  std::cout << path << "\n";
}

/// Four boards, grain along u.
Colour wood(double u, double v) {
  const auto board = static_cast<std::uint32_t>(v * 4);
  const double across = v * 4 - board, shift = lattice_noise(board, 0, 1);
  // Year rings, cut lengthwise: bands across the board, bent by noise that is ten times longer than wide.
  const double bend = fractal_noise(u, v, 2, 16, 4, 10 + board);
  const double ring = from_integer(across * 2.5 + bend * 4 + shift * 7) * 2;
  const double fibre = fractal_noise(u, v, 8, 128, 2, 20);
  const Colour light{202, 148, 92}, dark{138, 86, 46};
  const Colour grain = mix(light, dark, 0.15 + 0.6 * ring * ring + 0.5 * (fibre - 0.5));
  const double gap = step(0.0, 0.025, 0.5 - from_integer(across + 0.5)); // dark joint between boards
  return grain * ((0.86 + 0.2 * shift) * (0.35 + 0.65 * gap));
}

/// 4 x 4 slabs of slate with light joints.
Colour tiles(double u, double v) {
  const double x = u * 4, y = v * 4;
  const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
  const double tone = lattice_noise(column, row, 2);
  const double cloud = fractal_noise(u, v, 6, 6, 5, 30 + 8 * (column + 4 * row));
  const double speck = fractal_noise(u, v, 96, 96, 1, 60);
  const Colour slate = mix({92, 104, 118}, {150, 148, 140}, 0.55 * tone + 0.9 * (cloud - 0.35)) * (0.94 + 0.12 * speck);
  const double slab = step(0.012, 0.04, std::min(from_integer(x), from_integer(y)));
  return mix({58, 56, 54}, slate, slab);
}

/// Two colours of squares, 8 x 8: hard edges, the hardest test of a filter.
Colour checker(double u, double v) {
  const bool odd = (static_cast<int>(u * 8) + static_cast<int>(v * 8)) % 2 != 0;
  return odd ? Colour{226, 214, 190} : Colour{74, 38, 44};
}

/// Plain weave of 24 x 24 threads.
Colour weave(double u, double v) {
  const double x = u * 24, y = v * 24;
  const bool warp_on_top = (static_cast<int>(x) + static_cast<int>(y)) % 2 == 0;
  // A thread is highest in the middle, and dips under its neighbours at both ends.
  const double along = warp_on_top ? y : x, across = warp_on_top ? x : y;
  const double round = 1 - 4 * std::pow(across - std::floor(across) - 0.5, 2);
  const double dip = 1 - 3 * std::pow(along - std::floor(along) - 0.5, 2);
  const double fibre = fractal_noise(u, v, warp_on_top ? 128 : 24, warp_on_top ? 24 : 128, 1, 40);
  const Colour thread = warp_on_top ? Colour{196, 84, 62} : Colour{226, 190, 142};
  return thread * (0.35 + 0.65 * round * dip) * (0.85 + 0.3 * fibre);
}

/// What grows at which height: v is the height, u only varies it. For make_mountains.
Colour strata(double u, double v) {
  const double h = v + 0.24 * (fractal_noise(u, v, 8, 8, 4, 50) - 0.5);
  Colour colour = mix({96, 88, 70}, {58, 74, 44}, step(0.06, 0.14, h)); // shore, then meadow
  colour = mix(colour, {92, 84, 76}, step(0.30, 0.42, h));              // rock
  colour = mix(colour, {66, 62, 64}, step(0.42, 0.60, h));              // darker rock
  return mix(colour, {238, 240, 246}, step(0.62, 0.70, h));             // snow
}

/// A studio's backdrop: light in the middle, falling off to the corners. White; the material's ka colours it.
Colour backdrop(double u, double v) {
  const double x = 2 * u - 1, y = 2 * v - 1;
  const double distance = std::sqrt(0.9 * x * x + 1.1 * y * y);
  const double grain = lattice_noise(static_cast<std::uint32_t>(u * 256), static_cast<std::uint32_t>(v * 144), 3);
  return Colour(245 - 215 * step(0.0, 1.25, distance) + 4 * (grain - 0.5));
}

/// Evening: warm at the horizon (v = 0), dark blue above.
Colour sky(double, double v) {
  const Colour low = mix({222, 142, 92}, {150, 104, 110}, step(0.0, 0.28, v));
  return mix(low, {30, 38, 66}, step(0.10, 0.85, v));
}

} // namespace
} // namespace refraster

int main(int argc, char** argv) {
  using namespace refraster;
  if (argc != 2) {
    std::cerr << "usage: make_textures FOLDER\n";
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  try {
    write_texture(folder + "wood.png", 256, 256, wood);
    write_texture(folder + "tiles.png", 256, 256, tiles);
    write_texture(folder + "checker.png", 64, 64, checker);
    write_texture(folder + "weave.png", 256, 256, weave);
    write_texture(folder + "strata.png", 64, 256, strata);
    write_texture(folder + "sky.png", 4, 256, sky);
    write_texture(folder + "backdrop.png", 256, 144, backdrop);
  } catch (const std::exception& error) {
    std::cerr << "make_textures: " << error.what() << "\n";
    return 4;
  }
}
