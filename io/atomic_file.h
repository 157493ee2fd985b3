#pragma once
// Output files that are there whole or not at all.

#include "io/input_error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace refraster {

/// Writes beside the file under a temporary name, and takes its place on commit(). Without commit, or after an error,
/// nothing is left and an older file of that name is as it was. A device or pipe is written directly; a symbolic link
/// stays one, its target is written. Every function throws OutputError.
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

  std::string shown_, target_, temporary_; // temporary_ is empty where the target is written directly
  std::uint64_t position_ = 0;
  int descriptor_ = -1;
};

/// The whole file at once.
void write_file(const std::string& path, std::string_view bytes);

} // namespace refraster
