// Loops that threads share, and the time they take on processors.

#include "raster/parallel.h"
#include "raster/processor_time.h"

#include <doctest/doctest.h>

#include <stdexcept>
#include <vector>

namespace refraster::test {
namespace {

/// Until this thread has spent so long on a processor.
void work(double milliseconds) {
  const Stopwatch own(TimeOf::thread);
  while (own.milliseconds() < milliseconds) {
  }
}

} // namespace

TEST_CASE("each index is met once, by a thread of the team, and what is thrown comes out") {
  for (const int threads : {1, 2, 3}) {
    std::vector<int> met(1000);
    parallel_for(threads, met.size(), [&](std::size_t i, int thread) {
      CHECK(thread < threads);
      ++met[i];
    });
    CHECK(met == std::vector<int>(1000, 1));
    CHECK_THROWS_AS(parallel_for(threads, 10,
                                 [](std::size_t i, int) {
                                   if (i == 3) throw std::runtime_error("three");
                                 }),
                    std::runtime_error);
  }
}

TEST_CASE("processor time is that of all bodies and of what is between, and nothing of what is spent waiting") {
  const Stopwatch own(TimeOf::thread);
  ProcessorTime time;
  time.add_other(1.5);
  time.add_waiting(0.5);
  // What this thread spent itself: no more than from before it was made until after it was asked.
  const double counted = time.milliseconds(), since_before = own.milliseconds();
  CHECK(counted >= 1000);
  CHECK(counted <= 1000 + since_before);

  for (const int threads : {1, 2, 3}) {
    const ProcessorTime of_loop;
    std::vector<double> spent(7);
    parallel_for(threads, spent.size(), [&](std::size_t i, int) {
      const Stopwatch body(TimeOf::thread);
      work(i % 2 == 0 ? 3 : 0);
      spent[i] = body.milliseconds();
    });
    double sum = 0;
    for (const double one : spent) sum += one;
    CHECK(sum >= 12);
    CHECK(of_loop.milliseconds() >= sum - 1e-3); // what threads spend is kept in whole nanoseconds
  }
}

TEST_CASE("a loop counts for the newest of those that count in its thread, and for none without") {
  CHECK(ProcessorTime::current() == nullptr);
  {
    const ProcessorTime outer;
    CHECK(ProcessorTime::current() == &outer);
    {
      const ProcessorTime inner;
      CHECK(ProcessorTime::current() == &inner);
    }
    CHECK(ProcessorTime::current() == &outer);
  }
  CHECK(ProcessorTime::current() == nullptr);
}

} // namespace refraster::test
