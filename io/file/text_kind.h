#pragma once
// What the bytes of a file are that is meant to be text.

#include <cstddef>
#include <string_view>

namespace refraster {

enum class TextKind {
  plain,  // no byte of it is zero: ASCII, UTF-8, or any other coding that goes on from ASCII
  utf_16, // by its byte order mark; or, without one, by its zero bytes
  utf_32, // by its byte order mark
  binary, // control characters as no text has them
  zero    // a text with a zero byte in it
};

/// What the bytes are, to tell a user of a file that cannot be read as text; by its first 64 KiB, and where those are
/// plain, by whether there is a zero byte.
TextKind text_kind(std::string_view bytes);

/// "UTF-16 text", "a binary file" …: what a message says was found.
std::string_view name_of(TextKind kind);

} // namespace refraster
