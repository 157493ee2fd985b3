#pragma once
// Disks that cannot take what is written to them.

#include "tests/system/faults/fault_runs.h"

#include <vector>

namespace refraster {

/// A file system of 256 KiB, filled more and more; one that may only be read; a folder without write permission, as
/// another user; a limit of file sizes (ulimit -f). Nothing without the right to mount. Mounts are seen by this process
/// and its children only.
std::vector<FaultRow> bad_disks();

} // namespace refraster
