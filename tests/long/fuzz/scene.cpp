#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/render_small.h"
#include "tests/long/fuzz/targets.h"

#include "tests/support/files/png_bytes.h"
#include "tests/support/invariants.h"

namespace refraster::fuzz {
namespace {

Bytes bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The files that seeds name, so that what is beyond a name is reached too.
void write_companions() {
  static const std::string mesh = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";
  static const std::string image = test::png_bytes(2, 3, 3, 8, std::vector<std::uint16_t>(18, 200));
  file_of("m.obj", bytes_of(mesh));
  file_of("t.png", bytes_of(image));
}

/// Fine shapes take long to make and to draw: a run that makes millions of them finds nothing.
constexpr std::int64_t budget_bytes = 1 << 23;
/// The budget is asked for what is large only. An object takes a kilobyte, and as little as three bytes to write.
constexpr std::int64_t bytes_a_byte = 512;

} // namespace

void read_scene_bytes(Bytes bytes) {
  static const bool companions = (write_companions(), true);
  require(companions, "companions are there");
  const std::string path = file_of("s.json", bytes);
  Scene scene;
  const PeakMemory peak;
  SceneOptions options;
  if (memory_is_counted())
    options.memory = MemoryBudget(budget_bytes, [] { return static_cast<std::uint64_t>(bytes_in_use()); });
  try {
    scene = read_scene(path, options);
  } catch (const InputError& error) {
    require(!error.faults().empty() && error.faults().size() <= 202, "a refusal has faults, not too many");
    require_memory(peak, bytes.size(), budget_bytes, bytes_a_byte);
    return;
  } catch (const OutOfMemory&) {
    require_memory(peak, bytes.size(), budget_bytes, bytes_a_byte);
    return;
  }
  require_memory(peak, bytes.size(), budget_bytes, bytes_a_byte);
  require_none(test::fault_of(scene), "an accepted scene");
  render_small(scene, bytes.size());
}

} // namespace refraster::fuzz
