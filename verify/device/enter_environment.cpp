#include "verify/device/enter_environment.h"

#include <cstdlib>

namespace refraster {

void enter_environment(const DeviceProfile& profile) {
  for (const auto& [name, value] : profile.environment) setenv(name.c_str(), value.c_str(), 1);
}

} // namespace refraster
