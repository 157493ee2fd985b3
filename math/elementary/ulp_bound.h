#pragma once

namespace refraster {

/// Bounds on the error of a function, in units in the last place of its exact result: 0.5 is a correctly rounded one.
/// The tests measure both against 60 digits.
struct UlpBound {
  double max;    // never more
  double mostly; // 99 of 100 results
};

} // namespace refraster
