#pragma once
// Who has entries done by workers, and outlives whatever they end by.

#include "suite/entry/result.h"
#include "suite/workers/worker.h"

#include <atomic>
#include <functional>
#include <vector>

namespace refraster::suite {

struct Supervision {
  int jobs = 1;                   // workers at a time
  std::uint64_t memory_bytes = 0; // that all of them may take together; 0: no limit
  ProcessLimits limits;
  const std::atomic<bool>* stop = nullptr;       // when it becomes true, workers are ended and nothing is begun
  std::function<void(EntryResult result)> done;  // of each entry, once
  std::function<void(int process)> started = {}; // of each worker, before it does anything
};

enum class Supervised { all_done, stopped };

/// Does the entries at `order`, in this order as far as workers are free; one whose time is measured does so alone, at
/// the end. A worker that is over an entry's time or memory, or ends by itself, is reported as that entry's state, and
/// another takes its place. Never uses OpenMP. What `done` throws ends all workers and comes out.
Supervised supervise(const std::vector<Entry>& entries, const std::vector<std::size_t>& order,
                     const Workplace& workplace, const Supervision& how);

/// How many workers fit: as many as asked for, but not so many that one may take less than min_worker_bytes.
int jobs_within(int asked, std::uint64_t memory_bytes);

/// A worker with its libraries takes 40 MiB, an image of a million pixels with what is made of it, page included, 150.
inline constexpr std::uint64_t min_worker_bytes = std::uint64_t{256} << 20;

} // namespace refraster::suite
