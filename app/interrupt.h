#pragma once
// Ctrl-C.

#include <atomic>

namespace refraster {

/// From now on SIGINT and SIGTERM only set interrupted(): whoever works on something long looks at it, gives up, and
/// leaves no half-written file. A second signal ends the program at once.
void stop_gently_when_interrupted();

const std::atomic<bool>& interrupted();

} // namespace refraster
