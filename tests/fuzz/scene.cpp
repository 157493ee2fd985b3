#include "tests/fuzz/memory.h"
#include "tests/fuzz/render_small.h"
#include "tests/fuzz/targets.h"

#include "io/input_error.h"
#include "io/scene_file.h"
#include "tests/io/png_bytes.h"
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

/// Whether the text asks for a shape that takes long to make: a number above 99 after "segments" or "rings". Such
/// shapes are sound, but a run that makes millions of them finds nothing. (A key written with escapes gets by.)
bool asks_for_fine_shapes(std::string_view text) {
  for (const std::string_view key : {"segments", "rings"})
    for (std::size_t at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
      std::size_t digits = 0;
      for (std::size_t i = at + key.size(); i < text.size() && text[i] != ',' && text[i] != '}'; ++i) {
        if (text[i] == 'e' || text[i] == 'E') return true;
        if (text[i] >= '0' && text[i] <= '9' && ++digits > 2) return true;
      }
    }
  return false;
}

} // namespace

void read_scene_bytes(Bytes bytes) {
  if (asks_for_fine_shapes({reinterpret_cast<const char*>(bytes.data()), bytes.size()})) return;
  static const bool companions = (write_companions(), true);
  require(companions, "companions are there");
  const std::string path = file_of("s.json", bytes);
  Scene scene;
  const PeakMemory peak;
  try {
    scene = read_scene(path);
  } catch (const InputError& error) {
    require(!error.faults().empty() && error.faults().size() <= 202, "a refusal has faults, not too many");
    require_memory(peak, bytes.size(), 1 << 22, 2048);
    return;
  }
  require_memory(peak, bytes.size(), 1 << 22, 1 << 17); // a shape of 99 x 99 quads takes 40 bytes to name
  require_none(test::fault_of(scene), "an accepted scene");
  render_small(scene, bytes.size());
}

} // namespace refraster::fuzz
