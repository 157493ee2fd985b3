#pragma once
// Images as text within a page: exact, small, and unpacked by verify/page/planes.js.

#include <refraster/image.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

/// Base64 of a zlib stream (RFC 1950) of rows of bytes, each filtered as RowFilter does for PNG files, with its filter's
/// number in front; the row before the first is 0. Numbers of 32 bits are four such images one below the other: their
/// highest bytes, then the next ones.
std::string packed(const Image<std::uint8_t>& image);
std::string packed(const Image<std::uint32_t>& image);
std::string packed(const Image<float>& image);

/// The same of what is left when `base` is taken away, which is little where the two are nearly equal: of bytes the
/// difference modulo 256; of numbers of 32 bits the difference d of their bits modulo 2^32, as 2 |d|, less 1 where d is
/// negative. Both have the same size.
std::string packed_difference(const Image<std::uint8_t>& image, const Image<std::uint8_t>& base);
std::string packed_difference(const Image<float>& image, const Image<float>& base);

/// Base64 of a zlib stream of the text.
std::string packed(std::string_view text);

} // namespace refraster
