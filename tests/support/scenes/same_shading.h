#pragma once
// Two scenes that are one but for who shades them: by a fragment function of the library, or by the same from outside.

#include "raster/render_in.h"
#include "tests/support/invariants.h"

#include <doctest/doctest.h>

namespace refraster::test {

/// They show the same bits in every precision, with AOVs and counts. look(frame) is called with each frame.
template <class Look>
void check_same_frames(const Scene& expected, const Scene& scene, const Look& look) {
  for (const auto& named : EnumNames<Precision>::names) {
    const Precision precision = named.first;
    CAPTURE(named.second);
    RenderOptions options{.width = 40, .height = 30, .precision = precision, .samples = 4, .threads = 2};
    if (precision == Precision::exact) options.width = 12, options.height = 9;
    options.want_radiance_double = true;
    options.aovs = {Aov::albedo, Aov::normal};
    const Frame frame = render(scene, options);
    CHECK(frame.counts.shaded > 10);
    CHECK(difference(frame, render(expected, options)) == "");
    look(frame);
  }
}

/// And the same bounds.
inline void check_same_bounds(const Scene& expected, const Scene& scene) {
  const RenderOptions options{.width = 16, .height = 12, .threads = 2};
  const auto check = [&]<class T>(T) {
    const Image<T> wanted = render_in<T>(expected, options), image = render_in<T>(scene, options);
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      REQUIRE(image.values[i].lo == wanted.values[i].lo);
      REQUIRE(image.values[i].hi == wanted.values[i].hi);
    }
  };
  check(Interval<DoubleArithmetic>(0));
  check(Interval<FloatArithmetic>(0));
}

} // namespace refraster::test
