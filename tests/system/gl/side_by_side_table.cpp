// Prints the table of docs/verification.md: side_by_side_table PROFILE WIDTHxHEIGHT SCENE...

#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/support/gl/side_by_side.h"

#include <cstdio>
#include <filesystem>

namespace {

using namespace refraster;

void print_head(const std::string& driver, int width, int height) {
  std::printf(
      "%s, %d x %d\n\n"
      "| scene | equal | off by 1 | off by more | edge (farthest) | depth | unexplained | worst pixel | worst of "
      "the same surface | largest fraction of the bound |\n|---|---|---|---|---|---|---|---|---|---|\n",
      driver.c_str(), width, height);
}

void print(const std::string& scene, const SideBySide& s) {
  const auto pixel = [](const WorstPixel& p) {
    if (p.difference == 0) return std::string("none");
    char text[200];
    std::snprintf(text, sizeof text, "(%d, %d) %s: %.3g, %s", p.x, p.y, p.object.c_str(), p.difference,
                  p.cause.c_str());
    return std::string(text);
  };
  const auto n = [](std::uint64_t count) { return static_cast<unsigned long long>(count); };
  std::printf("| %s | %llu | %llu | %llu | %llu (%.2g) | %llu | %llu | %s | %s | %.2f |\n", scene.c_str(), n(s.equal),
              n(s.off_by_one), n(s.off_by_more), n(s.edge_pixels), s.farthest_edge * 256, n(s.depth_pixels),
              n(s.coverage_pixels + s.over_bound), pixel(s.worst).c_str(),
              s.worst.difference > s.worst_same.difference ? pixel(s.worst_same).c_str() : "the same",
              s.worst_fraction_of_bound);
  for (const WorstPixel& p : s.unexplained)
    std::fprintf(stderr, "%s: (%d, %d) %s, %s: %g levels; ours %g %g %g, gl %g %g %g, allowed %g %g %g\n",
                 scene.c_str(), p.x, p.y, p.object.c_str(), p.cause.c_str(), p.difference,
                 static_cast<double>(p.ours.x), static_cast<double>(p.ours.y), static_cast<double>(p.ours.z),
                 static_cast<double>(p.gl.x), static_cast<double>(p.gl.y), static_cast<double>(p.gl.z), p.allowed.x,
                 p.allowed.y, p.allowed.z);
  std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) try {
  const DriverProfile* profile = nullptr;
  for (const DriverProfile& listed : driver_profiles)
    if (argc > 1 && listed.name == argv[1]) profile = &listed;
  int width = 0, height = 0;
  if (argc < 4 || !profile || std::sscanf(argv[2], "%dx%d", &width, &height) != 2) {
    std::fprintf(stderr, "usage: side_by_side_table llvmpipe|llvmpipe-precise|softpipe WIDTHxHEIGHT SCENE...\n");
    return 2;
  }
  for (int i = 3; i < argc; ++i) {
    const SideBySide found = side_by_side(read_scene(argv[i]), width, height, *profile);
    if (i == 3) print_head(found.driver, width, height);
    print(std::filesystem::path(argv[i]).stem(), found);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
