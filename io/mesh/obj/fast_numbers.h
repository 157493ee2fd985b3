#pragma once
// Numbers as nearly every OBJ file has them, read in one go; what is unusual is left to the careful reader.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// Powers of ten that fit into 64 bits.
inline constexpr auto whole_powers_of_ten = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

/// Eight digits, the values 0 to 9 in eight bytes, the first one in the lowest: pairs, then fours, then all are joined,
/// by one multiplication each. After D. Lemire, "Number parsing at a gigabyte per second", 2021.
inline std::uint64_t joined_digits(std::uint64_t digits) {
  constexpr std::uint64_t lowest_of_four = 0x000000ff000000ff;
  digits = 10 * digits + (digits >> 8);
  return ((digits & lowest_of_four) * (100 + (std::uint64_t{1000000} << 32)) +
          (digits >> 16 & lowest_of_four) * (1 + (std::uint64_t{10000} << 32))) >>
         32;
}

/// Appends the digits from `at` on to a number, modulo 2^64; behind the last of them. The text goes on up to `end`, and
/// behind it with something that is no digit.
inline const char* take_digits(const char* at, const char* end, std::uint64_t& number) {
  if constexpr (std::endian::native == std::endian::little) {
    // Eight characters at a time: how many there are is then no branch, which no one could foresee.
    while (end - at >= 8) {
      std::uint64_t eight;
      std::memcpy(&eight, at, 8);
      eight ^= 0x3030303030303030; // "00000000"
      // The highest bit of each byte above 9; a carry goes only into bytes behind one of these.
      const std::uint64_t others = ((eight + 0x7676767676767676) | eight) & 0x8080808080808080;
      const int count = std::countr_zero(others) / 8;
      number = number * whole_powers_of_ten[static_cast<std::size_t>(count)] +
               joined_digits(count == 8 ? eight : eight << 8 << (56 - 8 * count));
      at += count;
      if (count < 8) return at;
    }
  }
  for (; static_cast<unsigned char>(*at - '0') < 10; ++at) number = 10 * number + static_cast<std::uint64_t>(*at - '0');
  return at;
}

/// A decimal number, `-1`, `+.5`, `2e-3`, rounded once to the nearest float, as read_number rounds it; behind the last
/// character of it, or null for what is none, and for some that are: then `value` says nothing. The text goes on up to
/// `end`, and behind it with something that is part of no number. After W. D. Clinger, "How to read floating point
/// numbers accurately", 1990.
inline const char* fast_float(const char* at, const char* end, float& value) {
  const bool negative = *at == '-';
  at += negative || *at == '+';
  std::uint64_t digits = 0;
  const char* const whole = at;
  at = take_digits(at, end, digits);
  std::ptrdiff_t count = at - whole;
  int exponent = 0;
  if (*at == '.') {
    const char* const fraction = ++at;
    at = take_digits(at, end, digits);
    exponent = -static_cast<int>(at - fraction);
    count += at - fraction;
  }
  // 19 digits are below 2^64.
  if (count == 0 || count > 19) return nullptr;
  if (*at == 'e' || *at == 'E') {
    ++at;
    const bool down = *at == '-';
    at += down || *at == '+';
    std::uint64_t power = 0;
    const char* const begin = at;
    at = take_digits(at, end, power);
    if (at == begin || at - begin > 4) return nullptr;
    exponent += down ? -static_cast<int>(power) : static_cast<int>(power);
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

/// An integer of at most nine digits, `12`, `-3`; behind its last character, or null for anything else. The text is as
/// above.
inline const char* fast_integer(const char* at, const char* end, std::int32_t& value) {
  const bool negative = *at == '-';
  at += negative;
  const char* const begin = at;
  std::uint64_t number = 0;
  at = take_digits(at, end, number);
  if (at == begin || at - begin > 9) return nullptr;
  value = negative ? -static_cast<std::int32_t>(number) : static_cast<std::int32_t>(number);
  return at;
}

} // namespace refraster
