#pragma once
// Files from disk, before any format is looked at.

#include <refraster/notes.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace refraster {

/// What is wrong with the file as such, if anything: missing, a folder, unreadable, empty, not a regular file (its size
/// could not be checked before it is read), or larger than limit_bytes. `expected` names what it should be, "an OBJ
/// file".
std::optional<InputFault> file_fault(const std::string& path, std::string_view expected, std::uint64_t limit_bytes);

/// A file that is read in parts. What is judged is what is read, also if another one takes its name meanwhile. For
/// several threads at once.
class InputFile {
public:
  /// Throws InputError with file_fault.
  InputFile(const std::string& path, std::string_view expected, std::uint64_t limit_bytes);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// As it was when it was opened.
  std::uint64_t size_bytes() const { return size_bytes_; }

  /// Bytes from `position` on. Throws InputError if they are not there, the file having shrunk, or cannot be read.
  void read(std::uint64_t position, void* to, std::size_t size_bytes) const;

private:
  std::string path_, expected_;
  int descriptor_ = -1;
  std::uint64_t size_bytes_ = 0;
};

/// The whole file, as InputFile reads it.
std::string read_file(const std::string& path, std::string_view expected, std::uint64_t limit_bytes);

/// Its first bytes, at most the whole; its size. For a file without file_fault.
std::string read_prefix(const std::string& path, std::size_t size_bytes);
std::uint64_t file_size_bytes(const std::string& path);

/// The same for every way to write the path of one file, also of one that is not there yet: absolute, links followed.
/// `path` as it is where that cannot be determined.
std::string canonical_path(const std::string& path);

/// Its extension in lower case, without the dot.
std::string extension(const std::string& path);

} // namespace refraster
