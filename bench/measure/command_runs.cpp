#include "bench/measure/command_runs.h"

#include "bench/machine/cpus.h"
#include "io/json/json.h"
#include "raster/stopwatch.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace refraster::bench {
namespace {

/// A folder of its own, which goes with what is in it.
class ImageFolder {
public:
  ImageFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "refraster-bench-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error(name + ": " + std::strerror(errno));
    path_ = name;
  }
  ~ImageFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ImageFolder(const ImageFolder&) = delete;
  ImageFolder& operator=(const ImageFolder&) = delete;
  std::string image() const { return path_ / "image.png"; }

private:
  std::filesystem::path path_;
};

struct Process {
  double wall_ms = 0, cpu_ms = 0;
  int exit_code = -1;
  std::string output; // on standard output
};

double milliseconds(const timeval& time) {
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_usec);
}

/// Until the process at the other end has closed it. Once `stop` is true, it is told to end.
void wait_for_end(int line, pid_t process, const std::atomic<bool>* stop) {
  constexpr int often_ms = 50;
  bool told = false;
  for (pollfd end{line, POLLIN, 0}; poll(&end, 1, often_ms) <= 0;)
    if (stop && stop->load() && !std::exchange(told, true)) kill(process, SIGTERM);
}

/// Runs a program, whose path is the first word, to its end. What it says of faults is not shown.
Process run_process(std::vector<std::string> words, const std::atomic<bool>* stop) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const Stopwatch wall;
  pid_t id = -1;
  const int error = posix_spawn(&id, words.front().c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Process process;
  if (error == 0) {
    wait_for_end(ends[0], id, stop);
    std::array<char, 4096> bytes;
    for (ssize_t count; (count = read(ends[0], bytes.data(), bytes.size())) > 0 || (count < 0 && errno == EINTR);)
      if (count > 0) process.output.append(bytes.data(), static_cast<std::size_t>(count));
    int status = -1; // of no process that has ended well
    rusage usage{};
    while (wait4(id, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    process.wall_ms = wall.milliseconds();
    process.cpu_ms = milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime);
    if (WIFEXITED(status)) process.exit_code = WEXITSTATUS(status);
  }
  close(ends[0]);
  if (error != 0) throw std::runtime_error(words.front() + ": " + std::strerror(error));
  return process;
}

/// A number of an object within objects. Throws std::runtime_error if there is none.
double number_at(const JsonDocument& json, std::initializer_list<std::string_view> keys) {
  JsonIndex at = 0;
  for (const std::string_view key : keys) {
    JsonIndex child = json[at].first_child;
    while (child != 0 && json[child].key != key) child = json[child].next;
    if (child == 0) throw std::runtime_error("a report without " + std::string(key));
    at = child;
  }
  return json[at].number;
}

/// What is measured of a precision with a number of threads, by repetition.
struct Parts {
  CommandResult result; // but for the times
  std::vector<double> whole, start, read, frame, write, cpu;
};

FrameTimes run_once(const CommandTask& task, const std::string& image, std::span<const int> cpus,
                    const std::atomic<bool>* stop, Parts& parts) {
  std::vector<std::string> words = task.program;
  words.push_back("render");
  words.insert(words.end(), task.words.begin(), task.words.end());
  for (const std::string& word :
       {std::string("--size"), std::to_string(task.width) + "x" + std::to_string(task.height), std::string("--samples"),
        std::to_string(task.samples), std::string("--precision"), parts.result.precision, std::string("--threads"),
        std::to_string(parts.result.threads), std::string("-o"), image, std::string("--report"), std::string("-"),
        std::string("-q")})
    words.push_back(word);
  // The process inherits where it may run.
  stay_on(cpus.first(std::min(static_cast<std::size_t>(parts.result.threads), cpus.size())));
  Process process;
  try {
    process = run_process(words, stop);
  } catch (...) {
    stay_on(cpus);
    throw;
  }
  stay_on(cpus);
  if (process.exit_code < 0) throw std::runtime_error("refraster render was ended by a signal");
  if (process.exit_code > 0)
    throw std::runtime_error("refraster render ended with exit code " + std::to_string(process.exit_code));
  const JsonDocument report("the run report", process.output);
  const double read = 1e3 * number_at(report, {"seconds", "read"}),
               frame = 1e3 * number_at(report, {"seconds", "frame"}),
               write = 1e3 * number_at(report, {"seconds", "write"});
  parts.whole.push_back(process.wall_ms), parts.cpu.push_back(process.cpu_ms);
  parts.read.push_back(read), parts.frame.push_back(frame), parts.write.push_back(write);
  parts.start.push_back(process.wall_ms - read - frame - write);
  return {process.wall_ms, process.cpu_ms, {}, {}};
}

/// Without those that warm up.
Spread measured(std::vector<double> values, int warm_up) {
  values.erase(values.begin(), values.begin() + std::min<std::ptrdiff_t>(warm_up, std::ssize(values)));
  return spread_of(std::move(values));
}

} // namespace

std::vector<CommandResult> measure_commands(const CommandTask& task, const Repetitions& repetitions,
                                            std::string& failure) {
  std::vector<CommandResult> results;
  try {
    const ImageFolder folder;
    const std::vector<int> cpus = usable_cpus();
    std::vector<Parts> all;
    for (const std::string& precision : task.precisions)
      for (const int threads : task.threads)
        all.push_back({{precision, threads, {}, {}, {}, {}, {}, {}, {}}, {}, {}, {}, {}, {}, {}});
    std::vector<Candidate> candidates;
    for (Parts& parts : all)
      candidates.push_back([&] { return run_once(task, folder.image(), cpus, repetitions.stop, parts); });
    const std::size_t count = interleaved(candidates, repetitions).front().size();
    if (repetitions.stop && repetitions.stop->load()) return {};
    for (Parts& parts : all) {
      CommandResult& result = results.emplace_back(parts.result);
      const auto spread = [&](const std::vector<double>& values) { return measured(values, repetitions.warm_up); };
      result.repetitions = count;
      result.whole_ms = spread(parts.whole), result.start_ms = spread(parts.start);
      result.read_ms = spread(parts.read), result.frame_ms = spread(parts.frame);
      result.write_ms = spread(parts.write), result.cpu_ms = spread(parts.cpu);
    }
  } catch (const std::exception& error) {
    failure = error.what();
    return {};
  }
  return results;
}

} // namespace refraster::bench
