// Judges another renderer's pixels of a scene:
//     judge_pixels SCENE WIDTHxHEIGHT RADIANCE IDS SUBPIXEL_BITS DRIVER
// RADIANCE and IDS are files of float32 RGBA, row 0 at the top; ids are object and triangle, counted from 1. Exit 1
// where a pixel is unexplained.

#include <refraster/files.h>

#include "io/file/input_file.h"
#include "verify/device/read_profile.h"
#include "verify/verdict/verdict.h"

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
  DeviceImage image;
  image.colour = read_pixels(argv[3], width, height, 3);
  image.ids = read_pixels(argv[4], width, height, 2);
  image.full_scale = 1, image.precision = StoredPrecision::floats(0x1p-24);
  DeviceProfile profile = device_profile("swiftshader");
  profile.raster.lattice = std::ldexp(1.0, -std::atoi(argv[5]));
  const Scene scene = read_scene(argv[1], {.outside = Outside::allowed});
  const Verdict verdict = judge(scene, image, profile, {});
  for (const auto& [value, name] : EnumNames<PixelClass>::names)
    if (verdict.count(value) > 0)
      std::printf("%s %llu; ", std::string(name).c_str(), static_cast<unsigned long long>(verdict.count(value)));
  std::printf("bounds of %.3g levels in the median\n", verdict.power.median);
  int said = 0;
  for (const JudgedDetail& pixel : verdict.details) {
    if (pixel.found != PixelClass::unexplained || said++ == 10) continue;
    std::printf("  (%d, %d) object %u, by its %s:", pixel.x, pixel.y, pixel.object,
                std::string(name_of(pixel.objection)).c_str());
    for (int c = 0; c < 3; ++c)
      std::printf(" %.6g, here %.6g, allowed %.6g to %.6g;", pixel.actual[c], pixel.reference[c], pixel.allowed.lo[c],
                  pixel.allowed.hi[c]);
    std::printf("\n");
  }
  return verdict.is_explained() ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
