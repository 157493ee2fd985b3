#include "verify/compare/limits_file.h"

#include "io/file/input_file.h"
#include "io/file/nearest.h"
#include "io/json/json.h"
#include "verify/compare/compare.h"

#include <cmath>

namespace refraster {

CompareLimits read_limits(const std::string& path, CompareUnit unit) {
  const JsonDocument document(path, read_file(path, "a JSON file of limits", JsonDocument::max_bytes));
  const JsonNode& root = document[0];
  if (root.kind != JsonKind::object)
    throw InputError(
        document.fault_at(root.begin, "", document.describe(root), "an object with max_abs, max_rms, max_count, unit"));
  CompareLimits limits;
  std::optional<CompareUnit> unit_of_file;
  std::vector<InputFault> faults;
  for (JsonIndex i = root.first_child; i != 0; i = document[i].next) {
    const JsonNode& member = document[i];
    const std::string place = std::string("/").append(member.key);
    const bool is_count = member.key == "max_count", is_unit = member.key == "unit";
    if (!is_count && !is_unit && member.key != "max_abs" && member.key != "max_rms") {
      faults.push_back(document.fault_at(member.key_begin, place, "an unknown key",
                                         one_of({"max_abs", "max_rms", "max_count", "unit"}, member.key)));
      continue;
    }
    const bool again = is_unit    ? unit_of_file.has_value()
                       : is_count ? limits.max_count.has_value()
                                  : (member.key == "max_abs" ? limits.max_abs : limits.max_rms).has_value();
    if (again) {
      faults.push_back(document.fault_at(member.key_begin, place, "the key a second time", "each key once"));
      continue;
    }
    if (is_unit) {
      for (const CompareUnit known : {CompareUnit::levels, CompareUnit::values})
        if (member.kind == JsonKind::string && member.string == unit_name(known)) unit_of_file = known;
      if (!unit_of_file)
        faults.push_back(document.fault_at(member.begin, place, document.describe(member), "\"levels\" or \"values\""));
      continue;
    }
    // Above 2^53 a double is no count any more, and no image has as many pixels.
    const bool good = member.kind == JsonKind::number && member.number >= 0 &&
                      (!is_count || (std::floor(member.number) == member.number && member.number <= 0x1p53));
    if (!good) {
      faults.push_back(document.fault_at(member.begin, place, document.describe(member),
                                         is_count ? "a whole number >= 0" : "a number >= 0"));
      continue;
    }
    if (is_count) limits.max_count = static_cast<std::uint64_t>(member.number);
    else (member.key == "max_abs" ? limits.max_abs : limits.max_rms) = member.number;
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return converted(limits, unit_of_file.value_or(CompareUnit::levels), unit);
}

} // namespace refraster
