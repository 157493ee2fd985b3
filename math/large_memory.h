#pragma once
// Memory in large pages: <refraster/memory.h> has lists of its own; this is for those of others.

#include <cstddef>

namespace refraster {

/// Asks the system for pages of 2 MiB, where it has them, in memory that has been given but not touched yet. Advice:
/// nothing depends on it but time.
void advise_large_pages(void* memory, std::size_t bytes) noexcept;

/// list.resize(size) for an empty list, in large pages where it is large.
template <class List>
void resize_in_large_pages(List& list, std::size_t size) {
  list.reserve(size);
  advise_large_pages(list.data(), size * sizeof *list.data());
  list.resize(size);
}

} // namespace refraster
