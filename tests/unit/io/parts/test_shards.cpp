// Parts of images and of frames.

#include "io/parts/shard.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace refraster {

TEST_CASE("a part is I/N, I from 1 to N") {
  CHECK(shard_from("2/8") == Shard{2, 8});
  CHECK(shard_text({2, 8}) == "2/8");
  for (const char* const wrong : {"", "2", "0/2", "3/2", "1/", "/2", "1/2x", "-1/2", "1.5/2", "1/99999999999"})
    CHECK_FALSE(shard_from(wrong));
}

TEST_CASE("bands of rows are the image: each row once, in order, none higher by more than one than another") {
  for (const int height : {1, 2, 3, 64, 1080, 16383, 16384})
    for (const int parts : {1, 2, 3, 7, 64, 1000, 16384, 20000}) {
      int next = 0, lowest = height, highest = 0;
      for (int part = 1; part <= parts; ++part) {
        const RowRange rows = rows_of({part, parts}, height);
        REQUIRE(rows.first == next);
        next += rows.count;
        lowest = std::min(lowest, rows.count), highest = std::max(highest, rows.count);
      }
      INFO(height, " rows, ", parts, " parts");
      CHECK(next == height);
      CHECK(highest - lowest <= 1);
    }
  // 31 bits of parts times 15 of rows.
  constexpr int many = 2147483647;
  CHECK(rows_of({many, many}, 16384) == RowRange{16383, 1});
}

TEST_CASE("each frame is of exactly one part, and parts differ by at most one frame") {
  for (const std::size_t frames : {1U, 5U, 72U, 100U})
    for (const int parts : {1, 2, 3, 7, 72, 200}) {
      std::vector<std::size_t> counts(static_cast<std::size_t>(parts));
      for (std::size_t i = 0; i < frames; ++i) {
        int owners = 0;
        for (int part = 1; part <= parts; ++part)
          if (has_frame({part, parts}, i)) ++owners, ++counts[static_cast<std::size_t>(part - 1)];
        CHECK(owners == 1);
      }
      CHECK(*std::max_element(counts.begin(), counts.end()) - *std::min_element(counts.begin(), counts.end()) <= 1);
    }
}

} // namespace refraster
