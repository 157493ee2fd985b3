#pragma once
// Numbers for what is equal, in the order in which it first appears, by several threads.

#include "io/parallel/pieces.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace refraster {

/// Of each i in [0, count), first(i) is the first one that is equal to it, itself if there is none before, or negative:
/// then it has the number -1. Others have the number of their first, and these are numbered from 0 on in their order;
/// is_first(i, number) is called for each. Gives how many there are: the same for any number of threads.
template <class First, class IsFirst>
std::uint32_t number_firsts(int threads, std::size_t count, const First& first, std::int32_t* numbers,
                            const IsFirst& is_first) {
  constexpr std::size_t block = 1 << 15; // that a thread takes at a time
  const std::size_t blocks = (count + block - 1) / block;
  const auto each = [&](std::size_t b, const auto& body) {
    for (std::size_t i = b * block; i < std::min((b + 1) * block, count); ++i) body(i, first(i));
  };
  const auto stands_for_itself = [](std::size_t i, std::int64_t of) { return of == static_cast<std::int64_t>(i); };
  std::vector<std::uint32_t> next(blocks + 1); // of each block, the first number
  for_pieces(threads, blocks, [&](std::size_t b, int) {
    std::uint32_t firsts = 0;
    each(b, [&](std::size_t i, std::int64_t of) { firsts += stands_for_itself(i, of); });
    next[b + 1] = firsts;
  });
  for (std::size_t b = 0; b < blocks; ++b) next[b + 1] += next[b];
  for_pieces(threads, blocks, [&](std::size_t b, int) {
    std::uint32_t number = next[b];
    each(b, [&](std::size_t i, std::int64_t of) {
      if (!stands_for_itself(i, of)) return;
      is_first(i, number);
      numbers[i] = static_cast<std::int32_t>(number++);
    });
  });
  for_pieces(threads, blocks, [&](std::size_t b, int) {
    each(b, [&](std::size_t i, std::int64_t of) {
      if (of < 0) numbers[i] = -1;
      else if (!stands_for_itself(i, of)) numbers[i] = numbers[of];
    });
  });
  return next[blocks];
}

} // namespace refraster
