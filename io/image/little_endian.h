#pragma once
// Numbers in files of little-endian order.

#include <bit>
#include <cstring>
#include <string>
#include <string_view>

namespace refraster {

static_assert(std::endian::native == std::endian::little);

/// The number at a place; the bytes must reach that far.
template <class Value>
Value little_endian(std::string_view bytes, std::size_t at) {
  Value value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

template <class Value>
void append_little_endian(std::string& bytes, Value value) {
  char place[sizeof value];
  std::memcpy(place, &value, sizeof value);
  bytes.append(place, sizeof value);
}

} // namespace refraster
