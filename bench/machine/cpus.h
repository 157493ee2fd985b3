#pragma once
// Which processor runs which thread. Left alone, the kernel often puts two threads of a short run on one CPU.

#include <span>
#include <vector>

namespace refraster::bench {

/// The CPUs that this thread may use, by the kernel's numbers, in rising order.
std::vector<int> usable_cpus();

/// Lets the calling thread, and threads that it starts from now on, run on these CPUs only.
void stay_on(std::span<const int> cpus);

/// Holds OpenMP's threads to CPUs while it lives; then the calling thread may run where it could before.
class PinnedThreadPool {
public:
  PinnedThreadPool() : cpus_(usable_cpus()) {}
  ~PinnedThreadPool() { stay_on(cpus_); }
  PinnedThreadPool(const PinnedThreadPool&) = delete;
  PinnedThreadPool& operator=(const PinnedThreadPool&) = delete;

  /// Thread i of the next teams of this size runs on usable CPU number i, counted round where there are fewer. To be
  /// called whenever the size changes: a team that grows is made of new threads.
  void pin(int threads) const;

  std::span<const int> cpus() const { return cpus_; }

private:
  std::vector<int> cpus_;
};

} // namespace refraster::bench
