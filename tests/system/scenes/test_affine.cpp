// Affine bounds of whole pixels: the sample of each anywhere in a box, in any arithmetic of a budget.

#include "math/bounds/affine_functions.h"
#include "raster/render_in.h"
#include "tests/support/random.h"
#include "tests/support/scenes/listed_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

namespace refraster {
namespace {

using Bounds = Affine<FloatArithmetic>;
using Range = Interval<FloatArithmetic>;

/// Half a subpixel, by snapping, and a little.
constexpr double reach = 0.6;

double at_rank(std::vector<double> values, double rank) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(rank * static_cast<double>(values.size() - 1))];
}

/// Bounds over the box hold what exact arithmetic makes of samples in it, and the precision `float` of that in the
/// middle; they are never wider than ranges, and half of them much narrower.
void check_samples_in_a_box(const Scene& scene, int positions) {
  RenderOptions options;
  options.width = 64, options.height = 36;
  SampleRequest<Bounds> anywhere;
  anywhere.dx = Affine<DoubleArithmetic>::along(Symbol::shift_x, 0, reach);
  anywhere.dy = Affine<DoubleArithmetic>::along(Symbol::shift_y, 0, reach);
  const Image<Bounds> bounds = render_in<Bounds>(scene, options, anywhere);
  SampleRequest<Range> in_range;
  in_range.dx = in_range.dy = {-reach, reach};
  const Image<Range> ranges = render_in<Range>(scene, options, in_range);
  RenderOptions plain = options;
  plain.precision = Precision::float_;
  plain.want_rgb8 = false, plain.want_radiance_double = true;
  const Frame in_float = render(scene, plain);

  std::size_t outside = 0, wider = 0;
  std::vector<double> width, of_range, narrower;
  std::vector<std::pair<double, double>> spread;
  for (std::size_t i = 0; i < bounds.values.size(); ++i) {
    const double found = in_float.radiance_double.values[i];
    outside += !bounds.values[i].contains(found);
    wider += bounds.values[i].lo < ranges.values[i].lo || bounds.values[i].hi > ranges.values[i].hi;
    spread.emplace_back(found, found);
    if (ranges.values[i].is_point()) continue;
    width.push_back(bounds.values[i].width() * 255);
    of_range.push_back(ranges.values[i].width() * 255);
    narrower.push_back(ranges.values[i].width() / bounds.values[i].width());
  }
  Random random(1);
  for (int k = 0; k < positions; ++k) {
    SampleRequest<Exact> there;
    const bool corner = k < 4;
    there.dx = Exact(corner ? (k & 1 ? reach : -reach) : random.uniform(-reach, reach));
    there.dy = Exact(corner ? (k & 2 ? reach : -reach) : random.uniform(-reach, reach));
    const Image<Exact> exact = render_in<Exact>(scene, options, there);
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
      const Exact& x = exact.values[i];
      outside += !(Exact(bounds.values[i].lo) <= x && x <= Exact(bounds.values[i].hi));
      spread[i].first = std::min(spread[i].first, static_cast<double>(x));
      spread[i].second = std::max(spread[i].second, static_cast<double>(x));
    }
  }
  CHECK(outside == 0);
  CHECK(wider == 0);
  CHECK(at_rank(narrower, 0.5) >= 2);
  if (std::getenv("REFRASTER_PRINT")) {
    std::vector<double> ratio;
    for (std::size_t i = 0; i < spread.size(); ++i)
      if (spread[i].second > spread[i].first)
        ratio.push_back(bounds.values[i].width() / (spread[i].second - spread[i].first));
    MESSAGE("levels: " << at_rank(width, 0.5) << " / " << at_rank(width, 0.95) << " / " << at_rank(width, 1)
                       << ", of ranges " << at_rank(of_range, 0.5) << " / " << at_rank(of_range, 0.95)
                       << ", over the spread " << at_rank(ratio, 0.5) << " / " << at_rank(ratio, 0.95));
  }
}

} // namespace

TEST_CASE(
    "affine bounds over a box of sample positions hold what is made of its corners, and are narrower than ranges") {
  check_samples_in_a_box(listed_scene(quick_scenes().front()), 4);
}

TEST_SUITE("slow") {
  TEST_CASE("so they are in other scenes, and hold what is made of other positions") {
    for (const std::string& path : quick_scenes()) {
      CAPTURE(path);
      check_samples_in_a_box(listed_scene(path), 8);
    }
  }
}

} // namespace refraster
