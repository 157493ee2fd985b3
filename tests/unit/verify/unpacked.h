#pragma once
// Undoes what verify/page/packed.h says of packed images, by its words alone.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace refraster::test {

/// The bytes of rows of width * channels; of 32-bit numbers, `height` is four times that of the image.
std::vector<std::uint8_t> unpacked_rows(std::string_view text, int width, int height, int channels);

/// The numbers whose bytes lie in four images.
std::vector<std::uint32_t> numbers_of(const std::vector<std::uint8_t>& bytes);

/// A packed text.
std::string unpacked_text(std::string_view text, std::size_t size);

/// What stands between an element's start, `<script … id="plane-ID" …>`, and its end.
std::string plane_of(const std::string& page, const std::string& id);

} // namespace refraster::test
