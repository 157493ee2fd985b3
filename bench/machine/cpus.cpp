#include "bench/machine/cpus.h"

#include <omp.h>
#include <sched.h>

namespace refraster::bench {

std::vector<int> usable_cpus() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> cpus;
  if (sched_getaffinity(0, sizeof set, &set) == 0)
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
      if (CPU_ISSET(cpu, &set)) cpus.push_back(cpu);
  if (cpus.empty()) cpus.push_back(0);
  return cpus;
}

void stay_on(std::span<const int> cpus) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int cpu : cpus) CPU_SET(cpu, &set);
  sched_setaffinity(0, sizeof set, &set); // where it is not allowed, threads stay where they are
}

void PinnedThreadPool::pin(int threads) const {
  // OpenMP keeps its threads from one region to the next of the same size (OpenMP 5.0, section 2.6).
#pragma omp parallel num_threads(threads)
  {
    const auto i = static_cast<std::size_t>(omp_get_thread_num());
    stay_on(std::span(&cpus_[i % cpus_.size()], 1));
  }
}

} // namespace refraster::bench
