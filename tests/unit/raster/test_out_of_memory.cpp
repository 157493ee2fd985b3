// A frame that memory does not suffice for.

#include <refraster/render.h>

#include "app/sanitizer.h"
#include "tests/support/emulated.h"
#include "tests/support/scenes/hashed_scenes.h"
#include "tests/support/shading/merl_tables.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include <sys/resource.h>

namespace refraster::test {
namespace {

/// While it lives, the process can get no block as large as a table of floats.
class NoMoreMemory {
public:
  NoMoreMemory() {
    getrlimit(RLIMIT_DATA, &before_);
    rlimit now = before_;
    now.rlim_cur = data_bytes() + (std::uint64_t{4} << 20);
    setrlimit(RLIMIT_DATA, &now);
    // Such blocks that were freed before are still to be had.
    while (void* block = std::malloc(3 * MerlTable::samples * sizeof(float))) held_.emplace_back(block, std::free);
  }
  ~NoMoreMemory() { setrlimit(RLIMIT_DATA, &before_); }
  NoMoreMemory(const NoMoreMemory&) = delete;

private:
  /// What the limit counts: proc(5).
  static std::uint64_t data_bytes() {
    constexpr std::string_view name = "VmData:";
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
      if (line.starts_with(name)) return std::strtoull(line.c_str() + name.size(), nullptr, 10) * 1024;
    return 0;
  }

  rlimit before_{};
  std::vector<std::unique_ptr<void, decltype(&std::free)>> held_;
};

/// An image full of a measured surface, whose table in float is made while it is shaded.
Scene measured_scene() {
  Scene scene = hashed_scenes().front().scene;
  Merl function;
  function.table = table_of([](int, int, int) { return Rgb<double>(0.25); });
  for (Object& object : scene.objects) object.material.fragment_function = function;
  return scene;
}

} // namespace

TEST_CASE("a frame that memory does not suffice for throws, and the next one is whole" *
          doctest::skip(built_with_sanitizer)) {
  if (skipped_in_emulator("qemu heeds no limit of a process's memory, which is its own")) return;
  RenderOptions options;
  options.width = hashed_width, options.height = hashed_height;
  options.precision = Precision::float_;
  options.threads = 1;
  const Scene scene = measured_scene();
  Renderer renderer;
  Frame frame;
  {
    const NoMoreMemory limit;
    CHECK_THROWS_AS(renderer.render(scene, options, frame), std::bad_alloc);
  }
  renderer.render(scene, options, frame);
  CHECK(frame.rgb8.values == render(scene, options).rgb8.values);
}

} // namespace refraster::test
