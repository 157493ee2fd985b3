#include "suite/run/program.h"

#include <refraster/notes.h>

#include "gl/context/driver.h"
#include "gl/context/driver_environment.h"
#include "io/file/sha256.h"
#include "suite/workers/worker.h"
#include "verify/device/read_profile.h"

#include <algorithm>
#include <fstream>
#include <vector>

#include <link.h>
#include <unistd.h>

namespace refraster::suite {
namespace {

int add_library(dl_phdr_info* info, std::size_t, void* paths) {
  const std::string path = info->dlpi_name;
  if (path.find("librefraster") != std::string::npos) static_cast<std::vector<std::string>*>(paths)->push_back(path);
  return 0;
}

/// The number of kibibytes in a line of /proc/meminfo, proc(5).
std::uint64_t available_of_machine() {
  std::ifstream file("/proc/meminfo");
  for (std::string name, unit; file >> name;) {
    std::uint64_t kibibytes = 0;
    file >> kibibytes;
    std::getline(file, unit);
    if (name == "MemAvailable:") return kibibytes * 1024;
  }
  return 0;
}

/// What the group may take in all: control groups, version 2. 0: no limit that is seen from here.
std::uint64_t limit_of_group() {
  std::ifstream file("/sys/fs/cgroup/memory.max"); // "max" without one
  std::uint64_t bytes = 0;
  return file >> bytes ? bytes : 0;
}

} // namespace

std::string program_digest() {
  std::vector<std::string> paths = {"/proc/self/exe"};
  dl_iterate_phdr(add_library, &paths);
  std::sort(paths.begin() + 1, paths.end());
  std::string digests;
  for (const std::string& path : paths) digests += file_sha256(path);
  return paths.size() == 1 ? digests : text_sha256(digests);
}

std::uint64_t available_memory_bytes() {
  const std::uint64_t machine = available_of_machine(), group = limit_of_group();
  return machine == 0 || (group > 0 && group < machine) ? group : machine;
}

std::string driver_of(const std::string& device) {
  return made_by_child([&] {
    GlRenderer renderer = GlRenderer::system_default;
    if (!device.empty()) {
      const DeviceProfile profile = device_profile(device);
      enter_environment(profile.environment);
      renderer = profile.renderer;
    }
    const GlDriver driver = refraster::driver_of(renderer);
    std::string text;
    for (const std::string& words : {driver.vendor, driver.renderer, driver.version, driver.glsl_version})
      text += words + "\n";
    for (const std::string& variable : driver_variables(environ, {})) text += variable + "\n";
    return text;
  });
}

} // namespace refraster::suite
