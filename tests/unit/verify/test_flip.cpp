#include "verify/compare/flip.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace refraster;

namespace {

int level_a(int x, int y, int c) {
  return (x * (c + 2) * 3 + y * (5 - c) * 2) % 200 + 20;
}

/// The same with a block of another colour and a grid of dots.
int level_b(int x, int y, int c) {
  int level = level_a(x, y, c);
  if (x >= 20 && x < 36 && y >= 10 && y < 30) level = c == 0 ? level / 2 : level + 30;
  if ((x + y) % 7 == 0) level += 4;
  return std::min(level, 255);
}

Image<float> image_of(int (*level)(int x, int y, int c)) {
  Image<float> image(64, 48, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(level(x, y, c));
  return image;
}

} // namespace

TEST_CASE("FLIP is that of its authors") {
  // NVlabs/flip (src/cpp/FLIP.h, 67.0206 pixels per degree) gives 0.0952615 for this pair. It computes in float: its
  // filters of 21 taps and its cube roots leave 2^-24 times some hundred.
  CHECK(std::abs(mean_flip(image_of(level_a), image_of(level_b)) - 0.0952615) < 1e-5);
}

TEST_CASE("FLIP of an image with itself is 0, and of two images the same both ways") {
  const Image<float> a = image_of(level_a), b = image_of(level_b);
  CHECK(mean_flip(a, a) == 0);
  CHECK(mean_flip(a, b) == mean_flip(b, a));
}
