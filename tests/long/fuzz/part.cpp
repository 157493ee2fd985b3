#include <refraster/notes.h>

#include "io/parts/image_part.h"
#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include <vector>

namespace refraster::fuzz {

void read_part_bytes(Bytes bytes) {
  const std::string path = file_of("a.png.part-1-of-2", bytes);
  const PeakMemory peak;
  try {
    const ImagePart part(path);
    const PartHeader& header = part.header();
    require(header.width > 0 && header.height > 0, "a size has pixels");
    require(header.shard.part >= 1 && header.shard.part <= header.shard.of, "a part is one of its number");
    require(!header.images.empty(), "there is an image");
    part.check_values();
  } catch (const InputError& error) {
    require(!error.faults().empty(), "a refusal has faults");
  }
  // A row of an image, which the file need not hold if it has no rows.
  require_memory(peak, bytes.size(), 1 << 23, 100);
}

} // namespace refraster::fuzz
