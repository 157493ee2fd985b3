// Prints the table of docs/verification.md: verdict_table DEVICE WIDTHxHEIGHT SCENE...

#include <refraster/files.h>
#include <refraster/notes.h>

#include "gl/context/driver_environment.h"
#include "tests/support/gl/device_images.h"
#include "verify/device/read_profile.h"

#include <cstdio>
#include <filesystem>

using namespace refraster;

int main(int argc, char** argv) try {
  int width = 0, height = 0;
  if (argc < 4 || std::sscanf(argv[2], "%dx%d", &width, &height) != 2) {
    std::fprintf(stderr, "usage: verdict_table DEVICE WIDTHxHEIGHT SCENE...\n");
    return 2;
  }
  const DeviceProfile profile = device_profile(argv[1]);
  enter_environment(profile.environment);
  for (int i = 3; i < argc; ++i) {
    GlOptions options;
    options.width = width, options.height = height;
    options.renderer = profile.renderer;
    options.want_ids = options.want_depth = true;
    const Scene scene = read_scene(argv[i]);
    const GlFrame frame = render_gl(scene, options);
    if (i == 3) {
      std::printf("%s, OpenGL %s, %d x %d\n\n| scene |", frame.driver.renderer.c_str(), frame.driver.version.c_str(),
                  width, height);
      for (const auto& [value, name] : EnumNames<PixelClass>::names) std::printf(" %s |", std::string(name).c_str());
      std::printf(" < 0.1 | < 1 | < 4 | median |\n|---|");
      for (std::size_t k = 0; k < pixel_classes + 4; ++k) std::printf("---|");
      std::printf("\n");
    }
    const Verdict verdict = judge(scene, in_8_bits(frame), profile, {});
    std::printf("| %s |", std::filesystem::path(argv[i]).stem().c_str());
    for (const std::uint64_t count : verdict.counts) std::printf(" %llu |", static_cast<unsigned long long>(count));
    const JudgePower& power = verdict.power;
    std::printf(" %.0f %% | %.0f %% | %.0f %% | %.2g |\n", 100 * power.below_tenth, 100 * power.below_one,
                100 * power.below_four, power.median);
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
