#pragma once
// Device profiles from files, and those that the program has.

#include "verify/device/device_profile.h"

#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Reads a profile of this form, docs/devices.md:
///     {"name": "mine", "version": 1, "meaning": "…", "based_on": "gl-generic", "raster": {"lattice": 0.00390625}, …}
/// With "based_on", the name of a shipped profile, every other key but the name may be left out and is then that
/// profile's; without, every member of every group is needed. Throws InputError with all faults.
DeviceProfile read_device_profile(const std::string& path);

/// The same of a text; `file` names it in messages.
DeviceProfile parse_device_profile(const std::string& file, const std::string& text);

/// The shipped profile of this name, or the one in this file. Throws InputError.
DeviceProfile device_profile(const std::string& name_or_path);

/// The names of those that are shipped, the widest first.
std::vector<std::string_view> device_profile_names();

} // namespace refraster
