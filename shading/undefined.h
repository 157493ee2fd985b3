#pragma once
// Counting what the mathematics leaves undefined.

#include <refraster/frame.h>

#include "math/scalar.h"

#include <cstdint>

namespace refraster::inline REFRASTER_KIT {

/// Counts, in those lanes that hold a fragment.
template <class T>
class UndefinedTally {
public:
  UndefinedTally(UndefinedCounts& counts, const MaskOf<T>& in_use) : counts_(&counts), in_use_(in_use) {}

  void note(Undefined which, const MaskOf<T>& where) const {
    if (any(where)) (*counts_)[which] += static_cast<std::uint64_t>(count_lanes(where & in_use_));
  }

private:
  UndefinedCounts* counts_;
  MaskOf<T> in_use_;
};

} // namespace refraster::inline REFRASTER_KIT
