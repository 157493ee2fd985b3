#pragma once
// What a table of measured reflection is made of, by a formula.

#include <refraster/material.h>

namespace refraster {

/// The samples of a table whose value at (h, d, p) is f(h, d, p).
template <class F>
PaddedVector<double> table_samples(F&& f) {
  PaddedVector<double> rgb;
  rgb.reserve(3 * MerlTable::samples);
  for (int h = 0; h < 90; ++h)
    for (int d = 0; d < 90; ++d)
      for (int p = 0; p < 180; ++p) {
        const Rgb<double> value = f(h, d, p);
        rgb.insert(rgb.end(), {value.x, value.y, value.z});
      }
  return rgb;
}

} // namespace refraster
