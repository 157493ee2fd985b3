#include "app/turntable/film.h"

#include <refraster/notes.h>

#include "app/interrupt.h"
#include "io/file/atomic_file.h"
#include "io/file/input_file.h"
#include "io/file/text.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace refraster {

bool is_film(const std::string& path) {
  return extension(path) == "mp4";
}

Film::Film(const std::string& path, int width, int height, int frames_per_second) : path_(path) {
  const std::filesystem::path folder = std::filesystem::path(canonical_path(path)).parent_path();
  clean_when_interrupted(folder);
  temporary_ = folder / (temporary_name_prefix(getpid()) + "film.mp4");
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw OutputError(path, std::strerror(errno));
  pipe_ = ends[1];
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  const std::string rate = std::to_string(frames_per_second);
  // 18 is what x264 calls visually lossless or nearly so. yuv420p is what players can show.
  std::vector<std::string> words = {"ffmpeg",  "-nostdin", "-loglevel", "error", "-y",   "-f",      "rawvideo", "-pix_fmt",
                                    "rgb24",   "-s",       size,        "-r",    rate,   "-i",      "pipe:0",   "-vf",
                                    "pad=ceil(iw/2)*2:ceil(ih/2)*2",    "-pix_fmt", "yuv420p",  "-crf",  "18",  temporary_};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  // Ctrl-C is blocked in this process and so in ffmpeg, which ends when the pipe is closed.
  const int error = posix_spawnp(&process_, "ffmpeg", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[0]);
  if (error == 0) return;
  process_ = -1;
  close(pipe_);
  throw OutputError(path, error == ENOENT ? "a film is made by ffmpeg, which is not installed; frames are made without: "
                                            "-o frames/####.png"
                                          : std::strerror(error));
}

Film::~Film() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  wait();
  unlink(temporary_.c_str());
}

int Film::wait() {
  close(pipe_);
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

void Film::add(const Image<std::uint8_t>& rgb8) {
  for (std::size_t done = 0; done < rgb8.values.size();) {
    const ssize_t count = write(pipe_, rgb8.values.data() + done, rgb8.values.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw OutputError(path_, std::string("ffmpeg takes no more frames: ") + std::strerror(errno));
    done += static_cast<std::size_t>(count);
  }
}

void Film::finish() {
  const int status = wait();
  if (status != 0) {
    unlink(temporary_.c_str());
    throw OutputError(path_, WIFEXITED(status) ? "ffmpeg ended with exit code " + std::to_string(WEXITSTATUS(status))
                                               : "ffmpeg was ended");
  }
  if (rename(temporary_.c_str(), path_.c_str()) == 0) return;
  const int error = errno;
  unlink(temporary_.c_str());
  throw OutputError(path_, std::strerror(error));
}

} // namespace refraster
