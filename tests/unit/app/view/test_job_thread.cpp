// Work that the window does not wait for.

#include "app/view/job_thread.h"

#include <doctest/doctest.h>

#include <atomic>
#include <optional>
#include <thread>

using namespace refraster;

namespace {

template <class Result>
Result wait_for(JobThread<Result>& thread) {
  for (;;) {
    if (std::optional<Result> result = thread.take()) return *result;
    std::this_thread::yield();
  }
}

} // namespace

TEST_CASE("results come one after the other") {
  JobThread<int> thread;
  for (int i = 1; i <= 100; ++i) {
    CHECK_FALSE(thread.busy());
    CHECK_FALSE(thread.take());
    thread.start([i](const std::atomic<bool>&) { return i; });
    CHECK(thread.busy());
    CHECK(wait_for(thread) == i);
  }
}

TEST_CASE("a job that is cancelled ends, and the next one is not") {
  JobThread<bool> thread;
  thread.start([](const std::atomic<bool>& cancel) {
    while (!cancel) {
    }
    return cancel.load();
  });
  thread.cancel();
  CHECK(wait_for(thread));
  thread.start([](const std::atomic<bool>& cancel) { return cancel.load(); });
  CHECK_FALSE(wait_for(thread));
}

TEST_CASE("a thread that is not needed any more cancels what it does, and waits for it") {
  std::atomic<bool> begun = false, ended = false;
  {
    JobThread<int> thread;
    thread.start([&](const std::atomic<bool>& cancel) {
      begun = true, begun.notify_all();
      while (!cancel) {
      }
      ended = true;
      return 0;
    });
    begun.wait(false);
  }
  CHECK(ended);
}
