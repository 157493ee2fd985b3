#include "bench/machine/memory.h"

#include <cstdlib>
#include <fstream>
#include <malloc.h>
#include <string>

namespace refraster::bench {
namespace {

bool restartable = false; // whether the kernel took the last order to count anew

} // namespace

void restart_peak_memory() {
  malloc_trim(0);
  // proc(5): "5" resets the peak resident set size to what is resident now.
  std::ofstream file("/proc/self/clear_refs");
  file << "5" << std::flush;
  restartable = file.good();
}

std::optional<std::uint64_t> peak_memory_bytes() {
  if (!restartable) return std::nullopt;
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("VmHWM:")) return std::strtoull(line.c_str() + 6, nullptr, 10) * 1024; // given in kB
  return std::nullopt;
}

} // namespace refraster::bench
