#include "app/interrupt.h"

#include "io/file/atomic_file.h"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>

#include <unistd.h>

namespace refraster {
namespace {

namespace fs = std::filesystem;

std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may not wait for a lock");

std::mutex folders_mutex;
/// That files are written to. Never destroyed: the thread below may look at it while the process ends.
std::set<fs::path>& folders = *new std::set<fs::path>;

constexpr timespec grace{0, 500'000'000}; // most work looks at interrupted() more often than twice a second

sigset_t stopping_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  struct sigaction action = {};
  if (sigaction(SIGHUP, nullptr, &action) == 0 && action.sa_handler == SIG_DFL) sigaddset(&set, SIGHUP); // not nohup
  return set;
}

/// Files of this process that have a name before they are whole, as on a file system that knows no others.
void remove_unfinished_files() {
  const std::string prefix = temporary_name_prefix(getpid());
  const std::lock_guard lock(folders_mutex);
  for (const fs::path& folder : folders) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
      if (entry->path().filename().string().starts_with(prefix)) unlink(entry->path().c_str());
  }
}

[[noreturn]] void wait_for_signal(const sigset_t& set) {
  int signal = 0;
  while (sigwait(&set, &signal) != 0) {
  }
  signalled = true;
  // By itself, or at a second signal at once.
  while (sigtimedwait(&set, nullptr, &grace) < 0 && errno == EINTR) {
  }
  try {
    remove_unfinished_files();
  } catch (...) { // no memory
  }
  constexpr std::string_view erase_line = "\r\033[K";
  if (isatty(STDERR_FILENO) == 1 && write(STDERR_FILENO, erase_line.data(), erase_line.size()) < 0) _exit(130);
  _exit(130);
}

extern "C" void note_signal(int) {
  signalled = true;
}

} // namespace

void stop_when_interrupted() {
  std::signal(SIGPIPE, SIG_IGN); // a write fails then, and is reported as any other
  std::signal(SIGXFSZ, SIG_IGN);
  const sigset_t set = stopping_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr); // in this thread, and in those that it starts
  try {
    std::thread(wait_for_signal, set).detach();
  } catch (const std::system_error&) { // no thread to be had: then whoever works must look
    struct sigaction action = {};
    action.sa_handler = note_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND); // the second one has its usual effect
    for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
}

const std::atomic<bool>& interrupted() {
  return signalled;
}

void clean_when_interrupted(const std::string& folder) {
  const std::lock_guard lock(folders_mutex);
  folders.insert(folder);
}

} // namespace refraster
