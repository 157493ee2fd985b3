// The PNG writer, held against libpng and against our reader.

#include <refraster/files.h>

#include "io/image/png/png_filter.h"
#include "io/image/png/png_write.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/random.h"

#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <string_view>

namespace refraster::test {
namespace {

/// What libpng reads, as it is stored; 16 bits as whole numbers.
struct LibpngImage {
  int width = 0, height = 0, channels = 0, bits = 0;
  std::vector<std::uint16_t> values;
};

LibpngImage read_by_libpng(const std::string& bytes) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  std::string_view rest = bytes;
  png_set_read_fn(png, &rest, [](png_structp of, png_bytep to, std::size_t size) {
    auto& from = *static_cast<std::string_view*>(png_get_io_ptr(of));
    if (size > from.size()) png_error(of, "the file ends");
    std::memcpy(to, from.data(), size);
    from.remove_prefix(size);
  });
  png_set_benign_errors(png, 0); // a warning ends the test too
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  LibpngImage image{static_cast<int>(png_get_image_width(png, info)), static_cast<int>(png_get_image_height(png, info)),
                    png_get_channels(png, info), png_get_bit_depth(png, info), {}};
  png_bytepp rows = png_get_rows(png, info);
  for (int y = 0; y < image.height; ++y)
    for (int i = 0; i < image.width * image.channels; ++i)
      image.values.push_back(image.bits == 8
                                 ? std::uint16_t{rows[y][i]}
                                 : static_cast<std::uint16_t>(rows[y][2 * i] << 8 | rows[y][2 * i + 1]));
  CHECK(rest.empty());
  png_destroy_read_struct(&png, &info, nullptr);
  return image;
}

enum class Pattern { random, smooth, flat };

template <class Value>
Image<Value> picture(int width, int height, int channels, Pattern pattern) {
  Image<Value> image(width, height, channels);
  Random random(static_cast<std::uint64_t>(width * 31 + height * 7 + channels));
  for (std::size_t i = 0; i < image.values.size(); ++i)
    switch (pattern) {
    case Pattern::random:
      image.values[i] = static_cast<Value>(random.bits());
      break;
    case Pattern::smooth: // and a few specks
      image.values[i] = static_cast<Value>(i / 5 + i / static_cast<std::size_t>(width) + (random.below(50) == 0));
      break;
    case Pattern::flat:
      image.values[i] = 200;
      break;
    }
  return image;
}

template <class Value>
void check_sizes(int channels) {
  const TemporaryFolder folder;
  // One pixel, one column and one row longer than a strip, odd widths, several strips of several rows.
  constexpr int sizes[][2] = {{1, 1}, {1, 70000}, {70000, 1}, {3, 5}, {257, 129}, {1001, 333}};
  for (const auto& size : sizes)
    for (const Pattern pattern : {Pattern::random, Pattern::smooth, Pattern::flat}) {
      const int width = size[0], height = size[1];
      CAPTURE(channels);
      CAPTURE(width);
      CAPTURE(height);
      CAPTURE(static_cast<int>(pattern));
      const Image<Value> image = picture<Value>(width, height, channels, pattern);
      const std::string bytes = png_file(image, {.threads = 1});
      for (const int threads : {2, 3, 7}) CHECK(png_file(image, {.threads = threads}) == bytes);
      const LibpngImage read = read_by_libpng(bytes);
      CHECK(read.width == width);
      CHECK(read.height == height);
      CHECK(read.channels == channels);
      CHECK(read.bits == 8 * static_cast<int>(sizeof(Value)));
      CHECK(std::equal(read.values.begin(), read.values.end(), image.values.begin(), image.values.end()));
      if (std::max(width, height) > 65536) continue; // which our reader refuses
      write_image(folder / "i.png", image);
      const ImageFile own = read_image(folder / "i.png");
      CHECK(own.bits == 8 * static_cast<int>(sizeof(Value)));
      CHECK(std::equal(own.values.values.begin(), own.values.values.end(), image.values.begin(), image.values.end()));
    }
}

std::vector<std::string> chunk_types(const std::string& file) {
  std::vector<std::string> types;
  for (std::size_t at = 8; at + 8 <= file.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) size = size << 8 | static_cast<unsigned char>(file[at + i]);
    types.push_back(file.substr(at + 4, 4));
    at += 12 + size;
  }
  return types;
}

} // namespace

TEST_CASE("a PNG of any channels, bits and size is read back by libpng and by us, and is the same for any threads") {
  for (int channels = 1; channels <= 4; ++channels) {
    check_sizes<std::uint8_t>(channels);
    check_sizes<std::uint16_t>(channels);
  }
}

TEST_CASE("a PNG says that it is sRGB where that is asked for, and else nothing beside its pixels") {
  const auto image = picture<std::uint8_t>(40, 30, 3, Pattern::smooth);
  CHECK(chunk_types(png_file(image, {})) == std::vector<std::string>{"IHDR", "IDAT", "IEND"});
  CHECK(chunk_types(png_file(image, {.curve = StatedCurve::srgb})) ==
        std::vector<std::string>{"IHDR", "sRGB", "IDAT", "IEND"});
}

TEST_CASE("each row gets the filter that leaves least: worked out by hand") {
  RowFilter filter(4, 1);
  std::uint8_t row[5];
  const auto filtered = [&](std::vector<std::uint8_t> values, std::vector<std::uint8_t> above) {
    filter.filter(values.data(), above.empty() ? nullptr : above.data(), row);
    return std::vector<int>(row, row + 5);
  };
  CHECK(filtered({0, 0, 0, 0}, {}) == std::vector<int>{0, 0, 0, 0, 0});
  CHECK(filtered({90, 90, 90, 91}, {}) == std::vector<int>{1, 90, 0, 0, 1});
  CHECK(filtered({90, 7, 60, 91}, {90, 8, 60, 91}) == std::vector<int>{2, 0, 255, 0, 0});
  // Half of 20, then of 10 + 60, of 35 + 100 rounded down, of 67 + 40 likewise.
  CHECK(filtered({10, 35, 67, 53}, {20, 60, 100, 40}) == std::vector<int>{3, 0, 0, 0, 0});
  // left + above - corner: 0 + 50 - 0 is nearest to above; 60 + 50 - 50 to left, twice; 60 + 90 - 50 to above.
  CHECK(filtered({60, 60, 60, 100}, {50, 50, 50, 90}) == std::vector<int>{4, 10, 0, 0, 10});
}

TEST_CASE("an image that packs badly is hardly larger than its pixels") {
  const auto image = picture<std::uint8_t>(1001, 333, 3, Pattern::random);
  CHECK(png_file(image, {}).size() < image.values.size() * 1001 / 1000 + 1000);
}

} // namespace refraster::test
