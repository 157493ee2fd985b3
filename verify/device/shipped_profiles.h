#pragma once
// The profiles of verify/device/profiles, compiled into the program.

#include <span>
#include <string_view>

namespace refraster {

struct ShippedProfile {
  std::string_view name, json;
};

/// In the order of verify/CMakeLists.txt: the widest first.
std::span<const ShippedProfile> shipped_profiles();

} // namespace refraster
