#pragma once
// Work that the window does not wait for.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace refraster {

/// A thread that does one thing at a time. It is the same thread for all of them: OpenMP has a team of threads for each
/// that asks. What is begun when it is destroyed is cancelled, and waited for.
template <class Result>
class JobThread {
public:
  using Work = std::function<Result(const std::atomic<bool>& cancel)>;

  JobThread() : thread_([this](const std::stop_token& end) { run(end); }) {}
  ~JobThread() {
    cancel();
    thread_.request_stop();
    {
      const std::lock_guard lock(mutex_); // not between the look at `end` and the wait
    }
    changed_.notify_one();
  }
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;

  /// Whether something is begun whose result is not taken yet. Of the thread that starts.
  bool busy() const { return busy_; }
  /// Not while it is busy. The work throws nothing.
  void start(Work work) {
    busy_ = true, cancel_ = false;
    {
      const std::lock_guard lock(mutex_);
      work_ = std::move(work);
    }
    changed_.notify_one();
  }
  /// What is begun may end early; its result is still to be taken.
  void cancel() { cancel_ = true; }
  /// What has come of it; nothing while there is none.
  std::optional<Result> take() {
    const std::lock_guard lock(mutex_);
    if (!result_) return std::nullopt;
    busy_ = false;
    return std::exchange(result_, std::nullopt);
  }

private:
  void run(const std::stop_token& end) {
    for (;;) {
      Work work;
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return end.stop_requested() || work_; });
        if (end.stop_requested()) return;
        work = std::exchange(work_, nullptr);
      }
      Result result = work(cancel_);
      {
        const std::lock_guard lock(mutex_);
        result_ = std::move(result);
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  Work work_;
  std::optional<Result> result_;
  std::atomic<bool> cancel_ = false;
  bool busy_ = false;
  std::jthread thread_; // the last: it is joined before the others are gone
};

} // namespace refraster
