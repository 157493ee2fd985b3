// Random scenes through a driver, judged pixel by pixel: draw_random DRIVER FIRST END, for the seeds [FIRST, END). A
// line for each scene with pixels that are not explained, and the sums. Exit code 1 if there are any, 77 without the
// driver.

#include "tests/support/gl/driver_runs.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using namespace refraster;

struct Sums {
  std::uint64_t scenes = 0, pixels = 0, equal = 0, edge = 0, depth = 0, unexplained = 0, not_rounded = 0;
  std::uint64_t scenes_unexplained = 0;
};

void add(Sums& sums, const SideBySide& found) {
  const std::uint64_t unexplained = found.coverage_pixels + found.over_bound;
  ++sums.scenes;
  sums.pixels += found.pixels();
  sums.equal += found.equal;
  sums.edge += found.edge_pixels;
  sums.depth += found.depth_pixels;
  sums.unexplained += unexplained;
  sums.scenes_unexplained += unexplained > 0;
  sums.not_rounded += found.levels_not_rounded;
}

unsigned long long n(std::uint64_t count) {
  return count;
}

void report(std::uint64_t seed, const SideBySide& found) {
  if (found.coverage_pixels + found.over_bound + found.levels_not_rounded == 0) return;
  std::printf("seed %llu, %d x %d: %llu over the bound, %llu of another surface, %llu of 8 bits not rounded\n", n(seed),
              found.width, found.height, n(found.over_bound), n(found.coverage_pixels), n(found.levels_not_rounded));
  for (std::size_t i = 0; i < std::min<std::size_t>(found.unexplained.size(), 3); ++i) {
    const WorstPixel& p = found.unexplained[i];
    std::printf("  (%d, %d) %s, %s: ours %.7g %.7g %.7g, gl %.7g %.7g %.7g, allowed %.3g %.3g %.3g\n", p.x, p.y,
                p.object.c_str(), p.cause.c_str(), static_cast<double>(p.ours.x), static_cast<double>(p.ours.y),
                static_cast<double>(p.ours.z), static_cast<double>(p.gl.x), static_cast<double>(p.gl.y),
                static_cast<double>(p.gl.z), p.allowed.x, p.allowed.y, p.allowed.z);
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
  const DriverTolerances& tolerances =
      std::find_if(std::begin(driver_profiles), std::end(driver_profiles), [&](const DriverProfile& listed) {
        return listed.name == run->profile;
      })->tolerances;
  Sums sums;
  std::string driver;
  draw_seeds(*run, std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[3], nullptr, 10),
             [&](std::uint64_t seed, const test::SeededScene& made, const OtherImages& images) {
               const SideBySide found = side_by_side(made.scene, images, tolerances);
               driver = found.driver;
               add(sums, found);
               report(seed, found);
             });
  std::printf("%s, %s: %llu scenes, %llu pixels, %llu equal, %llu edge, %llu depth, %llu unexplained in %llu scenes, "
              "%llu of 8 bits not rounded\n",
              argv[1], driver.c_str(), n(sums.scenes), n(sums.pixels), n(sums.equal), n(sums.edge), n(sums.depth),
              n(sums.unexplained), n(sums.scenes_unexplained), n(sums.not_rounded));
  return sums.unexplained + sums.not_rounded == 0 ? 0 : 1;
} catch (const refraster::NoOpenGl& error) {
  std::printf("SKIPPED, not tested: %s\n", error.what());
  return 77;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 70;
}
