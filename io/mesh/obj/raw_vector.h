#pragma once
// Lists of millions of numbers, written by several threads.

#include <refraster/memory.h>

#include "io/parallel/pages.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace refraster {

/// Elements that resize() adds are not cleared: who asks for them writes each before it is read, and so each page is
/// first touched by the thread that works on it. Large lists lie in large pages: see allocate_memory.
template <class T>
struct UninitializedAllocator {
  using value_type = T;
  static constexpr std::size_t large_page_bytes = std::size_t{1} << 21; // those of more are few, and each thread's own

  UninitializedAllocator() = default;
  template <class U>
  UninitializedAllocator(const UninitializedAllocator<U>&) {}

  T* allocate(std::size_t n) {
    if (n > static_cast<std::size_t>(PTRDIFF_MAX) / sizeof(T)) throw std::bad_alloc();
    void* const memory = allocate_memory(n * sizeof(T));
    if (n * sizeof(T) < large_page_bytes) advise_all_pages(memory, n * sizeof(T));
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t) { free_memory(memory); }

  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }

  template <class U>
  bool operator==(const UninitializedAllocator<U>&) const {
    return true;
  }
};

template <class T>
using RawVector = std::vector<T, UninitializedAllocator<T>>;

} // namespace refraster
