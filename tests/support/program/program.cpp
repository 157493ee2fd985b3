#include "tests/support/program/program.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace refraster {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const TemporaryFolder& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path)) names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> program_words() {
  return {REFRASTER_PROGRAM_WORDS};
}

std::string program_command() {
  std::string command;
  for (const std::string& word : program_words()) command += (command.empty() ? "" : " ") + word;
  return command;
}

Running::Running(const fs::path& folder, const std::vector<std::string>& arguments, const std::string& standard_error) {
  const std::string out = texts_ / "out", in = folder;
  const std::string err = standard_error.empty() ? texts_ / "err" : standard_error;
  std::vector<std::string> words = program_words();
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  process_ = fork();
  REQUIRE(process_ >= 0);
  if (process_ > 0) return;
  // In the child: nothing but system calls, then the program.
  const int out_file = open(out.c_str(), O_WRONLY | O_CREAT, 0600);
  const int err_file = open(err.c_str(), O_WRONLY | O_CREAT | O_NOCTTY, 0600);
  const bool ready = dup2(out_file, STDOUT_FILENO) >= 0 && dup2(err_file, STDERR_FILENO) >= 0 && chdir(in.c_str()) == 0;
  if (ready) execv(argv[0], argv.data());
  _exit(126);
}

void Running::send(int signal) const {
  REQUIRE(kill(process_, signal) == 0);
}

Finished Running::wait() {
  int status = 0;
  rusage used{};
  REQUIRE(wait4(process_, &status, 0, &used) == process_);
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, text_of(texts_ / "out"), text_of(texts_ / "err"), static_cast<std::uint64_t>(used.ru_maxrss) * 1024};
}

Finished run_program(const fs::path& folder, const std::vector<std::string>& arguments) {
  return Running(folder, arguments).wait();
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void save_text(const fs::path& file, const std::string& text) {
  fs::remove(file); // ext4 waits for its disk where a file is cut to nothing and written again
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  REQUIRE(stream.flush().good());
}

} // namespace refraster
