#pragma once
// The facts that probes found become a profile.

#include "gl/probe/device_facts.h"
#include "verify/device/device_profile.h"

#include <string>

namespace refraster {

/// The profile of the device that was probed: each measured number with a margin, which its source states with the
/// reason; what no probe measures is that of `gl-generic`.
DeviceProfile measured_profile(const DeviceFacts& facts, const std::string& name);

/// Whether the member, "group/member", is of a probe: its source begins with the probe's number, "P4: ".
bool is_measured(const DeviceProfile& profile, const std::string& place);

} // namespace refraster
