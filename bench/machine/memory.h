#pragma once
// How much memory this process takes.

#include <cstdint>
#include <optional>

namespace refraster::bench {

/// From now on peak_memory_bytes() counts anew. What was freed is given back to the system first.
void restart_peak_memory();

/// The most memory that was resident at one time since then; nothing where the kernel does not let it be known.
std::optional<std::uint64_t> peak_memory_bytes();

} // namespace refraster::bench
