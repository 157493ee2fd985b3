#include "suite/workers/supervisor.h"

#include "io/file/text.h"
#include "suite/actions/run_entry.h"
#include "suite/results/result_json.h"

#include <algorithm>
#include <cstring>
#include <deque>
#include <list>
#include <map>
#include <memory>

#include <poll.h>

namespace refraster::suite {
namespace {

/// Memory and time are looked at so often: in that time a process takes hardly more than a few hundred MB.
constexpr int poll_milliseconds = 20;

/// What is still to be done, in order.
class Queue {
public:
  Queue(const std::vector<Entry>& entries, const std::vector<std::size_t>& order) {
    for (const std::size_t i : order) {
      const Entry& entry = entries[i];
      if (entry.is_alone()) alone_.push_back(i);
      else if (entry.needs_gl()) by_device_[entry.device].push_back(i);
      else plain_.push_back(i);
    }
  }

  /// For a worker whose driver is that of this device, or is not chosen yet. Nothing: there is none for it.
  std::optional<std::size_t> next(const std::optional<std::string>& device) {
    if (device)
      if (const auto found = by_device_.find(*device); found != by_device_.end())
        if (auto entry = taken(found->second)) return entry;
    if (auto entry = taken(plain_)) return entry;
    if (device) return std::nullopt;
    for (auto& [name, entries] : by_device_)
      if (auto entry = taken(entries)) return entry;
    return std::nullopt;
  }
  std::optional<std::size_t> next_alone() { return taken(alone_); }
  /// Whether anything is left that is not to be done alone.
  bool is_empty() const {
    return plain_.empty() &&
           std::all_of(by_device_.begin(), by_device_.end(), [](const auto& one) { return one.second.empty(); });
  }
  bool has_alone() const { return !alone_.empty(); }

private:
  static std::optional<std::size_t> taken(std::deque<std::size_t>& entries) {
    if (entries.empty()) return std::nullopt;
    const std::size_t first = entries.front();
    entries.pop_front();
    return first;
  }
  std::deque<std::size_t> plain_, alone_;
  std::map<std::string, std::deque<std::size_t>> by_device_;
};

class Supervisor {
public:
  Supervisor(const std::vector<Entry>& entries, const std::vector<std::size_t>& order, const Workplace& workplace,
             const Supervision& how)
      : entries_(entries), workplace_(workplace), how_(how), queue_(entries, order) {
    jobs_ =
        std::min<std::size_t>(static_cast<std::size_t>(std::max(1, how.jobs)), std::max<std::size_t>(1, order.size()));
    worker_bytes_ = how.memory_bytes / jobs_;
  }

  Supervised run() {
    while (!is_stopped()) {
      give_work();
      if (workers_.empty()) return Supervised::all_done;
      wait();
      for (auto worker = workers_.begin(); worker != workers_.end();) worker = looked_after(worker);
    }
    return Supervised::stopped;
  }

private:
  using Workers = std::list<std::unique_ptr<Worker>>;

  bool is_stopped() const { return how_.stop != nullptr && *how_.stop; }

  void give_work() {
    for (auto worker = workers_.begin(); worker != workers_.end();) {
      if (!(*worker)->is_idle()) {
        ++worker;
        continue;
      }
      if (const auto entry = queue_.next((*worker)->device())) {
        if (!(*worker)->begin(*entry, entries_[*entry])) *worker = new_worker(*entry); // it has ended meanwhile
        ++worker;
      } else { // it has another driver than what is left needs, or nothing is left
        (*worker)->end(Worker::How::by_itself);
        worker = workers_.erase(worker);
      }
    }
    while (workers_.size() < jobs_ && !queue_.is_empty()) workers_.push_back(new_worker(*queue_.next(std::nullopt)));
    if (workers_.empty() && queue_.has_alone()) workers_.push_back(new_worker(*queue_.next_alone()));
  }

  /// One that begins with this entry. If it ends before it has, that is found out when it is listened to.
  std::unique_ptr<Worker> new_worker(std::size_t entry) const {
    auto worker = std::make_unique<Worker>(entries_, workplace_, how_.limits, worker_bytes_);
    if (how_.started) how_.started(worker->process());
    worker->begin(entry, entries_[entry]);
    return worker;
  }

  void wait() const {
    std::vector<pollfd> sockets;
    for (const auto& worker : workers_) sockets.push_back({worker->socket(), POLLIN, 0});
    poll(sockets.data(), sockets.size(), poll_milliseconds);
  }

  /// What it says is reported, or what it ended by. Gives the next worker.
  Workers::iterator looked_after(Workers::iterator at) {
    Worker& worker = **at;
    if (worker.is_idle()) return std::next(at);
    const Entry& entry = entries_[worker.entry()];
    bool closed = false;
    const double seconds = worker.seconds();
    if (const std::optional<std::string> message = worker.result(closed)) {
      const JsonDocument document("a worker's result", *message);
      std::optional<EntryResult> result = result_from(document, 0);
      const bool is_exhausted = !result || result->state == State::out_of_memory;
      how_.done(result ? std::move(*result) : unfinished(entry, State::crashed, "its result cannot be read"));
      // Memory that is in pieces may not suffice for the next one either.
      return is_exhausted ? replaced(at, Worker::How::at_once) : std::next(at);
    }
    if (closed) return reported(at, entry, seconds, State::crashed);
    if (seconds > entry.timeout_seconds) return reported(at, entry, seconds, State::timed_out);
    if (const std::uint64_t most = allowed_bytes(entry); most > 0 && worker.memory_bytes() > most)
      return reported(at, entry, seconds, State::out_of_memory);
    return std::next(at);
  }

  std::uint64_t allowed_bytes(const Entry& entry) const {
    const std::uint64_t own = entry.max_memory_mib << 20;
    if (own == 0 || worker_bytes_ == 0) return std::max(own, worker_bytes_);
    return std::min(own, worker_bytes_);
  }

  Workers::iterator replaced(Workers::iterator at, Worker::How how) {
    (*at)->end(how);
    return workers_.erase(at);
  }

  Workers::iterator reported(Workers::iterator at, const Entry& entry, double seconds, State state) {
    const Ending ending = (*at)->end(state == State::crashed ? Worker::How::by_itself : Worker::How::at_once);
    const auto next = workers_.erase(at);
    if (is_stopped()) return next; // whoever ended us may have ended it
    std::string message;
    if (state == State::timed_out) message = format("ended after %g s", entry.timeout_seconds);
    else if (state == State::out_of_memory)
      message = format("ended beyond %llu MiB", static_cast<unsigned long long>(allowed_bytes(entry) >> 20));
    else if (ending.signal != 0)
      message = format("its process ended by signal %d (%s)", ending.signal, strsignal(ending.signal));
    else message = format("its process ended by itself, with exit code %d", ending.exit_code);
    EntryResult result = unfinished(entry, state, message);
    result.seconds = seconds;
    how_.done(std::move(result));
    return next;
  }

  const std::vector<Entry>& entries_;
  const Workplace& workplace_;
  const Supervision& how_;
  Queue queue_;
  std::size_t jobs_ = 1;
  std::uint64_t worker_bytes_ = 0;
  Workers workers_;
};

} // namespace

Supervised supervise(const std::vector<Entry>& entries, const std::vector<std::size_t>& order,
                     const Workplace& workplace, const Supervision& how) {
  return Supervisor(entries, order, workplace, how).run();
}

int jobs_within(int asked, std::uint64_t memory_bytes) {
  if (memory_bytes == 0) return asked;
  return static_cast<int>(
      std::clamp<std::uint64_t>(memory_bytes / min_worker_bytes, 1, static_cast<std::uint64_t>(asked)));
}

} // namespace refraster::suite
