// Images that are written row by row.

#include <refraster/files.h>

#include "io/file/input_file.h"
#include "io/image/exr_layers.h"
#include "io/image/image_formats.h"
#include "tests/support/files/malformed_inputs.h"
#include "tests/support/random.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace refraster::test {
namespace {

std::string bytes_of(const std::string& path) {
  return read_file(path, "an image", std::numeric_limits<std::uint64_t>::max());
}

template <class Value>
Image<Value> random_image(int width, int height, int channels) {
  Image<Value> image(width, height, channels);
  Random random(static_cast<std::uint64_t>(width * height));
  // Rows are unlike, and have runs.
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<Value>(i % 7 < 3 ? 5 : random.uniform(0, 200));
  return image;
}

/// Its rows, each a copy.
template <class Value>
ImageRows<Value> copied_rows(const Image<Value>& image) {
  return {image.width, image.height, image.channels, [&image](int y, std::vector<Value>& scratch) {
            const std::size_t row = static_cast<std::size_t>(image.width * image.channels);
            scratch.assign(image.at(0, y), image.at(0, y) + row);
            return static_cast<const Value*>(scratch.data());
          }};
}

template <class Value>
void check_same_bytes(const Image<Value>& image, ImageValues values) {
  const TemporaryFolder folder;
  for (const ImageFormat& format : image_formats) {
    if (!can_write(format, {values, image.channels})) continue;
    const std::string extension(format.extensions[0]), a = folder / ("a." + extension), b = folder / ("b." + extension);
    INFO(extension);
    for (const int threads : {1, 3}) {
      const WriteOptions options{.threads = threads};
      if constexpr (std::is_same_v<Value, float>)
        write_image(a, image, {}, options), write_rows(b, copied_rows(image), {}, options);
      else write_image(a, image, options), write_rows(b, copied_rows(image), options);
      CHECK(bytes_of(a) == bytes_of(b));
    }
  }
}

} // namespace

TEST_CASE("rows that are made as they are asked for give the bytes of an image in memory, in every format") {
  // Of more than eight strips a thread, and of more blocks of EXR's than are packed at a time.
  check_same_bytes(random_image<std::uint8_t>(1101, 1203, 3), ImageValues::uint8);
  check_same_bytes(random_image<std::uint16_t>(701, 1003, 4), ImageValues::uint16);
  check_same_bytes(random_image<std::uint32_t>(51, 40, 1), ImageValues::uint32);
  check_same_bytes(random_image<float>(301, 403, 3), ImageValues::floats);
  check_same_bytes(random_image<float>(1, 1, 1), ImageValues::floats);
}

TEST_CASE("what reading a row throws is what the writer throws, and no file is made") {
  const TemporaryFolder folder;
  const auto failing = []<class Value>(const Value&) {
    return ImageRows<Value>(40, 300, 3, [](int y, std::vector<Value>& scratch) {
      if (y == 250) throw InputError(InputFault{"part", 0, 0, "", "nothing", "a row"});
      scratch.assign(120, Value(y));
      return static_cast<const Value*>(scratch.data());
    });
  };
  for (const char* const name : {"a.png", "a.jpg", "a.npy"})
    CHECK_THROWS_AS(write_rows(folder / name, failing(std::uint8_t{}), {}), InputError);
  for (const char* const name : {"a.exr", "a.pfm", "a.hdr", "a.npy"})
    CHECK_THROWS_AS(write_rows(folder / name, failing(float{}), {}, {}), InputError);
  CHECK(std::filesystem::is_empty(folder.path));
}

} // namespace refraster::test
