#pragma once
// Tables for the tests of measured reflection.

#include <refraster/material.h>

#include "tests/support/shading/directions.h"
#include "tests/support/shading/table_samples.h"

#include <memory>

namespace refraster {

/// A table whose value at (h, d, p) is f(h, d, p).
template <class F>
std::shared_ptr<const MerlTable> table_of(F&& f) {
  return std::make_shared<const MerlTable>(table_samples(f));
}

/// Random values; a third of the samples was never measured, so that there are cells with every number of them.
inline std::shared_ptr<const MerlTable> ragged_table() {
  static const auto table = [] {
    std::mt19937_64 random(1);
    return table_of([&](int, int, int) {
      if (random() % 3 == 0) return Rgb<double>(-1);
      return Rgb<double>{uniform(random, 0, 5), uniform(random, 0, 1), random_scale(random, -4, 4)};
    });
  }();
  return table;
}

} // namespace refraster
