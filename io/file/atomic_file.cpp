#include "io/file/atomic_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace refraster {
namespace {

/// What a system call returns that is begun again as long as a signal breaks it off.
template <class Call>
auto uninterrupted(Call&& call) {
  for (;;)
    if (const auto result = call(); result >= 0 || errno != EINTR) return result;
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

std::string link_to(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

/// What a symbolic link stands for, and that if it is one; also where nothing is there yet. Empty if it is itself.
std::string without_links(const std::string& path) {
  std::filesystem::path target = path;
  std::error_code error;
  for (int links = 0; links < 40; ++links) { // as many as Linux follows
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) return target.string(); // not a link
    target = target.parent_path() / next;
  }
  return {};
}

/// Tries names beside the target until `make` does not find one taken. 0 or an error number.
template <class Make>
int make_beside(const std::string& target, std::string& name, Make&& make) {
  for (int n = 0; n < 1000; ++n) { // others are left from processes of our number that were killed
    name = folder_of(target) + "/" + temporary_name_prefix(getpid()) + std::to_string(n) + ".part";
    if (uninterrupted([&] { return make(name.c_str()); }) >= 0) return 0;
    if (errno != EEXIST) break;
  }
  name.clear(); // it is not ours
  return errno;
}

} // namespace

std::string temporary_name_prefix(int process) {
  return "refraster-" + std::to_string(process) + "-";
}

AtomicFile::AtomicFile(const std::string& path) : shown_(path), target_(path) {
  target_ = without_links(path);
  if (target_.empty()) fail(path.empty() ? ENOENT : ELOOP);
  struct stat status {};
  const bool exists = stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  const auto open_file = [](const char* name, int flags) {
    return uninterrupted([&] { return open(name, O_WRONLY | O_CLOEXEC | O_NOCTTY | flags, 0666); });
  };
  if (exists && !S_ISREG(status.st_mode)) {
    form_ = Form::direct;
    descriptor_ = open_file(target_.c_str(), 0);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  // A file without a name, where the file system has such: however the process ends, none of it is left. /proc gives
  // it its name.
  descriptor_ = open_file(folder_of(target_).c_str(), O_TMPFILE);
  if (descriptor_ >= 0 && access(link_to(descriptor_).c_str(), F_OK) != 0) {
    close(descriptor_);
    descriptor_ = -1;
  }
  if (descriptor_ >= 0) {
    form_ = Form::nameless;
  } else {
    form_ = Form::named;
    const int reason = make_beside(target_, temporary_, [&](const char* name) {
      return descriptor_ = open(name, O_WRONLY | O_CLOEXEC | O_CREAT | O_EXCL, 0666);
    });
    if (descriptor_ < 0) fail(reason);
  }
  if (exists && fchmod(descriptor_, status.st_mode & 07777) != 0) fail(errno);
}

AtomicFile::~AtomicFile() {
  close_and_remove();
}

void AtomicFile::close_and_remove() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) unlink(temporary_.c_str());
  temporary_.clear();
}

void AtomicFile::fail(int error_number) {
  close_and_remove();
  throw OutputError(shown_, std::strerror(error_number));
}

void AtomicFile::write(const void* bytes, std::size_t size_bytes) {
  const char* at = static_cast<const char*>(bytes);
  while (size_bytes > 0) {
    const ssize_t written = uninterrupted([&] { return ::write(descriptor_, at, size_bytes); });
    if (written <= 0) fail(written < 0 ? errno : ENOSPC);
    at += written;
    size_bytes -= static_cast<std::size_t>(written);
    position_ += static_cast<std::uint64_t>(written);
  }
}

void AtomicFile::seek(std::uint64_t position) {
  if (lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(errno);
  position_ = position;
}

void AtomicFile::commit() {
  // Before it takes its name: a file system may tell only now that the disk is full or broken, and after a power cut
  // the name must not stand for less than the whole.
  if (form_ != Form::direct && uninterrupted([&] { return fsync(descriptor_); }) != 0) fail(errno);
  if (form_ == Form::nameless) {
    const std::string self = link_to(descriptor_);
    const auto link_as = [&](const char* name) {
      return linkat(AT_FDCWD, self.c_str(), AT_FDCWD, name, AT_SYMLINK_FOLLOW);
    };
    if (uninterrupted([&] { return link_as(target_.c_str()); }) != 0) {
      if (errno != EEXIST) fail(errno);
      // Only a rename takes the place of a file: for that moment it needs a name of its own.
      if (const int reason = make_beside(target_, temporary_, link_as)) fail(reason);
    }
  }
  // After EINTR the descriptor is closed, close(2). Where there was an fsync, it has said that all is on disk.
  const int closed = close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 && errno != EINTR && form_ == Form::direct) fail(errno);
  if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

} // namespace refraster
