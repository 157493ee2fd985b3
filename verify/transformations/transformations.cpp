#include "verify/transformations/transformations.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace refraster {
namespace {

std::string number(double x, int digits) {
  std::array<char, 40> text;
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, digits).ptr};
}

/// Three digits, rounded up: what is equal within this is so.
std::string number_above(double x) {
  if (x == std::floor(x) && x < 1e6) return number(x, 6);
  const double step = std::pow(10, std::floor(std::log10(x)) - 2);
  return number(std::ceil(x / step) * step, 3);
}

std::string pixels(int count, const char* one_way, const char* other_way) {
  const int distance = std::abs(count);
  return std::to_string(distance) + (distance == 1 ? " pixel " : " pixels ") + (count > 0 ? one_way : other_way);
}

std::string words_of(const FoundTransformation& found) {
  if (found.which == Transformation::scaled) {
    const double stops = std::log2(found.factor);
    return "scaled by " + number(found.factor, 4) + " (" + (stops > 0 ? "+" : "") + number(stops, 3) + " stops)";
  }
  if (found.which != Transformation::shifted) return std::string(known(found.which).words);
  std::string words = "shifted by ";
  if (found.x != 0) words += pixels(found.x, "to the right", "to the left");
  if (found.x != 0 && found.y != 0) words += " and ";
  if (found.y != 0) words += pixels(found.y, "down", "up");
  return words;
}

} // namespace

std::string transformation_text(const FoundTransformation& found, CompareUnit unit) {
  std::string text = "b is a " + words_of(found);
  if (found.pixels == 0) return text + " (by its size; its pixels are others)";
  text += ": then ";
  const std::uint64_t others = found.pixels - found.within;
  text += "equal";
  const double within = found.equal_within * full_range(unit) / 255;
  if (within > 0) {
    const std::string shown = number_above(within);
    std::string noun(unit_name(unit));
    if (shown == "1") noun.pop_back();
    text += " within " + shown + " " + noun;
  }
  if (others > 0)
    text += " but for " + std::to_string(others) + (others == 1 ? " pixel" : " pixels") + " of " +
            std::to_string(found.pixels);
  return text;
}

} // namespace refraster
