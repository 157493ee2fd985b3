#pragma once
// A build for another machine: its tests, and the programs that they start, run in an emulator.

#include <doctest/doctest.h>

#include <string>
#include <string_view>

namespace refraster::test {

/// Whether that is so here.
inline constexpr bool emulated = sizeof(REFRASTER_EMULATOR) > 1;

/// The same; where it is so, the test says that what follows is skipped, and why.
inline bool skipped_in_emulator(std::string_view why) {
  if (emulated) MESSAGE("SKIPPED in the emulator: " << std::string(why));
  return emulated;
}

/// Why nothing is said there of a program that is not installed.
inline constexpr std::string_view no_failure_of_spawn =
    "qemu makes a copy of the process, from which posix_spawn learns of no failure";

} // namespace refraster::test
