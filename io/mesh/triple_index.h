#pragma once
// Numbers different triples of integers in the order in which they first appear.

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace refraster {

/// A hash table with open addressing: what takes most of the time of std::unordered_map here is its memory.
class TripleIndex {
public:
  using Triple = std::array<std::int32_t, 3>;

  /// Room for that many different triples.
  explicit TripleIndex(std::size_t most) : slots_(slots_for(most), -1) {}

  /// The number of the triple: size() before the call, if it is a new one.
  std::int32_t operator()(const Triple& triple) {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash(triple) & mask;
    while (slots_[slot] >= 0 && triples_[static_cast<std::size_t>(slots_[slot])] != triple) slot = (slot + 1) & mask;
    if (slots_[slot] < 0) {
      slots_[slot] = static_cast<std::int32_t>(triples_.size());
      triples_.push_back(triple);
    }
    return slots_[slot];
  }

  /// The triples by their numbers; it has none from then on.
  std::vector<Triple> take_triples() { return std::move(triples_); }
  std::size_t size() const { return triples_.size(); }

private:
  static std::size_t slots_for(std::size_t most) {
    std::size_t slots = 16;
    while (slots < 2 * most) slots *= 2; // at most half full
    return slots;
  }
  static std::size_t hash(const Triple& triple) {
    std::uint64_t h = 0;
    for (const std::int32_t x : triple) {
      h = (h ^ static_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u; // 2^64 / golden ratio: Knuth's multiplicative hash
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }

  std::vector<std::int32_t> slots_; // -1: free
  std::vector<Triple> triples_;
};

} // namespace refraster
