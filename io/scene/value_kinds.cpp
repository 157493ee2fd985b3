#include "io/scene/value_kinds.h"

#include "io/file/number_text.h"
#include "raster/samples.h"

#include <array>
#include <charconv>
#include <cmath>

namespace refraster {
namespace {

/// The shortest text that reads back as x.
std::string shortest(double x) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr};
}

/// What follows "a number": " >= 0", " from 3 to 4096".
std::string range_text(const Range& range) {
  const bool below = range.min > any_number.min, above = range.max < any_number.max;
  if (range.ends == Ends::excluded) {
    std::string text = below ? " > " + shortest(range.min) : "";
    if (above) text += (below ? " and < " : " < ") + shortest(range.max);
    return text;
  }
  if (below && above) return " from " + shortest(range.min) + " to " + shortest(range.max);
  if (below) return " >= " + shortest(range.min);
  if (above) return " <= " + shortest(range.max);
  return "";
}

/// As many words as the vector has components, each a number in the range, between blanks: "0.0 0.0 6.0".
template <class Vector>
bool read_words(std::string_view text, const Range& range, Vector& value) {
  constexpr std::string_view blanks = " \t\r\n";
  Vector read;
  int count = 0;
  for (std::size_t begin = text.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
    double number = 0;
    if (count == Vector::length() || read_number(text.substr(begin, end - begin), number) != NumberText::good)
      return false;
    if (!range.contains(number)) return false;
    read[count++] = number;
    begin = text.find_first_not_of(blanks, end);
  }
  if (count == Vector::length()) value = read;
  return count == Vector::length();
}

/// The words, or an array of as many numbers.
template <class Vector>
bool read_vector(const JsonDocument& document, const JsonNode& node, const Range& range, Vector& value) {
  if (node.kind == JsonKind::string) return read_words(node.string, range, value);
  if (node.kind != JsonKind::array || node.children != static_cast<std::uint32_t>(Vector::length())) return false;
  Vector read;
  JsonIndex child = node.first_child;
  for (int i = 0; i < Vector::length(); ++i, child = document[child].next)
    if (!read_value(document, document[child], range, read[i])) return false;
  value = read;
  return true;
}

} // namespace

std::string json_word(std::string_view word) {
  if (word == "true" || word == "false") return std::string(word);
  return '"' + std::string(word) + '"';
}

std::string expected_value(const double&, const Range& range) {
  return "a number" + range_text(range);
}
std::string expected_value(const int&, const Range& range) {
  return "a whole number" + range_text(range);
}
std::string expected_value(const SampleCount&, const Range&) {
  return "1, 2, 4, 8 or 16";
}
std::string expected_value(const Double2&, const Range& range) {
  return "two numbers" + range_text(range);
}
std::string expected_value(const Double3&, const Range& range) {
  return "three numbers" + range_text(range);
}
std::string expected_value(const std::string&, const Range&) {
  return "a string";
}
std::string expected_value(const PathText&, const Range&) {
  return "the path of a file";
}
std::string expected_value(const FragmentFunctionName& value, const Range&) {
  NamedValue names;
  for_each_fragment_function([&](auto function, std::size_t) { names.names.push_back(function.name); });
  for (const auto& function : value.user_functions) names.names.push_back(function->name());
  return expected_value(names, Range{});
}
std::string expected_value(const NamedValue& value, const Range&) {
  std::string result;
  for (const std::string_view name : value.names) result += (result.empty() ? "" : " or ") + json_word(name);
  return result;
}

std::string expected_normals() {
  return expected_value(NormalsFrom::file, Range{}) + " or an object with crease_degrees";
}

std::string expected_shadow() {
  return expected_value(Shadow::none, Range{}) + " or an object with map";
}

std::string expected_map() {
  return "the path of a file, or an object with one";
}

bool read_value(const JsonDocument&, const JsonNode& node, const Range& range, double& value) {
  if (node.kind != JsonKind::number || !range.contains(node.number)) return false;
  value = node.number;
  return true;
}

bool read_value(const JsonDocument&, const JsonNode& node, const Range& range, int& value) {
  if (node.kind != JsonKind::number || !range.contains(node.number) || node.number != std::floor(node.number))
    return false;
  value = static_cast<int>(node.number); // every Range of an int is within int
  return true;
}

bool read_value(const JsonDocument& document, const JsonNode& node, const Range&, SampleCount& value) {
  int count = 0;
  if (!read_value(document, node, Range{1, 16}, count) || !is_sample_count(count)) return false;
  value.count = count;
  return true;
}

bool read_value(const JsonDocument& document, const JsonNode& node, const Range& range, Double2& value) {
  return read_vector(document, node, range, value);
}
bool read_value(const JsonDocument& document, const JsonNode& node, const Range& range, Double3& value) {
  return read_vector(document, node, range, value);
}

bool read_value(const JsonDocument&, const JsonNode& node, const Range&, std::string& value) {
  if (node.kind != JsonKind::string) return false;
  value = node.string;
  return true;
}

bool read_value(const JsonDocument&, const JsonNode& node, const Range&, PathText& value) {
  // A path with a zero byte would name another file than it shows.
  if (node.kind != JsonKind::string || node.string.empty() || node.string.find('\0') != std::string_view::npos)
    return false;
  value.given = node.string;
  return true;
}

bool read_value(const JsonDocument&, const JsonNode& node, const Range&, FragmentFunctionName& value) {
  value.given = true;
  if (node.kind != JsonKind::string) return false;
  for_each_fragment_function([&](auto function, std::size_t index) {
    if (node.string == function.name) value.index = index;
  });
  for (std::size_t i = 0; i < value.user_functions.size(); ++i)
    if (node.string == value.user_functions[i]->name()) value.index = std::variant_size_v<FragmentFunction> + i;
  return value.index.has_value();
}

bool is_word(const JsonDocument& document, const JsonNode& node, std::string_view word) {
  const bool is_string = node.kind == JsonKind::string, literal = word == "true" || word == "false";
  return is_string != literal && (is_string ? node.string : document.source(node)) == word;
}

bool read_value(const JsonDocument& document, const JsonNode& node, const Range&, NamedValue& value) {
  for (std::size_t i = 0; i < value.names.size(); ++i) {
    if (!is_word(document, node, value.names[i])) continue;
    value.index = i;
    return true;
  }
  return false;
}

} // namespace refraster
