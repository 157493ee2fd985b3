#pragma once
// The environment that a device's profile holds for.

#include "verify/device/device_profile.h"

namespace refraster {

/// Sets the variables that the profile names, for this process, so that its renderer draws as it says. Before the first
/// context: drivers read them once a process.
void enter_environment(const DeviceProfile& profile);

} // namespace refraster
