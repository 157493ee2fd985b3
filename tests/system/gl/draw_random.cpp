// Random scenes through a driver, each judged in 8 bits and in float: draw_random DRIVER FIRST END, for the seeds
// [FIRST, END). A line for each image with pixels that are unexplained, with the first of them, and the sums by class.
// Exit code 1 if there are any, 77 without the driver.

#include "tests/support/gl/device_images.h"
#include "tests/support/gl/driver_runs.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using namespace refraster;

constexpr int shown_pixels = 4; // of each image

unsigned long long n(std::uint64_t count) {
  return count;
}

struct ClassCounts {
  std::uint64_t scenes = 0, scenes_unexplained = 0;
  std::array<std::uint64_t, pixel_classes> counts{};

  void add(const Verdict& verdict) {
    ++scenes;
    scenes_unexplained += !verdict.is_explained();
    for (std::size_t i = 0; i < pixel_classes; ++i) counts[i] += verdict.counts[i];
  }
  void print(const char* format) const {
    std::printf("%s: %llu scenes, unexplained in %llu;", format, n(scenes), n(scenes_unexplained));
    for (const auto& [value, name] : EnumNames<PixelClass>::names)
      std::printf(" %s %llu", std::string(name).c_str(), n(counts[static_cast<std::size_t>(value)]));
    std::printf("\n");
  }
};

void report(std::uint64_t seed, const char* format, const Scene& scene, const Verdict& verdict) {
  if (verdict.is_explained()) return;
  std::printf("seed %llu in %s, %d x %d: %llu unexplained\n", n(seed), format, verdict.width, verdict.height,
              n(verdict.count(PixelClass::unexplained)));
  int shown = 0;
  for (const JudgedDetail& pixel : verdict.details) {
    if (pixel.found != PixelClass::unexplained || shown++ == shown_pixels) continue;
    const std::string name = pixel.object == 0
                                 ? "background"
                                 : scene.objects[pixel.object - 1].name + " (" +
                                       std::string(scene.objects[pixel.object - 1].material.function_name()) +
                                       ") triangle " + std::to_string(pixel.triangle);
    std::printf("  (%d, %d) %s, by its %s:", pixel.x, pixel.y, name.c_str(),
                std::string(name_of(pixel.objection)).c_str());
    for (int c = 0; c < 3; ++c)
      std::printf(" %.9g is %.9g of [%.9g, %.9g];", pixel.reference[c], pixel.actual[c], pixel.allowed.lo[c],
                  pixel.allowed.hi[c]);
    std::printf(" %d surfaces\n", pixel.surfaces);
  }
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) try {
  const DriverRun* const run = argc == 4 ? find_driver_run(argv[1]) : nullptr;
  if (!run) {
    std::fprintf(stderr, "usage: draw_random llvmpipe|llvmpipe-precise|llvmpipe-sse4.1|softpipe FIRST END\n");
    return 2;
  }
  ClassCounts rgb8, floats;
  std::string driver;
  draw_seeds(
      *run, std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10),
      [&](std::uint64_t seed, const test::SeededScene& made, const DeviceProfile& profile, const GlFrame& frame) {
        driver = frame.driver.renderer + ", OpenGL " + frame.driver.version;
        const auto judge_as = [&](const char* format, const DeviceImage& image, ClassCounts& sums) {
          const Verdict verdict = judge(made.scene, image, profile, {});
          sums.add(verdict);
          report(seed, format, made.scene, verdict);
        };
        judge_as("8 bits", in_8_bits(frame), rgb8);
        judge_as("float", in_float(frame), floats);
      });
  std::printf("%s, %s\n", argv[1], driver.c_str());
  rgb8.print("8 bits");
  floats.print("float");
  return rgb8.scenes_unexplained + floats.scenes_unexplained == 0 ? 0 : 1;
} catch (const refraster::NoOpenGl& error) {
  std::printf("SKIPPED, not tested: %s\n", error.what());
  return 77;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 70;
}
