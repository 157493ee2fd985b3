#pragma once
// The program and its machine, as far as a suite depends on them.

#include <cstdint>
#include <string>

namespace refraster::suite {

/// sha256 of this program, and of those libraries of its own that it has loaded: another build may draw otherwise.
std::string program_digest();

/// What processes may still take: of the machine, or of the group of processes that this one is confined to. 0 if
/// neither says.
std::uint64_t available_memory_bytes();

/// What OpenGL says of itself where it is driven as this profile says, or as the system has it for an empty name; empty
/// where there is none. Asked by a process of its own.
std::string driver_of(const std::string& device);

} // namespace refraster::suite
