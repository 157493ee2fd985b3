#include <refraster/notes.h>

#include "tests/long/fuzz/memory.h"
#include "tests/long/fuzz/targets.h"

#include "verify/device/read_profile.h"
#include "verify/device/write_profile.h"

namespace refraster::fuzz {

void read_device_bytes(Bytes bytes) {
  const std::string path = file_of("device.json", bytes);
  const PeakMemory peak;
  try {
    const DeviceProfile profile = read_device_profile(path);
    for_each_member(profile, [](const std::string&, const auto& value, const Range& range, Wider, std::string_view) {
      if constexpr (std::is_same_v<decltype(value), const double&>)
        require(range.contains(value), "a member of an accepted profile is in its range");
    });
    const std::string written = device_profile_json(profile);
    require(device_profile_json(parse_device_profile("written.json", written)) == written,
            "a profile reads back as it was written");
  } catch (const InputError& error) {
    require(!error.faults().empty() && error.faults().size() <= 101, "a refusal has faults, and not thousands");
  }
  require_memory(peak, bytes.size(), 1 << 20, 100);
}

} // namespace refraster::fuzz
