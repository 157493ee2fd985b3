#include "io/parts/shard.h"

#include <charconv>
#include <cstdint>

namespace refraster {

std::optional<Shard> shard_from(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, shard.part);
  if (error != std::errc() || slash == end || *slash != '/') return std::nullopt;
  const auto [last, second_error] = std::from_chars(slash + 1, end, shard.of);
  if (second_error != std::errc() || last != end || shard.part < 1 || shard.part > shard.of) return std::nullopt;
  return shard;
}

std::string shard_text(const Shard& shard) {
  return std::to_string(shard.part) + "/" + std::to_string(shard.of);
}

RowRange rows_of(const Shard& shard, int height) {
  // In 64 bits: a height has 15 of them, a number of parts 31.
  const auto begin = [&](std::int64_t part) { return static_cast<int>(part * height / shard.of); };
  return {begin(shard.part - 1), begin(shard.part) - begin(shard.part - 1)};
}

bool has_frame(const Shard& shard, std::size_t i) {
  return i % static_cast<std::size_t>(shard.of) == static_cast<std::size_t>(shard.part - 1);
}

std::string part_name(const std::string& path, const Shard& shard) {
  return path + ".part-" + std::to_string(shard.part) + "-of-" + std::to_string(shard.of);
}

} // namespace refraster
