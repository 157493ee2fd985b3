#pragma once
// Output files that are there whole or not at all.

#include <refraster/notes.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace refraster {

/// Writes to a file without a name, and takes the place of `path` on commit(), when all of it is on disk. Without
/// commit, or after an error, nothing is left and an older file of that name is as it was; also after SIGKILL, but for
/// the moment between two system calls of commit() in which the new file, whole, stands beside the old one as
/// temporary_name_prefix(process) + N + ".part". Where the file system has no files without a name (NFS), it stands
/// there all the time. A device or pipe is written directly; a symbolic link stays one, its target is written. Every
/// function throws OutputError.
class AtomicFile {
public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;

  void write(const void* bytes, std::size_t size_bytes);
  void write(std::string_view bytes) { write(bytes.data(), bytes.size()); }
  /// Position in bytes from the start, for what is filled in later. A device or pipe has none.
  std::uint64_t position() const { return position_; }
  void seek(std::uint64_t position);
  void commit();

private:
  [[noreturn]] void fail(int error_number);
  void close_and_remove();

  enum class Form { nameless, named, direct };

  std::string shown_, target_, temporary_; // temporary_: the name it has beside the target; empty if none
  Form form_ = Form::nameless;
  std::uint64_t position_ = 0;
  int descriptor_ = -1;
};

/// How names of files begin that this process has not finished.
std::string temporary_name_prefix(int process);

/// The whole file at once.
void write_file(const std::string& path, std::string_view bytes);

} // namespace refraster
