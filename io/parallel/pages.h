#pragma once
// Memory that will be written as a whole, taken from the system in one go.

#include "math/large_memory.h"

#include <cstddef>

namespace refraster {

/// Asks the system for all pages of memory that has been given but not touched yet, where it can: to be interrupted for
/// each of them costs more than to write it, in a virtual machine many times more. Advice, as advise_large_pages.
void advise_all_pages(void* memory, std::size_t bytes) noexcept;

/// list.reserve(size) for an empty list that will be filled.
template <class List>
void reserve_pages(List& list, std::size_t size) {
  list.reserve(size);
  advise_large_pages(list.data(), size * sizeof *list.data());
  advise_all_pages(list.data(), size * sizeof *list.data());
}

/// list.resize(size) for an empty list.
template <class List>
void resize_in_pages(List& list, std::size_t size) {
  reserve_pages(list, size);
  list.resize(size);
}

} // namespace refraster
