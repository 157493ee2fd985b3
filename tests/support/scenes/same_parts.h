#pragma once
// One frame however it is made: by any number of threads, in tiles of any size, or in part.

#include "tests/support/invariants.h"

#include <refraster/render.h>

#include <doctest/doctest.h>

#include <algorithm>

namespace refraster::test {

/// A scene has the same bits for every number of threads, tile size and crop. `options` ask for radiance in double, and
/// for more than 53 x 37 pixels.
inline void check_same_parts(const Scene& scene, RenderOptions options) {
  options.threads = 1;
  const Frame whole = render(scene, options);
  for (const int threads : {2, 5})
    for (const int tile_size : {8, 32, 128}) {
      RenderOptions other = options;
      other.threads = threads, other.tile_size = tile_size;
      CHECK(difference(render(scene, other), whole) == "");
    }
  options.crop = PixelRect{13, 7, 40, 30};
  const Frame part = render(scene, options);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x)
      CHECK(std::equal(part.radiance_double.at(x, y), part.radiance_double.at(x, y) + 3,
                       whole.radiance_double.at(x + 13, y + 7)));
}

} // namespace refraster::test
