// Work that the window does not wait for.

#include "app/view/job_thread.h"

#include <doctest/doctest.h>

#include <atomic>

using namespace refraster;

namespace {

template <class Result>
Result wait_for(JobThread<Result>& thread, std::atomic<int>& done, int count) {
  while (done < count) done.wait(count - 1);
  return thread.take().value();
}

} // namespace

TEST_CASE("results come one after the other, and who waits for one is told") {
  std::atomic<int> done = 0;
  JobThread<int> thread([&] { ++done, done.notify_all(); });
  for (int i = 1; i <= 100; ++i) {
    CHECK_FALSE(thread.busy());
    CHECK_FALSE(thread.take());
    thread.start([i](const std::atomic<bool>&) { return i; });
    CHECK(thread.busy());
    CHECK(wait_for(thread, done, i) == i);
  }
}

TEST_CASE("a job that is cancelled ends, and the next one is not") {
  std::atomic<int> done = 0;
  JobThread<bool> thread([&] { ++done, done.notify_all(); });
  thread.start([](const std::atomic<bool>& cancel) {
    while (!cancel) {
    }
    return cancel.load();
  });
  thread.cancel();
  CHECK(wait_for(thread, done, 1));
  thread.start([](const std::atomic<bool>& cancel) { return cancel.load(); });
  CHECK_FALSE(wait_for(thread, done, 2));
}

TEST_CASE("a thread that is not needed any more cancels what it does, and waits for it") {
  std::atomic<bool> begun = false, ended = false;
  {
    JobThread<int> thread([] {});
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
