#pragma once
// What the shipped device profiles say, for docs/devices.md.

#include <string>

namespace refraster {

/// Tables: the profiles, their values side by side, and where each number is from.
std::string device_profiles_markdown();

} // namespace refraster
