// Affine bounds of whole pixels: the sample of each anywhere in a box, in any arithmetic of a budget.

#include "math/bounds/affine_functions.h"
#include "math/bounds/device_arithmetic.h"
#include "raster/render_in.h"
#include "tests/support/perturbed.h"
#include "tests/support/scenes/listed_scenes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace refraster {

/// Edge functions are exact up to one rounding.
template <class Budget>
struct EdgeArithmetic<Perturbed<Budget>> {
  using Value = double;
  static Value whole(Int128 x) { return static_cast<double>(x); }
  static Perturbed<Budget> rounded(const Value& x) { return Perturbed<Budget>::of(x); }
};

namespace {

double at_rank(std::vector<double> values, double rank) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[static_cast<std::size_t>(rank * static_cast<double>(values.size() - 1))];
}

/// Bounds over the box hold what exact arithmetic and bad devices make of samples in it, and the precision `float` of
/// that in the middle. `reach`, in subpixels: half of one, by snapping, and a little; or 0, for roundings alone. They
/// are never wider than ranges, and half of them much narrower.
template <class Budget>
void check_samples_in_a_box(const Scene& scene, double reach, int positions, const std::function<void()>& enter = {}) {
  using Device = Perturbed<Budget>;
  using Bounds = Affine<Budget>;
  using Range = Interval<Budget>;
  RenderOptions options;
  options.width = 64, options.height = 36;
  SampleRequest<Bounds> anywhere;
  anywhere.enter = enter;
  anywhere.dx = Affine<DoubleArithmetic>::along(Symbol::shift_x, 0, reach);
  anywhere.dy = Affine<DoubleArithmetic>::along(Symbol::shift_y, 0, reach);
  const Image<Bounds> bounds = render_in<Bounds>(scene, options, anywhere);
  SampleRequest<Range> in_range;
  in_range.enter = enter;
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
    // Where more of a texture may be read than a device's budget reads, nothing is known; ranges read it all.
    const bool unknown = requires {
      Budget::max_samples;
    }
    &&bounds.values[i].width() >= Budget::largest;
    wider += !unknown && (bounds.values[i].lo < ranges.values[i].lo || bounds.values[i].hi > ranges.values[i].hi);
    spread.emplace_back(found, found);
    if (ranges.values[i].is_point()) continue;
    width.push_back(bounds.values[i].width() * 255);
    of_range.push_back(ranges.values[i].width() * 255);
    narrower.push_back(ranges.values[i].width() / bounds.values[i].width());
  }
  Random random(1);
  const auto move = [&](int k) {
    const bool corner = k < 4;
    return std::pair(corner ? (k & 1 ? reach : -reach) : random.uniform(-reach, reach),
                     corner ? (k & 2 ? reach : -reach) : random.uniform(-reach, reach));
  };
  const auto hold = [&](const auto& image) {
    for (std::size_t i = 0; i < image.values.size(); ++i) {
      const Exact x(image.values[i]);
      outside += !(Exact(bounds.values[i].lo) <= x && x <= Exact(bounds.values[i].hi));
      spread[i].first = std::min(spread[i].first, static_cast<double>(x));
      spread[i].second = std::max(spread[i].second, static_cast<double>(x));
    }
  };
  for (int k = 0; k < positions; ++k) {
    SampleRequest<Exact> there;
    const auto [dx, dy] = move(k);
    there.dx = Exact(dx), there.dy = Exact(dy);
    hold(render_in<Exact>(scene, options, there));
  }
  for (int k = 0; k < 4 * positions; ++k) {
    SampleRequest<Device> there;
    there.enter = enter;
    std::tie(there.dx, there.dy) = move(k);
    Image<double> values(options.width, options.height, 3);
    const Image<Device> found = render_in<Device>(scene, options, there);
    for (std::size_t i = 0; i < found.values.size(); ++i) values.values[i] = found.values[i].value;
    hold(values);
  }
  CHECK(outside == 0);
  CHECK(wider == 0);
  CHECK(at_rank(narrower, 0.5) >= (reach > 0 ? 2 : 1));
  std::vector<double> ratio;
  for (std::size_t i = 0; i < spread.size(); ++i)
    if (spread[i].second > spread[i].first)
      ratio.push_back(bounds.values[i].width() / (spread[i].second - spread[i].first));
  if (reach > 0 &&
      std::is_same_v<Budget, FloatArithmetic>) { // else roundings are most of it, which chance does not find
    CHECK(at_rank(ratio, 0.5) <= 1.3);
    CHECK(at_rank(ratio, 0.95) <= 2.5);
  }
  if (std::getenv("REFRASTER_PRINT"))
    MESSAGE("levels: " << at_rank(width, 0.5) << " / " << at_rank(width, 0.95) << " / " << at_rank(width, 1)
                       << ", of ranges " << at_rank(of_range, 0.5) << " / " << at_rank(of_range, 0.95)
                       << ", over the spread " << at_rank(ratio, 0.5) << " / " << at_rank(ratio, 0.95));
}

constexpr double half_subpixel = 0.6;

/// Of the numbers that interpolation starts from.
template <class Budget>
void check_rounded_edges() {
  using Edge = EdgeArithmetic<Affine<Budget>>;
  const double third = 1.0 / 3, error = Budget::relative * third * (1 - 0x1p-10);
  const Affine<Budget> once = Edge::rounded(typename Edge::Value(third));
  CHECK(once.contains(third - error));
  CHECK(once.contains(third + error));
  CHECK(once.width() <= 4 * error);
}

/// A triangle of which every row is the same.
struct SameRows {
  using Number = Affine<FloatArithmetic>;
  std::array<Number, 4> row(int) const { return {Number(0.1), Number(0.7), Number(0.3), Number(0)}; }
};

} // namespace

TEST_CASE("each component of position, normal and texture coordinates has a symbol of its own") {
  const SameRows::Number third = SameRows::Number(1) / SameRows::Number(3);
  for (int row = 0; row < uv_row + 2; ++row) {
    CAPTURE(row);
    const AffineForm form = interpolated(SameRows{}, row, Barycentric<SameRows::Number>{third, third}).form;
    for (std::size_t k = 0; k < AffineForm::symbols; ++k)
      CHECK((form.slope[k] > 0) == (k == static_cast<std::size_t>(first_row_symbol + row)));
    CHECK(form.rest == 0);
  }
}

TEST_CASE("the value of an edge function is rounded once") {
  check_rounded_edges<FloatArithmetic>();
  check_rounded_edges<DeviceArithmetic>();
}

TEST_CASE(
    "affine bounds over a box of sample positions hold what is made of its corners, and are narrower than ranges") {
  check_samples_in_a_box<FloatArithmetic>(listed_scene(quick_scenes().front()), half_subpixel, 4);
  check_samples_in_a_box<FloatArithmetic>(listed_scene(quick_scenes().front()), 0, 4);
}

TEST_CASE("so do those of a device that is known when the program runs") {
  OperationErrors vulkan;
  check_samples_in_a_box<DeviceArithmetic>(listed_scene(quick_scenes().front()), half_subpixel, 1,
                                           [&] { DeviceArithmetic::use(vulkan); });
}

TEST_SUITE("long") {
  TEST_CASE("so they are in other scenes, and hold what is made of other positions") {
    for (const std::string& path : quick_scenes()) {
      CAPTURE(path);
      check_samples_in_a_box<FloatArithmetic>(listed_scene(path), half_subpixel, 8);
      check_samples_in_a_box<FloatArithmetic>(listed_scene(path), 0, 8);
      check_samples_in_a_box<DeviceArithmetic>(listed_scene(path), half_subpixel, 2, [] { DeviceArithmetic::use({}); });
    }
  }
}

} // namespace refraster
