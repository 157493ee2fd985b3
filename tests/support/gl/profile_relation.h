#pragma once
// How a shipped profile stands to what probes find of its device.

#include "verify/device/measured_profile.h"
#include "verify/device/profile_order.h"

#include <algorithm>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace refraster {

/// How many members probes measure: all but the guard band, what mip levels are made with, and the depth buffer.
inline constexpr int measured_members = 24;

/// What is wrong with the relation, a line a member: a number that is measured is no more than the shipped one, and at
/// least half of it; a choice, or an exponent, is the same.
inline std::vector<std::string> relation_faults(const DeviceProfile& measured, const DeviceProfile& shipped) {
  std::map<std::string, std::variant<double, SetupPositions, FillRule, InterpolationAnchor, DepthFormat>> says;
  for_each_member(shipped, [&](const std::string& place, const auto& value, const Range&, Wider, std::string_view) {
    says[place] = value;
  });
  std::vector<std::string> faults;
  int compared = 0;
  for_each_member(
      measured, [&]<class Value>(const std::string& place, const Value& found, const Range&, Wider, std::string_view) {
        if (!is_measured(measured, place)) return;
        ++compared;
        const auto& said = std::get<Value>(says.at(place));
        if constexpr (!std::is_same_v<Value, double>) {
          if (found != said) faults.push_back(place + " is another");
        } else {
          if (place == "operations/cut_off" && found != said) faults.push_back(place + " is another");
          if (found > said) faults.push_back(place + " is more than the profile says");
          if (std::abs(found) < std::abs(said) / 2)
            faults.push_back(place + " is less than half of what the profile says");
        }
      });
  if (compared != measured_members) faults.push_back(std::to_string(compared) + " members were measured");
  return faults;
}

} // namespace refraster
