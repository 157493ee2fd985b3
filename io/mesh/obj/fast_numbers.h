#pragma once
// Numbers as nearly every OBJ file has them, read in one go; what is unusual is left to the careful reader.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace refraster {

/// Powers of ten that are whole numbers of 53 bits: exact.
inline constexpr std::array<double, 23> powers_of_ten = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                         1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                         1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Whether d, which may be two units in the last place off, rounds to the float that the number behind it rounds to:
/// unless it lies at the middle between two floats, within twice that. For d >= 0.
inline bool rounds_safely(double d) {
  // 29 bits of a double are beyond a float's last one; the middle is where the highest of them stands alone.
  constexpr std::uint64_t beyond = (std::uint64_t{1} << 29) - 1, middle = std::uint64_t{1} << 28, off = 4;
  const std::uint64_t rest = std::bit_cast<std::uint64_t>(d) & beyond;
  return rest - (middle - off) > 2 * off && d >= static_cast<double>(std::numeric_limits<float>::min()) &&
         d <= static_cast<double>(std::numeric_limits<float>::max());
}

/// A decimal number, `-1`, `+.5`, `2e-3`, rounded once to the nearest float, as read_number rounds it; behind the last
/// character of it, or null for what is none, and for some that are: then `value` says nothing. The text must end in
/// something that is part of no number. After W. D. Clinger, "How to read floating point numbers accurately", 1990.
inline const char* fast_float(const char* at, float& value) {
  const bool negative = *at == '-';
  at += negative || *at == '+';
  std::uint64_t digits = 0;
  const auto is_digit = [](char c) { return static_cast<unsigned char>(c - '0') < 10; };
  const char* const whole = at;
  for (; is_digit(*at); ++at) digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
  std::ptrdiff_t count = at - whole;
  int exponent = 0;
  if (*at == '.') {
    const char* const fraction = ++at;
    for (; is_digit(*at); ++at) digits = 10 * digits + static_cast<std::uint64_t>(*at - '0');
    exponent = -static_cast<int>(at - fraction);
    count += at - fraction;
  }
  // 19 digits are below 2^64.
  if (count == 0 || count > 19) return nullptr;
  if (*at == 'e' || *at == 'E') {
    ++at;
    const bool down = *at == '-';
    at += down || *at == '+';
    int power = 0;
    const char* const begin = at;
    for (; is_digit(*at); ++at) power = 10 * power + (*at - '0');
    if (at == begin || at - begin > 4) return nullptr;
    exponent += down ? -power : power;
  }
  double d = 0;
  if (digits != 0) {
    // Off by half a unit in the last place where there are more than 53 bits, and by half a unit from the power: by
    // two units in all, since a unit may double between them.
    d = static_cast<double>(digits);
    if (exponent < -22 || exponent > 22) return nullptr;
    if (exponent < 0) d /= powers_of_ten[static_cast<std::size_t>(-exponent)];
    else d *= powers_of_ten[static_cast<std::size_t>(exponent)];
    if (!rounds_safely(d)) return nullptr;
  }
  value = static_cast<float>(negative ? -d : d);
  return at;
}

/// An integer of at most nine digits, `12`, `-3`; behind its last character, or null for anything else.
inline const char* fast_integer(const char* at, std::int32_t& value) {
  const bool negative = *at == '-';
  at += negative;
  const char* const begin = at;
  std::uint32_t sum = 0;
  for (; static_cast<unsigned char>(*at - '0') < 10; ++at) sum = 10 * sum + static_cast<std::uint32_t>(*at - '0');
  if (at == begin || at - begin > 9) return nullptr;
  value = negative ? -static_cast<std::int32_t>(sum) : static_cast<std::int32_t>(sum);
  return at;
}

} // namespace refraster
