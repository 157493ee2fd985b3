#include "math/large_memory.h"

#include <refraster/memory.h>

#include <cstdint>
#include <cstdlib>

#include <sys/mman.h>

namespace refraster {

namespace {

constexpr std::size_t page = std::size_t{1} << 21; // a large one, of x86-64

} // namespace

void advise_large_pages(void* memory, std::size_t bytes) noexcept {
  const auto begin = reinterpret_cast<std::uintptr_t>(memory), first = (begin + page - 1) / page * page;
  if (bytes < 2 * page) return; // one large page may not even fit between the borders of two
  madvise(reinterpret_cast<void*>(first), (begin + bytes - first) / page * page, MADV_HUGEPAGE);
}

void* allocate_memory(std::size_t bytes) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()) - page;
  const bool large = bytes >= page && bytes <= most;
  const std::size_t whole = large ? (bytes + page - 1) / page * page : bytes;
  void* const memory = large ? std::aligned_alloc(page, whole) : std::malloc(bytes);
  if (!memory) throw std::bad_alloc();
  // Advice: a system without large pages takes it or leaves it, and nothing depends on it but time.
  if (large) madvise(memory, whole, MADV_HUGEPAGE);
  return memory;
}

void free_memory(void* memory) noexcept {
  std::free(memory);
}

} // namespace refraster
