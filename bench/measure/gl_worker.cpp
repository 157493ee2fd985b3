#include "bench/measure/gl_worker.h"

#include "bench/machine/cpus.h"
#include "gl/gl_session.h"
#include "raster/stopwatch.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace refraster::bench {
namespace {

// Over the socket go bytes of plain values, and texts with their length before them. Both ends are the same program.

bool send_bytes(int line, const void* bytes, std::size_t size) {
  const char* at = static_cast<const char*>(bytes);
  while (size > 0) {
    const ssize_t sent = send(line, at, size, MSG_NOSIGNAL);
    if (sent <= 0) return false;
    at += sent, size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_bytes(int line, void* bytes, std::size_t size) {
  char* at = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t got = recv(line, at, size, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

template <class Value>
bool send_value(int line, const Value& value) {
  return send_bytes(line, &value, sizeof value);
}
template <class Value>
bool receive_value(int line, Value& value) {
  return receive_bytes(line, &value, sizeof value);
}

bool send_text(int line, const std::string& text) {
  return send_value(line, text.size()) && send_bytes(line, text.data(), text.size());
}
bool receive_text(int line, std::string& text) {
  std::size_t size = 0;
  if (!receive_value(line, size)) return false;
  text.resize(size);
  return receive_bytes(line, text.data(), size);
}

enum class Hello : char { none, ready, failed };
enum class Order : char { draw, quit };
struct Drawn {
  double wall_ms, cpu_ms;
};

/// The child's life. It neither returns nor uses OpenMP, whose threads it does not have.
[[noreturn]] void serve(int line, const Scene& scene, const GlOptions& options, int threads,
                        std::span<const int> cpus) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  // Drivers do not bear a limit of memory; app/memory_limit.h sets a soft one.
  if (rlimit data{}; getrlimit(RLIMIT_DATA, &data) == 0) {
    data.rlim_cur = data.rlim_max;
    setrlimit(RLIMIT_DATA, &data);
  }
  stay_on(cpus.first(std::min(static_cast<std::size_t>(threads), cpus.size())));
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  try {
    GlSession session(scene, options);
    const GlDriver& driver = session.driver();
    send_value(line, Hello::ready);
    for (const std::string& text : {driver.vendor, driver.renderer, driver.version, driver.glsl_version})
      send_text(line, text);
    for (Order order{}; receive_value(line, order) && order == Order::draw;) {
      const GlTimes times = session.draw_timed();
      send_value(line, Drawn{times.wall_ms.front(), times.cpu_ms.front()});
    }
  } catch (const std::exception& error) {
    send_value(line, Hello::failed);
    send_text(line, error.what());
  }
  _exit(0); // no exit handlers: files and threads of the parent are not ours to end
}

/// After a parallel region OpenMP's threads look out for the next one for some milliseconds, at full speed.
void wait_for_own_threads() {
  using namespace std::chrono_literals;
  for (int i = 0; i < 50; ++i) {
    const Stopwatch cpu(TimeOf::process);
    std::this_thread::sleep_for(1ms);
    if (cpu.milliseconds() < 0.2) return;
  }
}

} // namespace

GlWorker::GlWorker(const Scene& scene, const GlOptions& options, int threads, std::span<const int> cpus) {
  int ends[2] = {};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw NoOpenGl("cannot start a process for OpenGL");
  wait_for_own_threads(); // and with it: they hold no lock that the child would need
  child_ = fork();
  if (child_ == 0) {
    close(ends[0]);
    serve(ends[1], scene, options, threads, cpus);
  }
  close(ends[1]);
  line_ = ends[0];
  if (child_ < 0) {
    close(line_);
    throw NoOpenGl("cannot start a process for OpenGL");
  }
  Hello hello{};
  std::string reason = "the process that draws with OpenGL ended";
  bool ready = receive_value(line_, hello) && hello == Hello::ready;
  if (ready) {
    for (std::string* text : {&driver_.vendor, &driver_.renderer, &driver_.version, &driver_.glsl_version})
      ready = ready && receive_text(line_, *text);
  } else if (hello == Hello::failed) {
    receive_text(line_, reason);
  }
  if (ready) return;
  close(line_);
  waitpid(child_, nullptr, 0);
  throw NoOpenGl(reason);
}

GlWorker::~GlWorker() {
  send_value(line_, Order::quit);
  close(line_);
  waitpid(child_, nullptr, 0);
}

FrameTimes GlWorker::draw() {
  wait_for_own_threads();
  Drawn drawn{};
  if (!send_value(line_, Order::draw) || !receive_value(line_, drawn))
    throw NoOpenGl("the process that draws with OpenGL ended");
  return {drawn.wall_ms, drawn.cpu_ms, {}, {}};
}

} // namespace refraster::bench
