#pragma once
// Comparisons that bounds leave open, followed one way and then the other.

#include "math/bounds/certainty.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace refraster::inline REFRASTER_KIT {

/// The paths that a formula may take where comparisons are open, one after the other. On this thread:
///
///     Forks forks;
///     do evaluate(); while (forks.next());
///
/// In each round the comparisons that bounds leave open are decided another way, until all have been followed or there
/// are too many: then is_complete() is false. While there is no Forks, open comparisons stay open, and are counted.
class Forks {
public:
  static constexpr std::size_t max_paths = 16, max_decisions = 16;

  Forks() { current() = this; }
  ~Forks() { current() = nullptr; }
  Forks(const Forks&) = delete;
  Forks& operator=(const Forks&) = delete;

  /// To the next path. False after the last, and after the most there may be.
  bool next() {
    if (met_ < decisions_) decisions_ = met_;
    while (decisions_ > 0 && yes_[decisions_ - 1] == 0) --decisions_;
    if (decisions_ == 0) return false;
    if (++paths_ >= max_paths) return complete_ = false;
    yes_[decisions_ - 1] = 0;
    met_ = 0;
    return true;
  }
  bool is_complete() const { return complete_; }

  /// Of an open comparison.
  static Certainty decided() {
    ++open_comparisons();
    return current() ? current()->decide() : Certainty::unknown;
  }
  /// How many this thread has met.
  static std::uint64_t& open_comparisons() {
    static thread_local constinit std::uint64_t count = 0;
    return count;
  }

private:
  Certainty decide() {
    if (met_ == max_decisions) {
      complete_ = false;
      return Certainty::unknown;
    }
    if (met_ == decisions_) yes_[decisions_++] = 1;
    return yes_[met_++] ? Certainty::yes : Certainty::no;
  }
  static Forks*& current() {
    static thread_local constinit Forks* forks = nullptr;
    return forks;
  }

  std::array<std::uint8_t, max_decisions> yes_{};
  std::size_t decisions_ = 0, met_ = 0, paths_ = 0;
  bool complete_ = true;
};

} // namespace refraster::inline REFRASTER_KIT
