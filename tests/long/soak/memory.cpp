// soak_memory [ROUNDS]: a thousand times, or ROUNDS, a multiple of 100, in one process and through the library, a scene
// is read, rendered and written, and the image read again. What is allocated after the last round is what was allocated
// after the same round of the first ones: not a byte more. Memory of the process that is not allocated may come and go;
// it must not grow by a page every few rounds either.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/support/files/malformed_inputs.h"
#include "tests/support/scenes/random_scene.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <malloc.h>
#include <unistd.h>

namespace {
using namespace refraster;

struct MemoryInUse {
  std::size_t allocated; // bytes, of all arenas and mappings
  std::size_t resident;  // pages
};

MemoryInUse memory_in_use() {
  const struct mallinfo2 info = mallinfo2();
  std::size_t size = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> size >> resident;
  return {info.uordblks + info.hblkhd, resident};
}

void round_of(int i, const test::TemporaryFolder& folder) {
  Random random(static_cast<std::uint64_t>(i % 20)); // twenty scenes, again and again
  RenderOptions options = test::random_options(random);
  options.threads = 2;
  render(test::random_scene(random), options);

  const Scene scene = read_scene(folder / "s.json");
  const Frame frame = render(scene, options);
  write_image(folder / "o.png", frame.rgb8);
  write_image(folder / "o.exr", frame.radiance);
  read_image(folder / "o.png");
  read_image(folder / "o.exr");
  try {
    read_scene(folder / "bad.json");
  } catch (const InputError&) {
    return;
  }
  std::printf("a bad scene was accepted\n");
}

} // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 1 ? std::atoi(argv[1]) : 1000, warm_up = rounds / 5; // which ends with the last scene, too
  const test::TemporaryFolder folder;
  test::write_files(folder.path, {{"s.json", test::scene_with("0.5 0.5 0.5", "1 1 1")},
                                  {"bad.json", test::scene_with("0.5 0.5 0.5", "one")}});
  MemoryInUse before{};
  for (int i = 0; i < rounds; ++i) {
    if (i == warm_up) before = memory_in_use();
    round_of(i, folder);
  }
  const MemoryInUse after = memory_in_use();
  std::printf("after %4d rounds: %9zu bytes allocated, %6zu pages resident\n", warm_up, before.allocated,
              before.resident);
  std::printf("after %4d rounds: %9zu bytes allocated, %6zu pages resident\n", rounds, after.allocated, after.resident);
  // A leak of half a page a round would be 400 pages in a thousand.
  const bool grew = after.allocated > before.allocated ||
                    after.resident > before.resident + static_cast<std::size_t>((rounds - warm_up) / 2);
  if (grew) std::printf("memory grows\n");
  return grew ? 1 : 0;
}
