#pragma once
// Pieces of one file, shared by threads where there are several.

#include "raster/parallel.h"

#include <cstddef>

namespace refraster {

/// As parallel_for, but one thread's work is done at once, without asking for the runtime of the threads: that takes a
/// megabyte and some milliseconds when a process first needs it, which reading a small file must not.
template <class Body>
void for_pieces(int threads, std::size_t count, const Body& body) {
  if (threads > 1 && count > 1) return parallel_for(threads, count, body);
  for (std::size_t i = 0; i < count; ++i) body(i, 0);
}

} // namespace refraster
