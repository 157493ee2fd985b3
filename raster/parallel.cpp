#include "raster/parallel.h"

#include "raster/processor_time.h"

#include <atomic>
#include <exception>
#include <optional>

#include <omp.h>

namespace refraster {
namespace {

thread_local ProcessorTime* current_time = nullptr;

} // namespace

ProcessorTime::ProcessorTime() : before_(current_time) {
  current_time = this;
}
ProcessorTime::~ProcessorTime() {
  current_time = before_;
}
ProcessorTime* ProcessorTime::current() {
  return current_time;
}

void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t index, int thread)>& body) {
  // Indices are given out here and not by `omp for`, out of which no exception may come.
  std::atomic<std::size_t> next{0};
  std::exception_ptr thrown;
  ProcessorTime* const time = ProcessorTime::current();
  double done = 0;                // seconds of this thread, when it was through with its part
  std::optional<Stopwatch> whole; // its time is asked for by a system call: only where someone counts
  if (time) whole.emplace(TimeOf::thread);
#pragma omp parallel num_threads(threads) if (threads > 1 && count > 1)
  {
    const int thread = omp_get_thread_num();
    std::optional<Stopwatch> part;
    if (time && thread != 0) part.emplace(TimeOf::thread);
    try {
      for (std::size_t index; (index = next.fetch_add(1, std::memory_order_relaxed)) < count;) body(index, thread);
    } catch (...) {
      next.store(count, std::memory_order_relaxed); // nothing more is begun
#pragma omp critical(refraster_parallel_for)
      if (!thrown) thrown = std::current_exception();
    }
    if (part) time->add_other(part->seconds());
    else if (whole) done = whole->seconds();
  }
  if (whole) time->add_waiting(whole->seconds() - done);
  if (thrown) std::rethrow_exception(thrown);
}

} // namespace refraster
