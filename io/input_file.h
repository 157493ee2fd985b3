#pragma once
// Files from disk, before any format is looked at.

#include "io/input_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace refraster {

/// What is wrong with the file as such, if anything: missing, a folder, unreadable, empty, not a regular file (its size
/// could not be checked before it is read), or larger than limit_bytes. `expected` names what it should be, "an OBJ
/// file".
std::optional<InputFault> file_fault(const std::string& path, std::string_view expected, std::uint64_t limit_bytes);

/// The whole file. What is judged is what is read, also if another one takes its name meanwhile. Throws InputError with
/// file_fault, or if it shrinks while it is read.
std::string read_file(const std::string& path, std::string_view expected, std::uint64_t limit_bytes);

/// Its first bytes, at most the whole; its size. For a file without file_fault.
std::string read_prefix(const std::string& path, std::size_t size_bytes);
std::uint64_t file_size_bytes(const std::string& path);

/// Its extension in lower case, without the dot.
std::string extension(const std::string& path);

} // namespace refraster
