#include "python/work.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <pthread.h>

namespace refraster::python {
namespace {

using namespace std::chrono_literals;
// Together well within the half second in which Ctrl-C is to end a frame.
constexpr auto interval = 50ms; // between two looks at signals
constexpr auto patience = 250ms;

/// Whether work that is given up, and has not ended a moment later, may go on unseen until it looks.
enum class Abandon { never, when_slow };

/// The work was asked to stop, and did. Nobody sees it: what asked is thrown instead.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("stopped") {}
};

struct Job {
  std::function<void(Watch&)> work;
  Watch watch = {};
  std::mutex mutex = {};
  std::condition_variable end = {};
  bool ended = false; // the mutex is that of these two
  std::exception_ptr thrown = {};
};

/// Threads that wait for work, as many as worked at once so far.
class Workers {
public:
  void start(std::shared_ptr<Job> job) {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) {
      auto own = std::make_unique<Thread>();
      std::thread([this, &thread = *own] { work(thread); }).detach();
      idle_.push_back(own.release()); // waits as long as the process lives
    }
    idle_.back()->job = std::move(job);
    idle_.back()->wake.notify_one();
    idle_.pop_back();
  }

private:
  struct Thread {
    std::condition_variable wake = {};
    std::shared_ptr<Job> job = {};
  };

  [[noreturn]] void work(Thread& own) {
    for (;;) {
      std::unique_lock lock(mutex_);
      own.wake.wait(lock, [&] { return own.job != nullptr; });
      const std::shared_ptr<Job> job = std::move(own.job);
      own.job = nullptr;
      lock.unlock();
      std::exception_ptr thrown;
      try {
        job->work(job->watch);
      } catch (...) {
        thrown = std::current_exception();
      }
      job->work = nullptr; // what it owns is given back before its end is seen
      lock.lock();
      idle_.push_back(&own);
      lock.unlock();
      const std::lock_guard ending(job->mutex);
      job->ended = true, job->thrown = std::move(thrown);
      job->end.notify_one();
    }
  }

  std::mutex mutex_;
  std::vector<Thread*> idle_;
};

/// Never destroyed: the threads look at it while the process ends. A process that was forked has none of them.
Workers*& workers() {
  static Workers* all = [] {
    pthread_atfork(nullptr, nullptr, [] { workers() = new Workers; });
    return new Workers;
  }();
  return all;
}

void run(const py::object& progress, const std::function<void(Watch&)>& work, Abandon abandon) {
  using Clock = std::chrono::steady_clock;
  const auto job = std::make_shared<Job>();
  job->work = work;
  workers()->start(job);
  const auto has_ended = [&] {
    const py::gil_scoped_release released;
    std::unique_lock lock(job->mutex);
    return job->end.wait_for(lock, interval, [&] { return job->ended; });
  };
  double shown = -1;
  const auto show = [&](double fraction) {
    if (progress.is_none() || fraction <= shown) return;
    shown = fraction;
    progress(fraction);
  };
  std::exception_ptr of_caller;
  Clock::time_point stopped;
  while (!has_ended()) {
    if (of_caller) {
      if (abandon == Abandon::when_slow && Clock::now() - stopped > patience) break;
      continue;
    }
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      show(job->watch.fraction);
    } catch (...) {
      of_caller = std::current_exception();
      job->watch.stop = true, stopped = Clock::now();
    }
  }
  if (of_caller) std::rethrow_exception(of_caller);
  if (job->thrown) std::rethrow_exception(job->thrown);
  if (PyErr_CheckSignals() != 0) throw py::error_already_set(); // also if all was done before anyone looked
  show(1);
}

} // namespace

std::function<void(double)> Watch::reporter() {
  return [this](double done) {
    if (stop) throw Stopped();
    fraction = done;
  };
}

void run_watched(const py::object& progress, const std::function<void(Watch&)>& work) {
  run(progress, work, Abandon::never);
}

void run_or_leave(const py::object& progress, const std::function<void(Watch&)>& work) {
  run(progress, work, Abandon::when_slow);
}

} // namespace refraster::python
