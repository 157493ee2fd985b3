// Numbers worked out by hand on images of a few pixels.

#include "verify/compare/compare.h"
#include "verify/compare/compare_report.h"

#include <doctest/doctest.h>

#include <cassert>
#include <cmath>
#include <limits>

using namespace refraster;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

Image<float> image_of(int width, int height, int channels, std::vector<float> values) {
  Image<float> image(width, height, channels);
  assert(values.size() == image.values.size()); // not REQUIRE: doctest is not there yet when a and b are made
  image.values = std::move(values);
  return image;
}

Image<float> row(std::vector<float> values) {
  return image_of(static_cast<int>(values.size()), 1, 1, values);
}

// 2 x 2 pixels of 3 channels. Differences b - a: 0 0 0 | 3 0 0 | 0 -4 0 | 0 0 0.
const Image<float> a = image_of(2, 2, 3, {1, 2, 3, 10, 20, 30, 40, 50, 60, 7, 8, 9});
const Image<float> b = image_of(2, 2, 3, {1, 2, 3, 13, 20, 30, 40, 46, 60, 7, 8, 9});

} // namespace

TEST_CASE("levels: every number of a comparison, worked out by hand") {
  const Comparison found = compare(a, b, CompareUnit::levels, {});
  CHECK(found.unit == CompareUnit::levels);
  CHECK(found.pixels() == 4);
  CHECK(found.equal_pixels == 2);
  CHECK(found.pixels_over == 2);
  CHECK(found.incomparable_pixels == 0);
  CHECK(found.max == 4);
  CHECK(found.rms == std::sqrt(25.0 / 12)); // (9 + 16) / 12 values
  CHECK(found.psnr_db == 20 * std::log10(255 / std::sqrt(25.0 / 12)));
  CHECK(found.mean == std::vector<double>{0.75, -1, 0});
  CHECK_FALSE(found.same);
}

TEST_CASE("the worst pixel of a cluster comes with all values of both images") {
  const Comparison found = compare(a, b, CompareUnit::levels, {}); // its two pixels touch at a corner
  REQUIRE(found.worst.size() == 1);
  CHECK(found.worst[0].x == 0);
  CHECK(found.worst[0].y == 1);
  CHECK(found.worst[0].difference == 4);
  CHECK(found.worst[0].a == std::vector<double>{40, 50, 60});
  CHECK(found.worst[0].b == std::vector<double>{40, 46, 60});
}

TEST_CASE("of each cluster the worst pixel is listed, ten at most, and equals stay in the order of the image") {
  std::vector<float> zero(60, 0.0F), far(60, 0.0F);
  for (std::size_t i = 0; i < 60; ++i)
    if (i % 3 > 0) far[i] = i % 6 == 1 ? 2.0F : 1.0F; // twenty clusters of two, ten with a two in them
  Comparison found = compare(row(zero), row(far), CompareUnit::values, {});
  REQUIRE(found.cluster_count == 20);
  REQUIRE(found.worst.size() == 10);
  for (std::size_t i = 0; i < 10; ++i) {
    CHECK(found.worst[i].difference == 2);
    CHECK(found.worst[i].x == static_cast<int>(6 * i + 1));
  }
  far[59] = 3;
  found = compare(row(zero), row(far), CompareUnit::values, {});
  REQUIRE(found.worst.size() == 10);
  CHECK(found.worst[0].x == 59);
  CHECK(found.worst[9].x == 49); // the last two has gone
}

TEST_CASE("where all is within the limit, the worst pixels are of the clusters that differ at all") {
  const Comparison found = compare(row({0, 0, 0, 0}), row({1, 2, 0, 1}), CompareUnit::values, {.max_abs = 2});
  CHECK(found.same);
  CHECK(found.cluster_count == 0);
  REQUIRE(found.worst.size() == 2);
  CHECK(found.worst[0].x == 1);
  CHECK(found.worst[1].x == 3);
}

TEST_CASE("a limit of levels means the same for the same picture of 8 bits, of 16 bits and of floats") {
  std::vector<float> a8, b8, a16, b16, a_values, b_values;
  for (int level = 0; level <= 253; ++level) {
    a8.push_back(static_cast<float>(level)), b8.push_back(static_cast<float>(level + 2));
    a16.push_back(a8.back() * 257), b16.push_back(b8.back() * 257);
    a_values.push_back(a8.back() / 255), b_values.push_back(b8.back() / 255);
  }
  const auto check = [](const std::vector<float>& left, const std::vector<float>& right, double full_scale) {
    const PixelScale scale(full_scale, CompareUnit::levels);
    const Comparison within = compare(row(left), row(right), scale, {.max_abs = 2});
    CHECK(within.unit == CompareUnit::levels);
    CHECK(within.same);
    CHECK(within.max == doctest::Approx(2).epsilon(1e-5));
    CHECK(within.mean[0] == doctest::Approx(2).epsilon(1e-5));
    CHECK(compare(row(left), row(right), scale, {.max_abs = 1.999}).pixels_over == left.size());
    CHECK(compare(row(left), row(right), scale, {.max_abs = 1}).pixels_over == left.size());
    CHECK(within.psnr_db == doctest::Approx(20 * std::log10(255 / 2.0)).epsilon(1e-5));
  };
  check(a8, b8, 255);
  check(a16, b16, 65535);
  check(a_values, b_values, 1);
}

TEST_CASE("an image of 16 bits and its negative are not within 2 levels, and in values they differ by one") {
  const PixelScale levels(65535, CompareUnit::levels), values(65535, CompareUnit::values);
  CHECK_FALSE(compare(row({0, 65535}), row({65535, 0}), levels, {.max_abs = 2}).same);
  CHECK(compare(row({0, 65535}), row({65535, 0}), levels, {}).max == 255);
  CHECK(compare(row({0, 65535}), row({65535, 0}), values, {}).max == 1);
  CHECK(compare(row({0, 257}), row({257, 257}), levels, {}).worst[0].b == std::vector<double>{1});
}

TEST_CASE("limits of one unit in the other") {
  const CompareLimits limits =
      converted({.max_abs = 0.5, .max_rms = 2, .max_count = 3}, CompareUnit::values, CompareUnit::levels);
  CHECK(limits.max_abs == 127.5);
  CHECK(limits.max_rms == 510);
  CHECK(limits.max_count == 3);
  CHECK(converted(limits, CompareUnit::levels, CompareUnit::values).max_abs == 0.5);
}

TEST_CASE("an image equals itself, with infinite PSNR") {
  const Comparison found = compare(a, a, CompareUnit::levels, {});
  CHECK(found.same);
  CHECK(found.equal_pixels == 4);
  CHECK(found.rms == 0);
  CHECK(found.psnr_db == std::numeric_limits<double>::infinity());
  CHECK(found.worst.empty());
}

TEST_CASE("each limit judges alone, and a value at the limit passes") {
  CHECK(compare(a, b, CompareUnit::levels, {.max_abs = 4}).same);
  CHECK_FALSE(compare(a, b, CompareUnit::levels, {.max_abs = 3.9}).same);
  CHECK(compare(a, b, CompareUnit::levels, {.max_rms = std::sqrt(25.0 / 12)}).same);
  CHECK_FALSE(compare(a, b, CompareUnit::levels, {.max_rms = 1.44}).same);
  CHECK(compare(a, b, CompareUnit::levels, {.max_count = 2}).same);
  CHECK_FALSE(compare(a, b, CompareUnit::levels, {.max_count = 1}).same);
}

TEST_CASE("limits judge together: so many pixels over so much") {
  CHECK(compare(a, b, CompareUnit::levels, {.max_abs = 3, .max_count = 1}).same);
  CHECK_FALSE(compare(a, b, CompareUnit::levels, {.max_abs = 3, .max_count = 0}).same);
  CHECK_FALSE(compare(a, b, CompareUnit::levels, {.max_abs = 3, .max_rms = 1, .max_count = 1}).same);
}

TEST_CASE("NaN equals nothing, not even itself, and no limit excuses it") {
  const Comparison found = compare(row({not_a_number, not_a_number, 1, 2}), row({not_a_number, 0, not_a_number, 2}),
                                   CompareUnit::values, {});
  CHECK(found.incomparable_pixels == 3);
  CHECK(found.nan_pixels_a == 2);
  CHECK(found.nan_pixels_b == 2);
  CHECK(found.equal_pixels == 1);
  CHECK(found.max == 0);
  CHECK(found.rms == 0);
  CHECK_FALSE(found.same);
  CHECK_FALSE(compare(row({not_a_number}), row({not_a_number}), CompareUnit::values,
                      {.max_abs = 1e30, .max_rms = 1e30, .max_count = 100})
                  .same);
}

TEST_CASE("an infinity equals the same infinity only") {
  const Comparison found =
      compare(row({inf, -inf, inf, inf, 5}), row({inf, -inf, -inf, 1, inf}), CompareUnit::values, {});
  CHECK(found.equal_pixels == 2);
  CHECK(found.incomparable_pixels == 3);
  CHECK(found.nan_pixels_a == 0);
  CHECK(found.max == 0);
  CHECK(compare(row({inf, 1}), row({inf, 1}), CompareUnit::values, {}).same);
}

TEST_CASE("pixels without a difference are the worst, and do not touch the sums") {
  const Comparison found = compare(row({1, 3, not_a_number}), row({2, 3, 0}), CompareUnit::values, {});
  CHECK(found.max == 1);
  CHECK(found.rms == std::sqrt(0.5));
  CHECK(found.mean == std::vector<double>{0.5});
  REQUIRE(found.worst.size() == 2);
  CHECK(found.worst[0].x == 2);
  CHECK(std::isinf(found.worst[0].difference));
  CHECK(found.pixels_over == 2);
}

TEST_CASE("zeros of different sign are no difference, but not the same either") {
  const Comparison found = compare(row({0.0F}), row({-0.0F}), CompareUnit::values, {});
  CHECK(found.equal_pixels == 0);
  CHECK(found.zero_sign_pixels == 1);
  CHECK(found.max == 0);
  CHECK_FALSE(found.same);
  CHECK(compare(row({0.0F}), row({-0.0F}), CompareUnit::values, {.max_abs = 0}).same);
}

TEST_CASE("the difference of the smallest and of the largest floats is exact") {
  const float tiny = std::numeric_limits<float>::denorm_min(), huge = std::numeric_limits<float>::max();
  CHECK(compare(row({0}), row({tiny}), CompareUnit::values, {}).max == static_cast<double>(tiny));
  CHECK(compare(row({-huge}), row({huge}), CompareUnit::values, {}).max == 2.0 * static_cast<double>(huge));
}

TEST_CASE("the text begins with the verdict and shows the worst pixel") {
  const auto text = [](const CompareLimits& limits) {
    return comparison_text({"a.png", "b.png", limits, compare(a, b, CompareUnit::levels, limits)});
  };
  CHECK(text({}).starts_with("differ\n"));
  CHECK(text({.max_abs = 4}).starts_with("equal within max-abs 4 levels\n"));
  CHECK(text({.max_abs = 2}).starts_with("differ by more than max-abs 2 levels\n"));
  CHECK(comparison_text({"a.png", "a.png", {}, compare(a, a, CompareUnit::levels, {})}).starts_with("equal\n"));
  CHECK(text({}).find("(0, 1)  40 50 60  40 46 60  4\n") != std::string::npos);
}

TEST_CASE("a share is 100 % only if it is all") {
  Image<float> image(1000, 1000, 1), other = image;
  other.at(999, 999)[0] = 1;
  const auto text = [](const Image<float>& left, const Image<float>& right) {
    return comparison_text({"a", "b", {}, compare(left, right, CompareUnit::values, {})});
  };
  CHECK(text(image, other).find("999999     99.9999 %") != std::string::npos);
  CHECK(text(image, image).find("1000000    100 %") != std::string::npos);
}

TEST_CASE("the JSON holds full numbers, and null for what JSON has no number for") {
  const std::string json =
      comparison_json({"a", "b", {}, compare(row({not_a_number, 0.1F}), row({1, 0.1F}), CompareUnit::values, {})});
  CHECK(json.find("\"nan_in_a\": 1") != std::string::npos);
  CHECK(json.find("\"psnr_db\": null") != std::string::npos);
  CHECK(json.find("\"difference\": null") != std::string::npos);
  CHECK(json.find("\"same\": false") != std::string::npos);
}
