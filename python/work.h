#pragma once
// Long work, while Python goes on: its lock is released, Ctrl-C is seen, and how far it is can be asked.

#include "python/bindings.h"

#include <atomic>
#include <functional>

namespace refraster::python {

/// What work looks at, and writes to, while it runs.
struct Watch {
  std::atomic<bool> stop = false;    ///< becomes true when the work is to be given up
  std::atomic<double> fraction = -1; ///< done so far, in [0, 1]; negative: nobody has said

  /// For those who are called with how far the work is. Throws where the work is to be given up, which ends it if what
  /// calls lets exceptions through.
  std::function<void(double)> reporter();
};

/// Runs work(watch) in another thread, without Python's lock, and waits for its end. Meanwhile, twenty times a second,
/// the calling thread takes the lock, lets Python handle signals, and calls progress(fraction), unless that is None.
/// What either of them throws, as KeyboardInterrupt, sets watch.stop, and is thrown on once the work has ended; what
/// the work throws, likewise. Signals are Python's main thread's: called from another, Ctrl-C is not seen. The thread
/// is used again by the next call: its team of OpenMP's threads and its memory are there already.
void run_watched(const py::object& progress, const std::function<void(Watch&)>& work);

/// The same of work that owns all that it touches: where it does not end within a moment after it was told to, it is
/// left to do so unseen.
void run_or_leave(const py::object& progress, const std::function<void(Watch&)>& work);

} // namespace refraster::python
