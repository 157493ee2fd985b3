#include "verify/device/profile_order.h"

#include <variant>

namespace refraster {
namespace {

using MemberValue = std::variant<double, SetupPositions, FillRule, InterpolationAnchor, DepthFormat>;

std::map<std::string, MemberValue> member_values(const DeviceProfile& profile) {
  std::map<std::string, MemberValue> values;
  for_each_member(profile, [&](const std::string& place, const auto& value, const Range&, Wider, std::string_view) {
    values.emplace(place, value);
  });
  return values;
}

} // namespace

std::vector<std::string> members_beyond(const DeviceProfile& inner, const DeviceProfile& outer) {
  const std::map<std::string, MemberValue> of_outer = member_values(outer);
  std::vector<std::string> beyond;
  for_each_member(
      inner, [&]<class Value>(const std::string& place, const Value& a, const Range&, Wider wider, std::string_view) {
        const Value& b = std::get<std::remove_const_t<Value>>(of_outer.at(place));
        bool within;
        if constexpr (!std::is_same_v<Value, double>) within = allows_no_more(a, b);
        else if (wider == Wider::times_relative)
          within = a * inner.operations.relative <= b * outer.operations.relative;
        else within = wider == Wider::above ? a <= b : a >= b;
        if (!within) beyond.push_back(place);
      });
  return beyond;
}

} // namespace refraster
