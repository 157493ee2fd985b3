#include "bench/machine/machine.h"

#include "bench/machine/clocks.h"
#include "bench/machine/cpus.h"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <sys/utsname.h>
#include <unistd.h>

// CMakeLists.txt gives these to this file.
#if !defined(REFRASTER_FLAGS) || !defined(REFRASTER_REVISION)
#error "bench/CMakeLists.txt must define REFRASTER_FLAGS and REFRASTER_REVISION for this file"
#endif

namespace refraster::bench {
namespace {

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

/// The value of the first line "name : value" of /proc/cpuinfo.
std::string cpuinfo(const std::string& name) {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(name)) continue;
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos) continue;
    const std::size_t value = line.find_first_not_of(" \t", colon + 1);
    return value == std::string::npos ? "" : line.substr(value);
  }
  return {};
}

std::vector<std::string> caches() {
  std::vector<std::string> all;
  for (int i = 0;; ++i) {
    const std::string folder = "/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(i) + "/";
    const std::string level = first_line(folder + "level"), size = first_line(folder + "size");
    std::string type = first_line(folder + "type");
    if (level.empty()) break;
    type = type == "Unified" ? "" : type == "Data" ? " data" : " instructions";
    all.push_back("L" + level + type + " " + size);
  }
  return all;
}

} // namespace

Machine this_machine() {
  Machine machine;
  machine.cpu = cpuinfo("model name");
  machine.cpus = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
  machine.usable_cpus = usable_cpus();
  machine.caches = caches();
  const std::string flags = " " + cpuinfo("flags") + " ";
  if (flags.size() > 2) machine.virtualized = flags.find(" hypervisor ") != std::string::npos ? "yes" : "no";
  machine.memory_bytes =
      static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  utsname system{};
  if (uname(&system) == 0) machine.kernel = std::string(system.sysname) + " " + system.release;
  machine.governor = first_line("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
  machine.time_stamp_ghz = time_stamp_ghz();
  return machine;
}

std::array<double, 3> load_average() {
  std::array<double, 3> load{};
  if (getloadavg(load.data(), 3) != 3) load = {};
  return load;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32] = {};
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

Origin this_origin() {
  return {REFRASTER_FLAGS, REFRASTER_REVISION};
}

} // namespace refraster::bench
