#include "tests/long/fuzz/memory.h"

#include "tests/long/fuzz/targets.h"

#include <atomic>
#include <string>

#if defined(__SANITIZE_ADDRESS__)
#define REFRASTER_COUNTS_MEMORY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define REFRASTER_COUNTS_MEMORY
#endif
#endif

#ifdef REFRASTER_COUNTS_MEMORY
#include <sanitizer/allocator_interface.h>
#endif

namespace refraster::fuzz {
namespace {

std::atomic<std::int64_t> now{0}, most{0};

#ifdef REFRASTER_COUNTS_MEMORY
void allocated(const volatile void*, std::size_t size) {
  const std::int64_t sum = now += static_cast<std::int64_t>(size);
  std::int64_t before = most;
  while (sum > before && !most.compare_exchange_weak(before, sum)) {
  }
}
void freed(const volatile void* memory) {
  if (memory) now -= static_cast<std::int64_t>(__sanitizer_get_allocated_size(memory));
}
const int installed = __sanitizer_install_malloc_and_free_hooks(allocated, freed);
#endif

} // namespace

bool memory_is_counted() {
#ifdef REFRASTER_COUNTS_MEMORY
  return installed > 0;
#else
  return false;
#endif
}

PeakMemory::PeakMemory() {
  now = 0;
  most = 0;
}

std::int64_t bytes_in_use() {
  return now;
}

std::int64_t PeakMemory::bytes() const {
  return most;
}

void require_memory(const PeakMemory& peak, std::size_t input_bytes, std::int64_t fixed, std::int64_t per_byte) {
  const std::int64_t allowed = fixed + per_byte * static_cast<std::int64_t>(input_bytes);
  require(peak.bytes() <= allowed, "memory is bounded: " + std::to_string(input_bytes) + " bytes took " +
                                       std::to_string(peak.bytes()) + ", allowed are " + std::to_string(allowed));
}

} // namespace refraster::fuzz
