#include "verify/explain/story_table.h"

#include <array>
#include <charconv>
#include <cmath>

namespace refraster::story {
namespace {

std::string chars(double x, std::chars_format how, int digits) {
  std::array<char, 400> text; // the largest double has 309 digits
  const auto result = std::to_chars(text.data(), text.data() + text.size(), x, how, digits);
  return {text.data(), result.ptr};
}

} // namespace

std::string fixed(double x, int digits) {
  return chars(x, std::chars_format::fixed, digits);
}
std::string general(double x, int digits) {
  return chars(x, std::chars_format::general, digits);
}

std::string number(double x) {
  const double size = std::abs(x);
  if (x == 0) return "0";
  if (size >= 1e-3 && size < 1e6) return fixed(x, 6);
  return std::isfinite(x) ? chars(x, std::chars_format::scientific, 5) : general(x, 5);
}

std::string right(std::string_view text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + std::string(text);
}
std::string left(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(text.size() < width ? width - text.size() : 0, ' ');
}

std::string row(std::string_view label, const std::vector<double>& numbers) {
  std::string line = left("  " + std::string(label), label_width);
  for (const double x : numbers) line += right(number(x), number_width);
  return line + "\n";
}
std::string row(std::string_view label, const Double3& v) {
  return row(label, std::vector<double>{v.x, v.y, v.z});
}
std::string row(std::string_view label, std::string_view text) {
  return left("  " + std::string(label), label_width) + right(text, number_width) + "\n";
}

std::string heading(std::string_view text) {
  return "\n" + std::string(text) + "\n";
}
std::string heading_rgb(std::string_view text) {
  return "\n" + left(text, label_width) + right("red", number_width) + right("green", number_width) +
         right("blue", number_width) + "\n";
}

std::string sentence(std::string_view text, std::size_t indent) {
  std::string result, line;
  const std::size_t first = std::min(text.find_first_not_of(' '), text.size());
  line = std::string(text.substr(0, first));
  bool fresh = true; // nothing but blanks stands in the line
  for (std::size_t at = first; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    at = end + 1;
    if (!fresh && line.size() + 1 + word.size() > columns) {
      result += line + "\n";
      line = std::string(first + indent, ' ');
      fresh = true;
    }
    line += (fresh ? "" : " ") + std::string(word);
    fresh = false;
  }
  return result + line + "\n";
}

} // namespace refraster::story
