#include "io/html/base64.h"
#include "verify/page/packed.h"

#include "tests/support/random.h"
#include "tests/unit/verify/unpacked.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>

using namespace refraster;
using test::numbers_of;
using test::unpacked_rows;

namespace {

constexpr int sizes[][2] = {{1, 1}, {1, 7}, {8192, 1}, {5, 3}, {64, 48}};

/// Smooth in places and noise in others, so that every filter is the best one of some row.
Image<std::uint8_t> mixed_image(int width, int height, int channels, Random& random) {
  Image<std::uint8_t> image(width, height, channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        const int kinds[] = {random.below(256), 3 * x + c, 5 * y + x * x / 8, x * y / 4 + random.below(2), 77};
        image.at(x, y)[c] = static_cast<std::uint8_t>(kinds[(y / 3) % 5]);
      }
  return image;
}

Image<float> any_floats(int width, int height, int channels, Random& random) {
  Image<float> image(width, height, channels);
  for (float& value : image.values) value = std::bit_cast<float>(static_cast<std::uint32_t>(random.bits()));
  constexpr float inf = std::numeric_limits<float>::infinity();
  const float special[] = {0.0F, -0.0F, inf, -inf, std::numeric_limits<float>::quiet_NaN(), 1e-45F};
  std::copy_n(special, std::min<std::size_t>(6, image.values.size()), image.values.begin());
  return image;
}

std::vector<std::uint32_t> bits_of(const Image<float>& image) {
  std::vector<std::uint32_t> bits;
  for (const float value : image.values) bits.push_back(std::bit_cast<std::uint32_t>(value));
  return bits;
}

} // namespace

TEST_CASE("what is packed can be unpacked, bit for bit: bytes, whole numbers, floats with NaN") {
  Random random(1);
  for (const auto& size : sizes)
    for (const int channels : {1, 2, 3, 4}) {
      const int width = size[0], height = size[1];
      CAPTURE(width);
      CAPTURE(channels);
      const Image<std::uint8_t> bytes = mixed_image(width, height, channels, random);
      CHECK(unpacked_rows(packed(bytes), width, height, channels) == bytes.values);
      Image<std::uint32_t> ids(width, height, channels);
      for (std::uint32_t& id : ids.values) id = static_cast<std::uint32_t>(random.bits() >> (32 + random.below(32)));
      CHECK(numbers_of(unpacked_rows(packed(ids), width, 4 * height, channels)) == ids.values);
      const Image<float> floats = any_floats(width, height, channels, random);
      CHECK(numbers_of(unpacked_rows(packed(floats), width, 4 * height, channels)) == bits_of(floats));
    }
}

TEST_CASE("a packed difference is what is to be added, modulo 256 or to the bits") {
  Random random(2);
  const Image<std::uint8_t> a = mixed_image(40, 30, 3, random), b = mixed_image(40, 30, 3, random);
  const std::vector<std::uint8_t> left = unpacked_rows(packed_difference(b, a), 40, 30, 3);
  for (std::size_t i = 0; i < left.size(); ++i) CHECK(static_cast<std::uint8_t>(a.values[i] + left[i]) == b.values[i]);

  const Image<float> c = any_floats(40, 30, 3, random), d = any_floats(40, 30, 3, random);
  const std::vector<std::uint32_t> rest = numbers_of(unpacked_rows(packed_difference(d, c), 40, 120, 3));
  const std::vector<std::uint32_t> base = bits_of(c), goal = bits_of(d);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    // 2 |d|, less 1 where d is negative
    const std::uint32_t distance = rest[i] % 2 == 0 ? rest[i] / 2 : 0 - (rest[i] / 2 + 1);
    CHECK(base[i] + distance == goal[i]);
  }
}

TEST_CASE("of nearly equal images the second takes a small part of the first") {
  Random random(3);
  const Image<std::uint8_t> a = mixed_image(256, 256, 3, random);
  Image<std::uint8_t> b = a;
  for (int i = 0; i < 200; ++i) ++b.values[static_cast<std::size_t>(random.below(256 * 256 * 3))];
  CHECK(10 * packed_difference(b, a).size() < packed(b).size());
}

TEST_CASE("base64 is that of RFC 4648, of any length") {
  const auto of = [](std::string_view text) { return base64({text.begin(), text.end()}); };
  CHECK(of("").empty());
  CHECK(of("f") == "Zg==");
  CHECK(of("fo") == "Zm8=");
  CHECK(of("foo") == "Zm9v");
  CHECK(of("foobar") == "Zm9vYmFy");
  const std::string many = of(std::string((3 << 20) + 4, 'f')); // more than is written at once
  CHECK(many.size() == 4 * ((1 << 20) + 2));
  CHECK(many.substr(0, 4) == "ZmZm");
  CHECK(many.find('=') == many.size() - 2);
}

TEST_CASE("images of different sizes have no packed difference") {
  CHECK_THROWS_AS(packed_difference(Image<std::uint8_t>(2, 1, 3), Image<std::uint8_t>(1, 2, 3)), std::invalid_argument);
}
