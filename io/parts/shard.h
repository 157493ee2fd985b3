#pragma once
// Part I of N of work that several machines do.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace refraster {

/// Part I of N, counted from 1.
struct Shard {
  int part = 1, of = 1;
  bool operator==(const Shard&) const = default;
};

/// "2/8".
std::optional<Shard> shard_from(std::string_view text);
std::string shard_text(const Shard& shard);

/// Rows of an image: `count` from `first` on.
struct RowRange {
  int first = 0, count = 0;
  bool operator==(const RowRange&) const = default;
};

/// Its band of an image: the bands of all parts are the image, one below the other, and differ by at most a row. Of
/// more parts than rows some are empty.
RowRange rows_of(const Shard& shard, int height);

/// Whether frame i, counted from 0, is the part's: every N-th is, since neighbours on a camera's way cost alike.
bool has_frame(const Shard& shard, std::size_t i);

/// "out/big.png" gives "out/big.png.part-2-of-8"; "out/turntable.json" likewise.
std::string part_name(const std::string& path, const Shard& shard);

} // namespace refraster
