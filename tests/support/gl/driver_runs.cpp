#include "tests/support/gl/driver_runs.h"

#include "verify/device/read_profile.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string>

namespace refraster {

const DriverRun* find_driver_run(std::string_view name) {
  const auto* const found = std::find_if(std::begin(driver_runs), std::end(driver_runs),
                                         [&](const DriverRun& run) { return run.name == name; });
  return found == std::end(driver_runs) ? nullptr : found;
}

DeviceProfile enter(const DriverRun& run) {
  DeviceProfile profile = device_profile(std::string(run.profile));
  for (const auto& [name, value] : profile.environment) setenv(name.c_str(), value.c_str(), 1);
  for (const Setting& setting : run.further)
    if (setting.name) setenv(setting.name, setting.value, 1);
  return profile;
}

GlFrame drawn(const test::SeededScene& made, const DeviceProfile& profile) {
  GlOptions options;
  options.width = made.width, options.height = made.height;
  options.renderer = profile.renderer;
  options.want_radiance = options.want_depth = options.want_ids = true;
  return render_gl(made.scene, options);
}

} // namespace refraster
