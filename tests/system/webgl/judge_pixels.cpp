// Compares another renderer's pixels of a scene with ours:
//     judge_pixels SCENE WIDTHxHEIGHT RADIANCE IDS SUBPIXEL_BITS DRIVER
// RADIANCE and IDS are files of float32 RGBA, row 0 at the top; ids are object and triangle, counted from 1. Exit 1
// where another surface is shown for no reason, or a colour is over its bound.

#include <refraster/files.h>

#include "io/file/input_file.h"
#include "tests/support/gl/side_by_side.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using namespace refraster;

/// The first `channels` of each RGBA pixel.
Image<float> read_pixels(const char* path, int width, int height, int channels) {
  const std::string bytes = read_file(path, "pixels", 1 << 30);
  Image<float> image(width, height, channels);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (bytes.size() != 4 * sizeof(float) * pixels)
    throw std::runtime_error(std::string(path) + ": not that many pixels");
  const auto count = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < pixels; ++i)
    std::memcpy(&image.values[count * i], bytes.data() + 4 * sizeof(float) * i, count * sizeof(float));
  return image;
}

} // namespace

int main(int argc, char** argv) try {
  int width = 0, height = 0;
  if (argc != 7 || std::sscanf(argv[2], "%dx%d", &width, &height) != 2) {
    std::fprintf(stderr, "usage: judge_pixels SCENE WIDTHxHEIGHT RADIANCE IDS SUBPIXEL_BITS DRIVER\n");
    return 2;
  }
  const SideBySide found =
      side_by_side(read_scene(argv[1]),
                   {argv[6], read_pixels(argv[3], width, height, 3), read_pixels(argv[4], width, height, 2), {}},
                   swiftshader_tolerances(std::ldexp(1.0, -std::atoi(argv[5]))));
  const auto n = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
  std::printf(
      "%llu pixels equal, %llu off by one level, %llu by more; %llu on edges, %llu equally far, %llu other surfaces; "
      "%llu over the bound, largest fraction of it %.3g; worst pixel (%d, %d) %s: %.3g levels, %s\n",
      n(found.equal), n(found.off_by_one), n(found.off_by_more), n(found.edge_pixels), n(found.depth_pixels),
      n(found.coverage_pixels), n(found.over_bound), found.worst_fraction_of_bound, found.worst.x, found.worst.y,
      found.worst.object.c_str(), found.worst.difference, found.worst.cause.c_str());
  for (const WorstPixel& p : found.unexplained)
    std::printf("  (%d, %d) %s, %s: %.3g levels\n", p.x, p.y, p.object.c_str(), p.cause.c_str(), p.difference);
  return found.coverage_pixels + found.over_bound > 0 ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
