#include "raster/parallel.h"

#include <atomic>
#include <exception>

#include <omp.h>

namespace refraster {

void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t index, int thread)>& body) {
  // Indices are given out here and not by `omp for`, out of which no exception may come.
  std::atomic<std::size_t> next{0};
  std::exception_ptr thrown;
#pragma omp parallel num_threads(threads) if (threads > 1 && count > 1)
  {
    const int thread = omp_get_thread_num();
    try {
      for (std::size_t index; (index = next.fetch_add(1, std::memory_order_relaxed)) < count;) body(index, thread);
    } catch (...) {
      next.store(count, std::memory_order_relaxed); // nothing more is begun
#pragma omp critical(refraster_parallel_for)
      if (!thrown) thrown = std::current_exception();
    }
  }
  if (thrown) std::rethrow_exception(thrown);
}

} // namespace refraster
