#include "io/parallel/pages.h"

#include <cstdint>

#include <sys/mman.h>

namespace refraster {

void advise_all_pages(void* memory, std::size_t bytes) noexcept {
#ifdef MADV_POPULATE_WRITE
  // Of x86-64; where pages are larger, an address that begins none is refused, which is as good as no advice.
  constexpr std::size_t page = 4096;
  constexpr std::size_t min_bytes = 32 * page; // less is not worth a call
  if (bytes < min_bytes) return;
  const auto begin = reinterpret_cast<std::uintptr_t>(memory) / page * page;
  const auto end = (reinterpret_cast<std::uintptr_t>(memory) + bytes) / page * page;
  madvise(reinterpret_cast<void*>(begin), end - begin, MADV_POPULATE_WRITE);
#else
  static_cast<void>(memory), static_cast<void>(bytes);
#endif
}

} // namespace refraster
