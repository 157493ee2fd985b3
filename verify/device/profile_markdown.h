#pragma once
// What the shipped device profiles say, for docs/devices.md.

#include "verify/device/device_profile.h"

#include <string>

namespace refraster {

/// Tables: the profiles, their values side by side, and where each number is from.
std::string device_profiles_markdown();

/// A table of what was measured, with its margin, beside what another profile says.
std::string measured_markdown(const DeviceProfile& measured, const DeviceProfile& other);

} // namespace refraster
