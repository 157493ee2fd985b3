#pragma once
// Memory in large pages: <refraster/memory.h> has lists of its own; this is for those of others.

#include <cstddef>

namespace refraster {

/// Asks the system for pages of 2 MiB, where it has them, in memory that has been given but not touched yet. Advice:
/// nothing depends on it but time.
void advise_large_pages(void* memory, std::size_t bytes) noexcept;

} // namespace refraster
