#pragma once
// An entry, done.

#include "suite/actions/workplace.h"
#include "suite/entry/result.h"

#include <optional>
#include <string>

namespace refraster::suite {

/// Does it. Total: whatever goes wrong is the state of the result, not an exception. With the files that it depends on,
/// and their digests; without, where one of them has changed while it was done.
EntryResult run_entry(const Entry& entry, const Workplace& workplace);

/// sha256 of all that decides an entry's result beside files: what it asks for, what is recorded of its reference, the
/// program, OpenGL's driver.
std::string settings_of(const Entry& entry, const Workplace& workplace);

/// What is known of an entry before it is done: for those that a worker did not live to do.
EntryResult unfinished(const Entry& entry, State state, std::string message);

} // namespace refraster::suite
