#include "suite/workers/worker.h"

#include "suite/actions/run_entry.h"
#include "suite/results/result_json.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace refraster::suite {
namespace {

std::uint64_t peak_bytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
}

/// In the child: it is to end with its parent, and nothing of it may be on standard output, which has the parent's
/// words. Signals that stop the program stay blocked, as the parent has them: the parent ends its children.
void become_child(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1); // it ended before that
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDOUT_FILENO);
}

/// Does what it is asked for until nobody asks.
[[noreturn]] void work(int socket, const std::vector<Entry>& entries, Workplace workplace, const ProcessLimits& limits,
                       std::uint64_t memory_bytes) {
  try {
    if (limits.set_memory) workplace.memory = limits.set_memory(memory_bytes, workplace.threads);
    workplace.before_gl = limits.clear_memory;
    while (const std::optional<std::string> asked = receive_message(socket)) {
      std::size_t index = 0;
      std::memcpy(&index, asked->data(), sizeof index);
      EntryResult result = run_entry(entries[index], workplace);
      result.peak_bytes = peak_bytes();
      if (!send_message(socket, result_text(result))) break;
    }
  } catch (const std::exception& error) { // no memory for the result itself
    std::fprintf(stderr, "refraster: a worker ends: %s\n", error.what());
    _exit(1);
  }
  _exit(0); // without destructors: threads of drivers may still look at what they would destroy
}

} // namespace

Worker::Worker(const std::vector<Entry>& entries, const Workplace& workplace, const ProcessLimits& limits,
               std::uint64_t memory_bytes) {
  int pair[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0)
    throw std::runtime_error(std::string("no further socket: ") + std::strerror(errno));
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) {
    const int reason = errno;
    close(pair[0]), close(pair[1]);
    throw std::runtime_error(std::string("no further process: ") + std::strerror(reason));
  }
  if (process_ == 0) {
    close(pair[0]);
    become_child(parent);
    work(pair[1], entries, workplace, limits, memory_bytes);
  }
  close(pair[1]);
  socket_ = pair[0];
}

Worker::~Worker() {
  if (process_ > 0) end(How::at_once);
}

std::uint64_t Worker::memory_bytes() const {
  std::ifstream statm("/proc/" + std::to_string(process_) + "/statm"); // proc(5)
  std::uint64_t size = 0, resident = 0;
  statm >> size >> resident;
  return statm ? resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

bool Worker::begin(std::size_t entry, const Entry& what) {
  entry_ = entry;
  if (what.needs_gl()) device_ = what.device;
  since_ = Stopwatch();
  return send_message(socket_, {reinterpret_cast<const char*>(&entry), sizeof entry});
}

std::optional<std::string> Worker::result(bool& closed) {
  closed = reader_.read_from(socket_) == MessageReader::Channel::closed;
  std::optional<std::string> message = reader_.next();
  if (message) entry_.reset();
  return message;
}

Ending Worker::end(How how) {
  // Other workers, forked later, have the socket too: closing it alone would not be seen.
  shutdown(socket_, SHUT_RDWR);
  close(socket_);
  if (how == How::at_once) kill(process_, SIGKILL);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return {WIFSIGNALED(status) ? WTERMSIG(status) : 0, WIFEXITED(status) ? WEXITSTATUS(status) : 0};
}

std::string made_by_child(const std::function<std::string()>& make) {
  int pair[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) return {};
  const pid_t parent = getpid(), child = fork();
  if (child == 0) {
    become_child(parent);
    try {
      send_message(pair[1], make());
    } catch (const std::exception&) { // the line stays empty
    }
    _exit(0);
  }
  close(pair[1]);
  const std::string made = child < 0 ? std::string() : receive_message(pair[0]).value_or("");
  close(pair[0]);
  if (child > 0)
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) {
    }
  return made;
}

} // namespace refraster::suite
