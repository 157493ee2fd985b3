#include "app/memory_limit.h"

#include "app/sanitizer.h"
#include "raster/parallel.h"

#include <charconv>
#include <cstdio>
#include <fstream>
#include <string>

#include <malloc.h>
#include <omp.h>
#include <sys/resource.h>
#include <unistd.h>

namespace refraster {
namespace {

constexpr std::uint64_t min_bytes = std::uint64_t{64} << 20; // the program and its libraries alone take half of it

std::uint64_t limit_bytes = 0; // of this process

struct InUse {
  std::uint64_t anonymous = 0; // resident bytes that belong to no file
  std::uint64_t files = 0;     // all of the program and its libraries, resident or not
  std::uint64_t data = 0;      // what RLIMIT_DATA counts
};

/// proc(5), /proc/PID/status.
InUse in_use() {
  InUse result;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    const auto add = [&](std::string_view name, std::uint64_t& sum) {
      if (line.starts_with(name)) sum += std::strtoull(line.c_str() + name.size(), nullptr, 10) * 1024;
    };
    add("RssAnon:", result.anonymous);
    add("VmExe:", result.files);
    add("VmLib:", result.files);
    add("VmData:", result.data);
  }
  return result;
}

std::uint64_t in_use_bytes() {
  malloc_trim(0); // what is freed is there to be taken again
  const InUse now = in_use();
  return now.anonymous + now.files;
}

} // namespace

std::optional<std::uint64_t> memory_from(std::string_view text) {
  std::uint64_t bytes = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, bytes);
  if (error != std::errc()) return std::nullopt;
  const std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  constexpr std::string_view units = "KMGT";
  if (unit.size() > 1) return std::nullopt;
  if (unit.size() == 1) {
    const std::size_t i = units.find(unit[0]);
    if (i == std::string_view::npos) return std::nullopt;
    const std::size_t shift = 10 * (i + 1);
    if (bytes > UINT64_MAX >> shift) return std::nullopt;
    bytes <<= shift;
  }
  if (bytes < min_bytes) return std::nullopt;
  return bytes;
}

MemoryBudget set_memory_limit(std::uint64_t bytes, int threads) {
  if (bytes == 0) return {};
  limit_bytes = bytes;
  MemoryBudget budget(bytes, in_use_bytes);
  if (threads == 0) threads = omp_get_num_procs();
  parallel_for(threads, static_cast<std::size_t>(threads), [](std::size_t, int) {});
  budget.need(1, "the program");
  if (built_with_sanitizer) return budget;
  const InUse now = in_use();
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return budget;
  // What counts as data but is not resident, as the stacks of threads, is not held against the run.
  const rlim_t wanted = now.data + (bytes - now.anonymous - now.files);
  if (limit.rlim_max == RLIM_INFINITY || wanted < limit.rlim_max) limit.rlim_cur = wanted;
  setrlimit(RLIMIT_DATA, &limit);
  return budget;
}

std::uint64_t memory_limit() {
  return limit_bytes;
}

void clear_memory_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_DATA, &limit);
}

} // namespace refraster
