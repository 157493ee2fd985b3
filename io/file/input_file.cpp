#include "io/file/input_file.h"

#include "io/parallel/pages.h"
#include "io/trace/file_trace.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

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

/// That it is a file was asked before it is opened: to open a device may do something. And if it has become a pipe?
int open_to_read(const std::string& path) {
  return open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
}

/// As many bytes as there are, at most size_bytes; nothing if the system cannot read it.
std::optional<std::size_t> read_at(int descriptor, std::uint64_t position, void* to, std::size_t size_bytes) {
  std::size_t count = 0;
  while (count < size_bytes) {
    const ssize_t got =
        pread(descriptor, static_cast<char*>(to) + count, size_bytes - count, static_cast<off_t>(position + count));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return std::nullopt;
    if (got == 0) break;
    count += static_cast<std::size_t>(got);
  }
  return count;
}

} // namespace

std::optional<InputFault> file_fault(const std::string& path, std::string_view expected, std::uint64_t limit_bytes) {
  trace_file(path);
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return system_fault(path, expected);
  if (auto fault = fault_in(path, status, expected, limit_bytes)) return fault;
  if (access(path.c_str(), R_OK) != 0) return system_fault(path, expected);
  return {};
}

InputFile::InputFile(const std::string& path, std::string_view expected, std::uint64_t limit_bytes)
    : path_(path), expected_(expected) {
  if (auto fault = file_fault(path, expected, limit_bytes)) throw InputError(std::move(*fault));
  descriptor_ = open_to_read(path);
  if (descriptor_ < 0) throw InputError(system_fault(path, expected));
  struct stat status {};
  std::optional<InputFault> fault;
  if (fstat(descriptor_, &status) != 0) fault = system_fault(path, expected);
  else fault = fault_in(path, status, expected, limit_bytes); // once more: it may be another file than a moment ago
  if (fault) {
    close(descriptor_);
    throw InputError(std::move(*fault));
  }
  size_bytes_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::~InputFile() {
  close(descriptor_);
}

void InputFile::read(std::uint64_t position, void* to, std::size_t size_bytes) const {
  const std::optional<std::size_t> count = read_at(descriptor_, position, to, size_bytes);
  if (!count) throw InputError(system_fault(path_, expected_));
  if (*count < size_bytes)
    throw InputError(fault_of(path_,
                              "a file that ends after " + std::to_string(position + *count) + " bytes while it is read",
                              std::to_string(size_bytes_) + " bytes"));
}

std::string read_file(const std::string& path, std::string_view expected, std::uint64_t limit_bytes) {
  const InputFile file(path, expected, limit_bytes);
  std::string bytes;
  const auto size = static_cast<std::size_t>(file.size_bytes());
  reserve_pages(bytes, size);
  // By way of a piece that stays in the cache: a string that is made longer is cleared, which takes as long as to copy.
  constexpr std::size_t piece_bytes = std::size_t{1} << 17;
  const auto piece = std::make_unique_for_overwrite<char[]>(std::min(size, piece_bytes));
  while (bytes.size() < size) {
    const std::size_t part = std::min(piece_bytes, size - bytes.size());
    file.read(bytes.size(), piece.get(), part);
    bytes.append(piece.get(), part);
  }
  return bytes;
}

std::string read_prefix(const std::string& path, std::size_t size_bytes) {
  std::string bytes(size_bytes, '\0');
  const int descriptor = open_to_read(path);
  bytes.resize(descriptor < 0 ? 0 : read_at(descriptor, 0, bytes.data(), size_bytes).value_or(0));
  if (descriptor >= 0) close(descriptor);
  return bytes;
}

std::uint64_t file_size_bytes(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

std::string canonical_path(const std::string& path) {
  std::error_code error;
  fs::path canonical = fs::absolute(path, error); // there may be no working folder any more
  if (!error) canonical = fs::weakly_canonical(canonical, error);
  return error ? path : canonical.string();
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
