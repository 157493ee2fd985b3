#pragma once
// One loop over independent pieces of work, shared by threads.

#include <cstddef>
#include <functional>

namespace refraster {

/// Calls body(index, thread) once for each index in [0, count). Threads take the next index, in rising order, when they
/// are done with one; 0 <= thread < threads names who called, so that each may have scratch memory of its own. What
/// `body` throws ends the loop as soon as the other threads are done with their index, and is thrown from here: the
/// first, if there are several.
void parallel_for(int threads, std::size_t count, const std::function<void(std::size_t index, int thread)>& body);

} // namespace refraster
