#include <refraster/notes.h>

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include "verify/compare/limits_file.h"

namespace refraster::fuzz {

void read_limits_bytes(Bytes bytes) {
  const std::string path = file_of("limits.json", bytes);
  const PeakMemory peak;
  try {
    const CompareLimits limits = read_limits(path);
    for (const auto& limit : {limits.max_abs, limits.max_rms})
      require(!limit || *limit >= 0, "an accepted limit is a number >= 0");
  } catch (const InputError& error) {
    require(!error.faults().empty(), "a refusal has faults");
  }
  require_memory(peak, bytes.size(), 1 << 17, 75);
}

} // namespace refraster::fuzz
