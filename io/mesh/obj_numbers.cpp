#include "io/mesh/obj_numbers.h"

#include <algorithm>
#include <cmath>

namespace refraster {
bool is_not_finite(std::string_view word) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  const auto letters = [&word](std::string_view lower) {
    return word.size() >= lower.size() && std::equal(lower.begin(), lower.end(), word.begin(), [](char l, char c) {
             return l == ('A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c);
           });
  };
  if (letters("1.#ind") || letters("1.#qnan") || letters("1.#snan") || letters("1.#inf"))
    return word.find_first_not_of("0123456789", word.find_last_of("DdNnFf") + 1) == std::string_view::npos;
  if (letters("nan")) return word.size() == 3 || (word[3] == '(' && word.ends_with(')'));
  return (letters("inf") && word.size() == 3) || (letters("infinity") && word.size() == 8);
}

NumberText read_coordinate(std::string_view word, float& value) {
  const NumberText read = read_number(word, value);
  return read == NumberText::not_a_number && is_not_finite(word) ? NumberText::not_finite : read;
}

bool rounding_may_matter(const Float3& point, const Float3& before) {
  float apart = 0, largest = 0;
  for (int c = 0; c < 3; ++c) {
    apart = std::max(apart, std::abs(point[c] - before[c]));
    largest = std::max(largest, std::abs(point[c]));
  }
  return apart < 1001 * 0x1p-24f * largest; // a little more than 1000, for the roundings of this
}

} // namespace refraster
