#pragma once
// Letters of one width, for text in the window.

#include <cstdint>

namespace refraster {

inline constexpr int glyph_width = 8, glyph_height = 13; // pixels

/// Row y of a letter's cell, from the top, 0 <= y < glyph_height: the highest bit is the leftmost pixel. Letters that
/// the font does not have show a question mark.
std::uint8_t glyph_row(char32_t letter, int y);

} // namespace refraster
