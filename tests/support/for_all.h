#pragma once
// Laws are tested on random trials. The trial's number is its seed, so that a failure names the case to run again.

#include "tests/support/random.h"

#include <doctest/doctest.h>

namespace refraster {

/// law(random) for `trials` seeds. A failed CHECK names the seed.
template <class Law>
void for_all(int trials, const Law& law) {
  for (int seed = 0; seed < trials; ++seed) {
    INFO("seed = ", seed);
    Random random(static_cast<std::uint64_t>(seed));
    law(random);
  }
}

} // namespace refraster
