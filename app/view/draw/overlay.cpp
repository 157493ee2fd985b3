#include "app/view/draw/overlay.h"

#include "app/options/wrap.h"
#include "app/view/draw/font.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace refraster {
namespace {

constexpr int border = 8, line_height = glyph_height + 2; // pixels
constexpr std::uint32_t text_colour = 0xF2F2F2, fault_colour = 0xE0483C, mark_colour = 0xFFE060;

/// The characters of UTF-8 that is well-formed, as all of the program's own is; of other bytes, no matter what.
std::u32string letters_of(std::string_view text) {
  std::u32string letters;
  for (const char byte : text) {
    const auto value = static_cast<unsigned char>(byte);
    if (value < 0x80) letters += value;
    else if (value >= 0xC0) letters += value & (value < 0xE0 ? 0x1FU : value < 0xF0 ? 0x0FU : 0x07U);
    else if (!letters.empty()) letters.back() = (letters.back() << 6) | (value & 0x3FU);
  }
  return letters;
}

/// A quarter of the light stays: white text is legible over a white picture.
void darken(const Canvas& canvas, const Area& area) {
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) {
      std::uint32_t& pixel = canvas.pixels[y * canvas.stride + x];
      pixel = (pixel >> 2) & 0x3F3F3F;
    }
}

/// What of it lies within the window.
void fill(const Canvas& canvas, const Area& area, std::uint32_t colour) {
  for (int y = std::max(area.y, 0); y < std::min(area.y + area.height, canvas.height); ++y)
    for (int x = std::max(area.x, 0); x < std::min(area.x + area.width, canvas.width); ++x)
      canvas.pixels[y * canvas.stride + x] = colour;
}

void draw_text(const Canvas& canvas, int x, int y, std::u32string_view letters) {
  for (const char32_t letter : letters) {
    for (int row = 0; row < glyph_height; ++row)
      for (int column = 0; column < glyph_width; ++column)
        if (glyph_row(letter, row) >> (glyph_width - 1 - column) & 1)
          canvas.pixels[(y + row) * canvas.stride + x + column] = text_colour;
    x += glyph_width;
  }
}

} // namespace

Area draw_panel(const Canvas& canvas, Panel& panel) {
  const int columns_there = (canvas.width - 2 * border) / glyph_width;
  const int lines_there = (canvas.height - 2 * border) / line_height;
  if (columns_there <= 0 || lines_there <= 0) return {};
  const int count = static_cast<int>(panel.lines.size());
  int columns = 0;
  for (const std::string& line : panel.lines) columns = std::max(columns, columns_of(line));
  columns = std::min(columns, columns_there);
  const int lines = std::min(count, lines_there);
  panel.first_line = std::clamp(panel.first_line, 0, count - lines);

  Area area{0, 0, columns * glyph_width + 2 * border, lines * line_height + 2 * border};
  if (panel.corner == Corner::top_right) area.x = canvas.width - area.width;
  if (panel.corner == Corner::bottom_left) area.y = canvas.height - area.height;
  darken(canvas, area);
  if (panel.kind == PanelKind::fault) fill(canvas, {area.x, area.y, border / 2, area.height}, fault_colour);
  for (int i = 0; i < lines; ++i) {
    const std::u32string letters = letters_of(panel.lines[static_cast<std::size_t>(panel.first_line + i)]);
    draw_text(canvas, area.x + border, area.y + border + i * line_height,
              std::u32string_view(letters).substr(0, static_cast<std::size_t>(columns)));
  }
  if (lines < count) { // which part of the text it is
    const int all = area.height, begin = all * panel.first_line / count, part = std::max(all * lines / count, border);
    fill(canvas, {area.x + area.width - border / 4, area.y + begin, border / 4, part}, text_colour);
  }
  return area;
}

void draw_cross(const Canvas& canvas, int x, int y) {
  constexpr int gap = 3, arm = 9;
  // Dark around light: one of them is seen over any picture.
  for (const auto& [wider, colour] : {std::pair{1, 0x000000U}, std::pair{0, mark_colour}}) {
    const int side = 1 + 2 * wider, length = arm + 2 * wider;
    fill(canvas, {x - gap - arm - wider, y - wider, length, side}, colour);
    fill(canvas, {x + gap + 1 - wider, y - wider, length, side}, colour);
    fill(canvas, {x - wider, y - gap - arm - wider, side, length}, colour);
    fill(canvas, {x - wider, y + gap + 1 - wider, side, length}, colour);
  }
}

void draw_progress(const Canvas& canvas, double fraction) {
  constexpr int thickness = 3;
  const int length = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * canvas.width);
  fill(canvas, {0, canvas.height - thickness, length, thickness}, mark_colour);
}

} // namespace refraster
