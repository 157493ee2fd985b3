#pragma once
// A build for another machine: its tests, and the programs that they start, run in an emulator.

#include <doctest/doctest.h>

namespace refraster::test {

/// Whether that is so here.
inline constexpr bool emulated = sizeof(REFRASTER_EMULATOR) > 1;

/// The same; where it is so, the test says that what follows is skipped, and why.
inline bool skipped_in_emulator(const char* why) {
  if (emulated) MESSAGE("SKIPPED in the emulator: " << why);
  return emulated;
}

} // namespace refraster::test
