#pragma once
// Memory for big tables. From 2 MiB on it is asked for in pages of 2 MiB instead of 4 KiB: a table of 35 MB is there
// after 17 page faults instead of 8500, which take as long as reading its file does.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace refraster {

inline constexpr std::size_t large_page_bytes = std::size_t{1} << 21; // of x86-64

/// At least so many bytes, aligned to 16, or to a large page if there are as many. To be given back with free_memory.
inline void* allocate_memory(std::size_t bytes) {
  const bool large = bytes >= large_page_bytes && bytes <= PTRDIFF_MAX - large_page_bytes;
  const std::size_t whole = large ? (bytes + large_page_bytes - 1) / large_page_bytes * large_page_bytes : bytes;
  void* const memory = large ? std::aligned_alloc(large_page_bytes, whole) : std::malloc(bytes);
  if (!memory) throw std::bad_alloc();
  // Advice: a system without large pages takes it or leaves it, and nothing depends on it but time.
  if (large) madvise(memory, whole, MADV_HUGEPAGE);
  return memory;
}
inline void free_memory(void* memory) {
  std::free(memory);
}

} // namespace refraster
