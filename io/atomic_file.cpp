#include "io/atomic_file.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace refraster {
namespace {
/// No two files of this process, nor of another that lives, share a temporary name.
std::string temporary_suffix() {
  static std::atomic<unsigned> count{0};
  return ".part-" + std::to_string(getpid()) + "-" + std::to_string(count++);
}
} // namespace

AtomicFile::AtomicFile(const std::string& path) : shown_(path), target_(path) {
  std::error_code error;
  if (const auto real = std::filesystem::canonical(path, error); !error) target_ = real.string();
  struct stat status {};
  const bool exists = stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = open(target_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    temporary_ = target_ + temporary_suffix();
    descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0 && exists && fchmod(descriptor_, status.st_mode & 07777) != 0) fail(errno);
  }
  if (descriptor_ < 0) {
    const int reason = errno;
    temporary_.clear(); // it is not ours
    fail(reason);
  }
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
    const ssize_t written = ::write(descriptor_, at, size_bytes);
    if (written < 0 && errno == EINTR) continue;
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
  // A network file system may tell only now that the disk is full.
  const int closed = close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail(errno);
  if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void write_file(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

} // namespace refraster
