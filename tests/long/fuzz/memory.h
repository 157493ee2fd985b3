#pragma once
// How much memory a call takes.

#include <cstddef>
#include <cstdint>

namespace refraster::fuzz {

/// Whether this build can tell: those with the address sanitizer do.
bool memory_is_counted();

/// From its construction on, the most bytes that were allocated at one time beyond those at the start, by new, malloc
/// and their kin, in all threads. One at a time.
class PeakMemory {
public:
  PeakMemory();
  std::int64_t bytes() const;
};

/// Allocated since the last PeakMemory was made, and not freed.
std::int64_t bytes_in_use();

/// Ends the process if a reader took more than `fixed` bytes and `per_byte` for each byte of its input: the multiples
/// of docs/limits.md.
void require_memory(const PeakMemory& peak, std::size_t input_bytes, std::int64_t fixed, std::int64_t per_byte);

} // namespace refraster::fuzz
