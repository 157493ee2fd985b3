#pragma once
// Ctrl-C.

#include <atomic>
#include <string>

namespace refraster {

/// From now on SIGINT, SIGTERM and SIGHUP make interrupted() true: whoever works on something long looks at it and
/// gives up. What has not ended half a second later, or at a second signal, is ended with exit code 130: reading a
/// large file, compressing a large image, a driver. No half-written file is left. To be called before any thread is
/// started: they must not take the signals. Writing to a pipe that nobody reads, or beyond the limit of a file's size,
/// becomes an error of the write.
void stop_when_interrupted();

const std::atomic<bool>& interrupted();

/// Files that are written to this folder are removed too if they are not whole then.
void clean_when_interrupted(const std::string& folder);

} // namespace refraster
