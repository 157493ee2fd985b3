#include <refraster/files.h>
#include <refraster/notes.h>

#include "io/file/input_file.h"
#include "tests/support/files/malformed_images.h"
#include "tests/support/files/png_bytes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

namespace refraster::test {
namespace {

std::string file_with(const TemporaryFolder& folder, const std::string& name, const std::string& bytes) {
  write_files(folder.path, {{name, bytes}});
  return folder / name;
}

/// 5 x 3, each value different, with everything that a float can be.
Image<float> difficult(int channels) {
  Image<float> image(5, 3, channels);
  std::iota(image.values.begin(), image.values.end(), 0.1f);
  const float special[] = {-0.0f,
                           -1.5f,
                           1e30f,
                           std::numeric_limits<float>::denorm_min(),
                           std::numeric_limits<float>::infinity(),
                           std::numeric_limits<float>::max(),
                           std::bit_cast<float>(0x7fc12345u)};
  for (std::size_t i = 0; i < std::size(special); ++i) image.values[i] = special[i];
  return image;
}

/// A grey JPEG of 17 x 9 pixels, with a comment of so many bytes before its size. By hand, with tables of few codes.
std::string grey_jpeg(std::size_t comment_bytes) {
  const auto segment = [](char marker, const std::string& data) {
    const std::size_t length = data.size() + 2;
    return std::string{'\xff', marker, static_cast<char>(length >> 8), static_cast<char>(length & 255)} + data;
  };
  const auto bytes = [](std::initializer_list<int> list) {
    std::string text;
    for (const int byte : list) text += static_cast<char>(byte);
    return text;
  };
  std::string quantization(1, '\0');
  for (char i = 1; i <= 64; ++i) quantization += i;
  const std::string none(12, '\0'), codes_dc = bytes({0, 0, 3, 1}) + none + '\0' + bytes({0, 1, 2, 5}),
                                    codes_ac = bytes({0x10, 0, 2, 2, 1}) + none + bytes({0, 1, 0x11, 0xf0, 0x10});
  return "\xff\xd8" + segment('\xe1', std::string(comment_bytes, '\0')) + segment('\xdb', quantization) +
         segment('\xc0', bytes({8, 0, 9, 0, 17, 1, 1, 0x11, 0})) + segment('\xc4', codes_dc) +
         segment('\xc4', codes_ac) + segment('\xda', bytes({1, 1, 0, 0, 63, 0})) + std::string(60, '\0') + "\xff\xd9";
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  });
}

} // namespace

TEST_CASE("a JPEG may begin with much that is no picture: what a camera notes") {
  const TemporaryFolder folder;
  for (const std::size_t comment_bytes : {0u, 900u, 3000u, 60000u}) {
    CAPTURE(comment_bytes);
    const ImageFile image = read_image(file_with(folder, "a.jpg", grey_jpeg(comment_bytes)));
    CHECK(image.values.width == 17);
    CHECK(image.values.height == 9);
  }
  CHECK_THROWS_AS(read_image(file_with(folder, "a.jpg", grey_jpeg(3000).substr(0, 2000))), InputError);
}

TEST_CASE("an image of 1 to 4 channels and 8 or 16 bits is read as stored, row 0 at the top") {
  const TemporaryFolder folder;
  for (const int bits : {8, 16})
    for (int channels = 1; channels <= 4; ++channels) {
      std::vector<std::uint16_t> samples(static_cast<std::size_t>(3 * 2 * channels));
      for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = static_cast<std::uint16_t>(bits == 8 ? 10 * i : 2500 * i + 1);
      const ImageFile image = read_image(file_with(folder, "i.png", png_bytes(3, 2, channels, bits, samples)));
      CHECK(image.values.width == 3);
      CHECK(image.values.height == 2);
      CHECK(image.values.channels == channels);
      CHECK(image.bits == bits);
      CHECK(image.full_scale == (bits == 8 ? 255 : 65535));
      CHECK(image.values.values == std::vector<float>(samples.begin(), samples.end()));
    }
}

TEST_CASE("a texture has row 0 at the bottom, grey in all channels, and no alpha") {
  const TemporaryFolder folder;
  const Texture grey = read_texture(file_with(folder, "i.png", png_bytes(1, 2, 1, 8, {10, 20})));
  CHECK(grey.levels.size() == 1);
  CHECK(grey.levels[0].rgb == PaddedVector<float>{20, 20, 20, 10, 10, 10});
  const Texture grey_alpha = read_texture(file_with(folder, "i.png", png_bytes(1, 2, 2, 8, {10, 1, 20, 2})));
  CHECK(grey_alpha.levels[0].rgb == grey.levels[0].rgb);
  const Texture rgb = read_texture(file_with(folder, "i.png", png_bytes(1, 2, 3, 16, {1, 2, 3, 65535, 5, 6})));
  CHECK(rgb.levels[0].rgb == PaddedVector<float>{65535, 5, 6, 1, 2, 3});
  CHECK(rgb.full_scale == 65535);
  const Texture rgba = read_texture(file_with(folder, "i.png", png_bytes(2, 1, 4, 8, {1, 2, 3, 0, 5, 6, 7, 128})));
  CHECK(rgba.levels[0].rgb == PaddedVector<float>{1, 2, 3, 5, 6, 7});
  CHECK(rgba.levels[0].width == 2);
}

TEST_CASE("levels written as PNG are read back, grey and RGB") {
  const TemporaryFolder folder;
  for (const int channels : {1, 3}) {
    Image<std::uint8_t> image(7, 5, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<std::uint8_t>(37 * i);
    write_image(folder / "i.png", image);
    const ImageFile read = read_image(folder / "i.png");
    CHECK(read.bits == 8);
    CHECK(read.values.channels == channels);
    CHECK(read.values.values == std::vector<float>(image.values.begin(), image.values.end()));
  }
}

TEST_CASE("PFM and EXR keep every bit of a float: infinities, NaN, -0 and subnormal ones") {
  const TemporaryFolder folder;
  for (const int channels : {1, 3})
    for (const std::string name : {"i.pfm", "i.exr"}) {
      CAPTURE(name);
      const Image<float> image = difficult(channels);
      write_image(folder / name, image);
      const ImageFile read = read_image(folder / name);
      CHECK(read.bits == 32);
      CHECK(read.full_scale == 1);
      CHECK(read.values.width == 5);
      CHECK(read.values.channels == channels);
      CHECK(same_bits(read.values.values, image.values));
      CHECK(read.channels == (channels == 1 ? std::vector<std::string>{"Y"} : std::vector<std::string>{"R", "G", "B"}));
    }
}

TEST_CASE("an EXR file keeps the names of its channels, colour first") {
  const TemporaryFolder folder;
  Image<float> image(2, 1, 5);
  std::iota(image.values.begin(), image.values.end(), 0.0f);
  write_image(folder / "i.exr", image, {"B", "depth.Z", "A", "R", "G"});
  const ImageFile read = read_image(folder / "i.exr");
  CHECK(read.channels == std::vector<std::string>{"R", "G", "B", "A", "depth.Z"});
  CHECK(read.values.values == std::vector<float>{3, 4, 0, 2, 1, 8, 9, 5, 7, 6});
}

TEST_CASE("an EXR file whose pixels do not begin at (0, 0) is read as any other") {
  const TemporaryFolder folder;
  const Image<float> image = difficult(3);
  write_image(folder / "i.exr", image);
  std::string bytes = read_file(folder / "i.exr", "", 1 << 20);
  const auto shift = [&](std::size_t at, std::int32_t by) {
    std::int32_t value = 0;
    std::memcpy(&value, &bytes[at], sizeof value);
    value += by;
    std::memcpy(&bytes[at], &value, sizeof value);
  };
  // The window: x and y of its first and last pixel, behind name, type and size.
  using namespace std::string_literals;
  const std::string attribute = "dataWindow\0box2i\0"s;
  const std::size_t window = bytes.find(attribute) + attribute.size() + 4;
  for (const std::size_t x : {0u, 2u}) shift(window + 4 * x, -7);
  for (const std::size_t y : {1u, 3u}) shift(window + 4 * y, 1000);
  // The only block of rows begins with its y; the table of blocks, just before it, holds its place.
  for (std::size_t at = window; at + 12 < bytes.size(); ++at) {
    std::uint64_t place = 0;
    std::memcpy(&place, &bytes[at], sizeof place);
    if (place != at + 8) continue;
    shift(at + 8, 1000);
    break;
  }
  CHECK(same_bits(read_image(file_with(folder, "i.exr", bytes)).values.values, image.values));
}

TEST_CASE("a big-endian PFM is read") {
  const TemporaryFolder folder;
  using namespace std::string_literals;
  const ImageFile read = read_image(file_with(folder, "i.pfm", "Pf\n1 2\n1.0\n\x3f\x80\0\0\xc0\0\0\0"s));
  CHECK(read.values.values == std::vector<float>{-2, 1});
}

TEST_CASE("HDR gives each channel back within half a step of the largest one's mantissa") {
  const TemporaryFolder folder;
  Image<float> image(11, 4, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = std::ldexp(1.0f + static_cast<float>(i * 7919 % 1000) / 1000, static_cast<int>(i % 23) - 11);
  image.values[0] = 0.9999f; // rounds up to 256: the exponent must follow
  write_image(folder / "i.hdr", image);
  const ImageFile read = read_image(folder / "i.hdr");
  REQUIRE(read.values.values.size() == image.values.size());
  for (std::size_t pixel = 0; pixel < image.values.size(); pixel += 3) {
    const float* const wrote = &image.values[pixel];
    const float largest = std::max({wrote[0], wrote[1], wrote[2]});
    // The mantissa of the largest is 128 to 256 steps of 2^(exponent - 8); one binade more where it rounds up.
    const double step = std::ldexp(1.0, std::ilogb(largest * (1 + 1.0f / 512)) + 1 - 8);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(std::abs(static_cast<double>(read.values.values[pixel + c]) - static_cast<double>(wrote[c])) <= step / 2);
  }
}

TEST_CASE("HDR rows may be coded or not, in one file, and lie where they belong") {
  const TemporaryFolder folder;
  // Ten pixels: (1, 0.5, 0.25) by runs, then the same and its double, one by one.
  const std::string coded("\x02\x02\x00\x0a\x8a\x80\x83\x40\x07@@@@@@@\x8a\x20\x05\x81\x81\x81\x81\x81\x85\x81", 26);
  std::string plain;
  for (int x = 0; x < 10; ++x) plain += x < 5 ? "\x80\x40\x20\x81" : "\x80\x40\x20\x82";
  const ImageFile image = read_image(
      file_with(folder, "i.hdr",
                "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\nGAMMA=1\n\n-Y 3 +X 10\n" + coded + plain + coded));
  REQUIRE(image.values.width == 10);
  REQUIRE(image.values.height == 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 10; ++x) {
      const float unit = y == 1 && x >= 5 ? 2.0f : 1.0f;
      const float* const pixel = image.values.at(x, y);
      CHECK(std::vector<float>(pixel, pixel + 3) == std::vector<float>{unit, unit / 2, unit / 4});
    }
}

TEST_CASE("HDR values are divided by all exposures and colour corrections of the header, and a note names the factor") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& lines) {
    // (1, 0.5, 0.25)
    return read_image(
        file_with(folder, "i.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + lines + "\n-Y 1 +X 1\n\x80\x40\x20\x81"));
  };
  const auto text_of_note = [](const ImageFile& image) {
    return image.notes.empty() ? std::string() : image.notes.notes()[0].text();
  };
  const ImageFile plain = read("");
  CHECK(plain.values.values == std::vector<float>{1, 0.5f, 0.25f});
  CHECK(plain.notes.empty());
  const ImageFile cumulative = read("EXPOSURE=2\nVIEW= -vta\nEXPOSURE= 4.0 \n"); // 8 in all
  CHECK(cumulative.values.values == std::vector<float>{0.125f, 0.0625f, 0.03125f});
  CHECK(text_of_note(cumulative).ends_with("i.hdr:3: found 2 lines of EXPOSURE or COLORCORR, values are divided by 8"));
  const ImageFile both = read("COLORCORR= 1 0.5 2\nEXPOSURE=2\n"); // 2, 1, 4
  CHECK(both.values.values == std::vector<float>{0.5f, 0.5f, 0.0625f});
  CHECK(text_of_note(both).ends_with("values are divided by 2, 1, 4 (R, G, B)"));
  CHECK(read("EXPOSURE=2\nEXPOSURE=0.5\n").notes.empty()); // nothing is changed
}

TEST_CASE("a BMP may have its top row first, and few colours") {
  const TemporaryFolder folder;
  const std::string palette = std::string("\1\2\3\0\4\5\6\0", 8), rows("\0\0\0\0\1\0\0\0", 8);
  for (const int height : {2, -2}) {
    const ImageFile image = read_image(file_with(folder, "i.bmp", bmp_bytes(1, height, 8, palette, rows)));
    const std::vector<float> first{3, 2, 1}, second{6, 5, 4};
    std::vector<float> expected = height < 0 ? first : second;
    const std::vector<float>& last = height < 0 ? second : first;
    expected.insert(expected.end(), last.begin(), last.end());
    CHECK(image.values.values == expected);
  }
}

TEST_CASE("an OpenEXR file of rows, each packed by itself, is read") {
  const TemporaryFolder folder;
  const std::string one_two("\0\0\x80\x3f\0\0\0\x40", 8);
  const ImageFile image = read_image(file_with(folder, "i.exr", exr_bytes(2, 0, {one_two, one_two})));
  CHECK(image.values.values == std::vector<float>{1, 2, 1, 2});
}

TEST_CASE("what HDR cannot hold becomes 0 or its largest value") {
  const TemporaryFolder folder;
  Image<float> image(1, 1, 3);
  image.values = {-1, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  write_image(folder / "i.hdr", image);
  CHECK(read_image(folder / "i.hdr").values.values ==
        std::vector<float>{0, 0, static_cast<float>(std::ldexp(255.0, 119))});
}

TEST_CASE("the content, not the name, says what an image is") {
  const TemporaryFolder folder;
  write_image(folder / "i.exr", difficult(3));
  std::filesystem::rename(folder / "i.exr", folder / "i.png");
  CHECK(read_image(folder / "i.png").bits == 32);
}

TEST_CASE("a float image of an unknown format, or with channels that it cannot hold, is refused before writing") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_image(folder / "i.tiff", difficult(3)), InputError);
  CHECK_THROWS_AS(write_image(folder / "i.pfm", difficult(2)), InputError);
  CHECK_THROWS_AS(write_image(folder / "i.hdr", difficult(1)), InputError);
  CHECK(std::filesystem::is_empty(folder.path));
}

TEST_CASE("an EXR file is the same for any number of threads") {
  const TemporaryFolder folder;
  Image<float> image(70, 333, 3); // OpenEXR packs 16 rows at a time
  for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<float>(i * i % 1013) / 7;
  const auto bytes = [&](int threads) {
    write_image(folder / "i.exr", image, {}, {.threads = threads});
    return read_file(folder / "i.exr", "an image", std::uint64_t{1} << 30);
  };
  const std::string expected = bytes(1);
  for (const int threads : {2, 3, 7, 0}) CHECK(bytes(threads) == expected);
  CHECK(read_image(folder / "i.exr").values.values == image.values);
}

TEST_CASE("an EXR file cut short at any length is refused") {
  const TemporaryFolder folder;
  write_image(folder / "i.exr", difficult(3));
  const auto size = std::filesystem::file_size(folder / "i.exr");
  for (std::uintmax_t length = 1; length < size; length += 13) {
    std::filesystem::copy_file(folder / "i.exr", folder / "cut.exr", std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(folder / "cut.exr", length);
    CHECK_THROWS_AS(read_image(folder / "cut.exr"), InputError);
  }
}

TEST_CASE("a PNG file cut short at any length is refused") {
  const TemporaryFolder folder;
  const std::string png = png_bytes(3, 2, 3, 8, std::vector<std::uint16_t>(18, 77));
  // Without its last chunk, IEND and 12 bytes, all pixels are there, and stb asks for no more.
  for (std::size_t length = 1; length + 12 < png.size(); ++length)
    CHECK_THROWS_AS(read_image(file_with(folder, "i.png", png.substr(0, length))), InputError);
}

} // namespace refraster::test
