#include "verify/compare/heat_legend.h"

#include "verify/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {
namespace {

constexpr Rgb8 ground = {0x30, 0x30, 0x30}, ink = {0xff, 0xff, 0xff};
// Points, each of scale x scale pixels.
constexpr int margin = 4, bar_height = 8, strip_height = 28;
constexpr int letter_width = 4; // a glyph, and a point beside it
constexpr int ramp_width = 200, min_width = ramp_width + 130;
constexpr int pixels_for_a_scale = 640; // so that a large image has letters to match

/// Glyphs of 3 x 5 points, a row in three bits, the top row first.
struct Glyph {
  char letter;
  std::uint16_t rows;
};
constexpr Glyph glyphs[] = {
    {'0', 075557}, {'1', 026227}, {'2', 071747}, {'3', 071717}, {'4', 055711}, {'5', 074717}, {'6', 074757},
    {'7', 071222}, {'8', 075757}, {'9', 075717}, {'.', 000002}, {'-', 000700}, {'e', 007647}, {'+', 002720},
    {'N', 075555}, {'a', 003557}, {'q', 007571}, {'u', 005557}, {'l', 022223}, {'v', 005552}, {'s', 003626},
};

class Strip {
public:
  Strip(Image<std::uint8_t>& image, int top, int scale) : image_(image), top_(top), scale_(scale) {}

  void fill(int x, int y, int width, int height, const Rgb8& colour) {
    for (int j = y * scale_; j < (y + height) * scale_; ++j)
      for (int i = x * scale_; i < (x + width) * scale_; ++i)
        if (i < image_.width && top_ + j < image_.height)
          std::copy(colour.begin(), colour.end(), image_.at(i, top_ + j));
  }
  /// Gives the place after the last letter.
  int write(int x, int y, std::string_view words) {
    for (const char letter : words) {
      const auto* glyph =
          std::find_if(std::begin(glyphs), std::end(glyphs), [&](const Glyph& g) { return g.letter == letter; });
      if (glyph != std::end(glyphs))
        for (int row = 0; row < 5; ++row)
          for (int column = 0; column < 3; ++column)
            if (glyph->rows >> (14 - 3 * row - column) & 1) fill(x + column, y + row, 1, 1, ink);
      x += letter_width;
    }
    return x;
  }

private:
  Image<std::uint8_t>& image_;
  int top_, scale_;
};

} // namespace

double ramp_position(double difference, double ramp_end, CompareUnit unit) {
  const double level = full_range(unit) / 255;
  return std::log1p(difference / level) / std::log1p(ramp_end / level);
}

std::vector<double> legend_ticks(double ramp_end, CompareUnit unit) {
  const auto place = [&](double value) { return ramp_position(value, ramp_end, unit) * (ramp_width - 1); };
  // A label begins at its tick; a letter's width is left between two.
  const auto label_width = [](double value) {
    return letter_width * (static_cast<int>(rounded_text(value, 3).size()) + 1);
  };
  std::vector<double> ticks = {ramp_end};
  // Below a tenth of a level, or of the end where that is less, there is no room.
  const double least = std::min(full_range(unit) / 255, ramp_end) / 10;
  for (int exponent = static_cast<int>(std::floor(std::log10(ramp_end))); std::pow(10.0, exponent) >= least; --exponent)
    for (const double digit : {5.0, 2.0, 1.0}) {
      const double value = digit * std::pow(10.0, exponent);
      const bool fits = place(value) + label_width(value) <= place(ticks.back()) && place(value) >= label_width(0);
      if (value < ramp_end && fits) ticks.push_back(value);
    }
  ticks.push_back(0);
  std::reverse(ticks.begin(), ticks.end());
  return ticks;
}

Image<std::uint8_t> with_legend(const Image<std::uint8_t>& heat, const Comparison& found, double ramp_end) {
  const int scale = std::max(heat.width / pixels_for_a_scale, 1);
  Image<std::uint8_t> image(std::max(heat.width, min_width), heat.height + scale * strip_height, 3);
  Strip whole(image, 0, 1);
  whole.fill(0, 0, image.width, image.height, ground);
  for (int y = 0; y < heat.height; ++y)
    std::copy_n(heat.at(0, y), 3 * static_cast<std::size_t>(heat.width), image.at(0, y));

  Strip strip(image, heat.height, scale);
  const int label_y = margin + bar_height + 3;
  int x = margin;
  strip.fill(x, margin, 16, bar_height, {0, 0, 0});
  x = std::max(x + 16, strip.write(x, label_y, "equal")) + 8;
  if (ramp_end > 0) {
    for (int i = 0; i < ramp_width; ++i) strip.fill(x + i, margin, 1, bar_height, heat_colour((i + 0.5) / ramp_width));
    int label_end = x;
    for (const double value : legend_ticks(ramp_end, found.unit)) {
      const double t = ramp_position(value, ramp_end, found.unit);
      const int tick = x + static_cast<int>(std::lround(t * (ramp_width - 1)));
      strip.fill(tick, margin + bar_height, 1, 2, ink);
      label_end = strip.write(tick, label_y, rounded_text(value, 3));
    }
    if (found.max > ramp_end) label_end = strip.write(label_end, label_y, "+");
    strip.write(label_end + 2, label_y, unit_name(found.unit));
    x += ramp_width + 64;
  }
  if (found.incomparable_pixels > 0) {
    strip.fill(x, margin, 16, bar_height, incomparable_colour);
    strip.write(x, label_y, "NaN");
  }
  return image;
}

} // namespace refraster
