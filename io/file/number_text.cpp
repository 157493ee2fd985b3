#include "io/file/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace refraster {
namespace {

/// Of a decimal number out of range, which end it is out of: whether it is at least 1.
bool is_large(std::string_view digits) {
  const std::size_t e = std::min(digits.find_first_of("eE"), digits.size());
  const std::size_t point = std::min(digits.substr(0, e).find('.'), e);
  const std::size_t first = digits.substr(0, e).find_first_of("123456789");
  // The power of ten of the first digit that is not 0. Digits are fewer than 2^58, so the sum cannot overflow …
  const auto place = static_cast<long long>(point) - static_cast<long long>(first) - (first < point ? 1 : 0);
  if (e == digits.size()) return place >= 0;
  std::string_view exponent = digits.substr(e + 1);
  const bool down = exponent.front() == '-';
  if (down || exponent.front() == '+') exponent.remove_prefix(1);
  long long power = 0;
  for (const char digit : exponent) power = std::min(power * 10 + (digit - '0'), 1LL << 58); // … once this is bounded
  return place + (down ? -power : power) >= 0;
}

} // namespace

template <std::floating_point F>
NumberText read_number(std::string_view word, F& value) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-') || word.starts_with('+')) return NumberText::not_a_number;
  }
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return NumberText::not_a_number;
  if (error == std::errc::result_out_of_range) {
    const bool negative = word.starts_with('-');
    if (is_large(word.substr(negative ? 1 : 0))) return NumberText::not_finite;
    value = negative ? -F(0) : F(0);
  }
  return std::isfinite(value) ? NumberText::good : NumberText::not_finite;
}

template NumberText read_number(std::string_view, float&);
template NumberText read_number(std::string_view, double&);

} // namespace refraster
