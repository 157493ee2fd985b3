#pragma once
// Which of two device profiles allows more.

#include "verify/device/device_profile.h"

#include <string>
#include <vector>

namespace refraster {

/// The members, as "group/member", by which `inner` allows a device something that `outer` does not. Empty: what is
/// right by `inner` is right by `outer`.
std::vector<std::string> members_beyond(const DeviceProfile& inner, const DeviceProfile& outer);

} // namespace refraster
