#pragma once
// --max-memory.

#include <refraster/memory.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace refraster {

/// "512M", "2G", or bytes: K, M, G and T are 1024, 1024² and so on. At least 64M.
std::optional<std::uint64_t> memory_from(std::string_view text);

/// What the process may take from now on, all that it has already included: what is resident of the program, its
/// libraries and its data. 0: as much as there is. What is large is asked for before it is made (MemoryBudget). And the
/// kernel is told to give the process no more private memory than that (RLIMIT_DATA): whatever was not asked for ends
/// in std::bad_alloc. To be called once. threads: as many as will be used, 0 for all; started here, for their stacks
/// are memory that is hardly touched.
MemoryBudget set_memory_limit(std::uint64_t bytes, int threads);

/// The limit that set_memory_limit has set; 0 without one.
std::uint64_t memory_limit();

/// Undoes the kernel's part of it, in a child process whose libraries do not bear it.
void clear_memory_limit();

} // namespace refraster
