#pragma once
// Tables that are read four numbers at a time, wherever one is wanted: the last ones too.

#include "math/large_memory.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace refraster {

/// Asks for the room of four more elements than it is told to: they may be read, whatever is in them, never written.
template <class T>
struct PaddedAllocator {
  using value_type = T;
  static constexpr std::size_t padding = 4 * sizeof(T);

  PaddedAllocator() = default;
  template <class U>
  PaddedAllocator(const PaddedAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n > PTRDIFF_MAX / sizeof(T) - 4) throw std::bad_alloc();
    return static_cast<T*>(allocate_memory(n * sizeof(T) + padding));
  }
  void deallocate(T* memory, std::size_t) { free_memory(memory); }
  template <class U>
  bool operator==(const PaddedAllocator<U>&) const {
    return true;
  }
};

/// A std::vector of which a row of four may be loaded from the place of any of its elements.
template <class T>
using PaddedVector = std::vector<T, PaddedAllocator<T>>;

} // namespace refraster
