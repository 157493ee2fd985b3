#pragma once
// Device profiles as JSON.

#include "io/json/json_writer.h"
#include "verify/device/device_profile.h"

#include <string>

namespace refraster {

/// The whole profile, as an object that read_device_profile() reads back as the same.
void write_device_profile(JsonWriter& json, const DeviceProfile& profile);

/// The same as a file.
std::string device_profile_json(const DeviceProfile& profile);

} // namespace refraster
