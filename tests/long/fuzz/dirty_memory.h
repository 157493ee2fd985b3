#pragma once
// Memory as a reader may find it, so that what it leaves uninitialised shows.

#include <array>
#include <cstdint>
#include <cstring>

#include <malloc.h>

namespace refraster::fuzz {

/// Leaves `pattern` in 64 KiB of the stack below the caller, and lets malloc fill with it what it hands out (which a
/// build with the address sanitizer does not heed).
[[gnu::noinline]] inline void dirty_memory(std::uint8_t pattern) {
  mallopt(M_PERTURB, pattern);
  std::array<std::uint8_t, 65536> stack;
  std::memset(stack.data(), pattern, stack.size());
  asm volatile("" : : "r"(stack.data()) : "memory"); // nobody reads it, and yet it is written
}

} // namespace refraster::fuzz
