#include "io/file/text_kind.h"

#include <algorithm>

namespace refraster {
namespace {

using namespace std::string_view_literals;

/// Whether every other byte is zero: characters below U+0100 in UTF-16.
bool has_zeros_at(std::string_view bytes, std::size_t first) {
  if (bytes.size() < 4) return false;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    if ((bytes[i] == 0) != (i % 2 == first)) return false;
  return true;
}

/// Whether a text may have the character: all but the control characters, of which tab, the ends of lines and pages,
/// Escape and the end-of-file mark of DOS (0x1a) do occur.
bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20 && !(code >= 0x09 && code <= 0x0d) && code != 0x1a && code != 0x1b;
}

} // namespace

TextKind text_kind(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe\0\0"sv) || bytes.starts_with("\0\0\xfe\xff"sv)) return TextKind::utf_32;
  if (bytes.starts_with("\xff\xfe"sv) || bytes.starts_with("\xfe\xff"sv)) return TextKind::utf_16;
  // A line is enough to know UTF-16 without a mark, where it may later have a character beyond U+00FF.
  const std::string_view line = bytes.substr(0, std::min<std::size_t>(bytes.size() / 2 * 2, 64));
  if (has_zeros_at(line, 0) || has_zeros_at(line, 1)) return TextKind::utf_16;
  // 23 of 256 codes are such controls. Of compressed or random bytes that is one in 11, and of numbers in binary more;
  // a text with a stray one has far fewer than one in 32.
  const std::string_view begin = bytes.substr(0, std::size_t{64} << 10);
  if (32 * std::count_if(begin.begin(), begin.end(), is_control) > static_cast<std::ptrdiff_t>(begin.size()))
    return TextKind::binary;
  return bytes.find('\0') != std::string_view::npos ? TextKind::zero : TextKind::plain;
}

std::string_view name_of(TextKind kind) {
  switch (kind) {
  case TextKind::plain:
    return "text";
  case TextKind::utf_16:
    return "UTF-16 text";
  case TextKind::utf_32:
    return "UTF-32 text";
  case TextKind::binary:
    return "a binary file";
  case TextKind::zero:
    return "a zero byte";
  }
  return "";
}

} // namespace refraster
