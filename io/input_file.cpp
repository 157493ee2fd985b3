#include "io/input_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace refraster {
namespace fs = std::filesystem;

namespace {

InputFault fault_of(const std::string& path, std::string found, std::string_view expected) {
  return {path, 0, 0, "", std::move(found), std::string(expected)};
}

std::optional<InputFault> fault_in(const std::string& path, const struct stat& status, std::string_view expected,
                                   std::uint64_t limit_bytes) {
  if (S_ISDIR(status.st_mode)) return fault_of(path, "a folder", expected);
  if (!S_ISREG(status.st_mode)) return fault_of(path, "a device or pipe", expected);
  const auto size_bytes = static_cast<std::uint64_t>(status.st_size);
  if (size_bytes == 0) return fault_of(path, "an empty file", expected);
  if (size_bytes > limit_bytes)
    return fault_of(path, std::to_string(size_bytes) + " bytes", "at most " + std::to_string(limit_bytes) + " bytes");
  return {};
}

InputFault system_fault(const std::string& path, std::string_view expected) {
  if (errno == ENOENT || errno == ENOTDIR) return fault_of(path, "no such file", expected);
  if (errno == EACCES) return fault_of(path, "a file that may not be read", expected);
  return fault_of(path, std::strerror(errno), expected);
}

/// An open file. That it is one was asked before it was opened: to open a device may do something.
class Descriptor {
public:
  explicit Descriptor(const std::string& path)
      : number_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK)) {} // and if it has become a pipe?
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;

  bool is_open() const { return number_ >= 0; }
  int number() const { return number_; }

  /// As many bytes as there are, at most size_bytes; nothing if the system cannot read it.
  std::optional<std::size_t> read(char* to, std::size_t size_bytes) const {
    std::size_t count = 0;
    while (count < size_bytes) {
      const ssize_t got = ::read(number_, to + count, size_bytes - count);
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return std::nullopt;
      if (got == 0) break;
      count += static_cast<std::size_t>(got);
    }
    return count;
  }

private:
  int number_;
};

} // namespace

std::optional<InputFault> file_fault(const std::string& path, std::string_view expected, std::uint64_t limit_bytes) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return system_fault(path, expected);
  if (auto fault = fault_in(path, status, expected, limit_bytes)) return fault;
  if (access(path.c_str(), R_OK) != 0) return system_fault(path, expected);
  return {};
}

std::string read_file(const std::string& path, std::string_view expected, std::uint64_t limit_bytes) {
  if (auto fault = file_fault(path, expected, limit_bytes)) throw InputError(std::move(*fault));
  const Descriptor file(path);
  struct stat status {};
  if (!file.is_open() || fstat(file.number(), &status) != 0) throw InputError(system_fault(path, expected));
  // Once more: it may be another file than a moment ago.
  if (auto fault = fault_in(path, status, expected, limit_bytes)) throw InputError(std::move(*fault));
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  const std::optional<std::size_t> count = file.read(bytes.data(), bytes.size());
  if (!count) throw InputError(system_fault(path, expected));
  if (*count < bytes.size())
    throw InputError(fault_of(path, "a file that ends after " + std::to_string(*count) + " bytes while it is read",
                              std::to_string(bytes.size()) + " bytes"));
  return bytes;
}

std::string read_prefix(const std::string& path, std::size_t size_bytes) {
  std::string bytes(size_bytes, '\0');
  const Descriptor file(path);
  bytes.resize(file.is_open() ? file.read(bytes.data(), size_bytes).value_or(0) : 0);
  return bytes;
}

std::uint64_t file_size_bytes(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

std::string extension(const std::string& path) {
  std::string result = fs::path(path).extension().string();
  if (!result.empty()) result.erase(0, 1);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : static_cast<char>(c);
  });
  return result;
}

} // namespace refraster
