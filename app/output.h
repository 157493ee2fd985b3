#pragma once
// Where results go.

#include <string>

namespace refraster {

/// A report on standard output instead of in a file.
inline constexpr const char* standard_output = "-";

/// Throws OutputError unless a file can be made at this path: its folder exists and lets itself be written to, and
/// the path itself is no folder. To be asked before the work, so that no one waits for an image that cannot be kept.
/// Standard output is always fine.
void check_writable(const std::string& path);

/// Writes a text file as a whole or not at all; or to standard output. Throws OutputError.
void write_text(const std::string& path, const std::string& text);

/// "scenes/ball.json" gives "ball".
std::string stem(const std::string& path);

} // namespace refraster
