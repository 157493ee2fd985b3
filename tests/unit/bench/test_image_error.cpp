#include "bench/measure/image_error.h"
#include "bench/measure/precision_errors.h"
#include "bench/workloads/built_in.h"

#include <doctest/doctest.h>

using namespace refraster;
using namespace refraster::bench;

namespace {

/// 2 x 2 pixels of grey; the last shows nothing.
Frame grey(const std::vector<double>& radiance, const std::vector<int>& levels) {
  Frame frame;
  frame.rgb8 = Image<std::uint8_t>(2, 2, 3);
  frame.radiance_double = Image<double>(2, 2, 3);
  frame.aovs.emplace_back(2, 2, 1, 1.0f);
  frame.aovs[0].values[3] = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    frame.rgb8.values[i] = static_cast<std::uint8_t>(levels[i / 3]);
    frame.radiance_double.values[i] = radiance[i / 3];
  }
  return frame;
}

} // namespace

TEST_CASE("errors are those of the worst channel of pixels that show a surface") {
  const Frame reference = grey({0.5, 0, 3, 1}, {128, 0, 255, 255});
  Frame other = grey({0.5, 0, 3, 0}, {128, 0, 255, 0});
  ImageError none = image_error(other, reference);
  CHECK(none.pixels == 3);
  CHECK(none.levels.max == 0);
  CHECK(none.relative.max == 0);

  other.radiance_double.values[1] = 0.25; // green of the first pixel
  other.rgb8.values[1] = 64;
  other.radiance_double.values[3] = 1.0 / 255; // red of the second, black in the reference
  other.rgb8.values[3] = 1;
  other.radiance_double.values[8] = 2; // blue of the third: not told apart on a screen
  const ImageError some = image_error(other, reference);
  CHECK(some.levels.max == doctest::Approx(0.25 * 255));
  CHECK(some.levels.mean == doctest::Approx((0.25 * 255 + 1) / 3));
  CHECK(some.relative.max == 0.5);
  CHECK(some.relative.mean == doctest::Approx((0.5 + 1.0 / 3) / 2)); // without the black pixel
  CHECK(some.off_by_one == 1);
  CHECK(some.off_by_more == 1);
}

TEST_CASE("999 of 1000 pixels keep to p99_9") {
  Frame reference, frame;
  for (Frame* const one : {&reference, &frame}) {
    one->rgb8 = Image<std::uint8_t>(1000, 1, 3);
    one->radiance_double = Image<double>(1000, 1, 3, 0.5);
    one->aovs.emplace_back(1000, 1, 1, 1.0f);
  }
  frame.radiance_double.values[300] = 1; // one pixel is far off, and another one a little
  frame.radiance_double.values[600] = 0.75;
  const ImageError error = image_error(frame, reference);
  CHECK(error.levels.max == doctest::Approx(127.5));
  CHECK(error.levels.p99_9 == doctest::Approx(63.75));
}

TEST_CASE("on the built-in sphere double is right to 1e-12 on average, and no level of float is off by more than one") {
  const SceneTask task{.name = "",
                       .scene = built_in_scene(),
                       .width = 320,
                       .height = 180,
                       .precisions = {"double", "float"},
                       .threads = {1}};
  const std::vector<PrecisionError> errors = precision_errors(task, 2);
  REQUIRE(errors.size() == 2);
  CHECK_FALSE(errors[0].against_double);
  CHECK(errors[0].against_exact.pixels == 400);
  CHECK(errors[0].against_exact.mean_relative <= 1e-12); // the goal; it is 1e-16
  CHECK(errors[0].against_exact.mean_relative > 0);
  REQUIRE(errors[1].against_double);
  CHECK(errors[1].against_double->pixels == 320 * 180);
  CHECK(errors[1].against_double->off_by_more == 0);
  CHECK(errors[1].against_exact.mean_relative > errors[0].against_exact.mean_relative);
}

TEST_CASE("images that are too large are not compared") {
  const SceneTask task{
      .name = "", .scene = built_in_scene(), .width = 16384, .height = 1025, .precisions = {"float"}, .threads = {1}};
  CHECK(precision_errors(task, 1).empty());
}
