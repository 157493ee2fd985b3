#include "tests/support/files/malformed_images.h"

#include "tests/support/files/jpeg_bytes.h"
#include "tests/support/files/png_bytes.h"

#include <cstring>

namespace refraster::test {
namespace {

using namespace std::string_literals;

using List = std::vector<MalformedInput>;

void add(List& list, const std::string& name, const std::string& input, const std::string& bytes,
         const std::string& expected) {
  list.push_back({name, Reader::image, input, {{input, bytes}}, input + ": " + expected});
}

const std::string truncated = "found a truncated image, expected a whole one";

void add_png(List& list) {
  std::string png = png_bytes(2, 1, 3, 8, {1, 2, 3, 4, 5, 6});
  png[33] = '\x40'; // the length of its IDAT: 2^30 more
  add(list, "a PNG with a chunk longer than the file", "i.png", png, truncated);
  png = png_bytes(2, 1, 3, 8, {1, 2, 3, 4, 5, 6});
  png[49] = '\x40'; // a sample
  add(list, "a PNG of which a byte has changed", "i.png", png,
      "chunk IDAT: found a checksum that does not fit the pixels, expected their Adler-32: the file is damaged");
}

void add_jpeg(List& list) {
  JpegBytes jpeg;
  add(list, "a JPEG without its end", "i.jpg", flat_jpeg(jpeg, {1}).substr(0, 100), truncated);
  jpeg.width = jpeg.height = 16000;
  const std::string large = flat_jpeg(jpeg, {1});
  add(list, "a JPEG larger than its file", "i.jpg", large,
      "found 16000 x 16000 pixels, expected as many as a file of " + std::to_string(large.size()) + " bytes can hold");
}

void add_bmp(List& list) {
  const std::string two_colours = "\x01\x02\x03\x00\x04\x05\x06\x00"s;
  add(list, "a BMP with a pixel beyond its palette", "i.bmp", bmp_bytes(2, 1, 8, two_colours, "\x01\x02\x00\x00"s),
      "pixel 1 of stored row 0: found colour 2, expected 0 to 1");
  add(list, "a BMP of 4 bits with a pixel beyond its palette", "i.bmp",
      bmp_bytes(3, 1, 4, two_colours, "\x10\xf0\x00\x00"s),
      "pixel 2 of stored row 0: found colour 15, expected 0 to 1");
  add(list, "a BMP without its last row", "i.bmp", bmp_bytes(2, -2, 8, two_colours, "\x00\x00\x00\x00"s), truncated);
  add(list, "a BMP without a palette", "i.bmp", bmp_bytes(2, 1, 8, "", "\x00\x00\x00\x00"s),
      "found pixels that start at byte 54, expected byte 58 or later, behind the palette");
  add(list, "a BMP larger than its file", "i.bmp", bmp_bytes(60000, 4000, 1, two_colours, "\x00"s),
      "found 60000 x 4000 pixels, expected as many as a file of 63 bytes can hold");
}

void add_tga(List& list) {
  const std::string header = "\0\0\2\0\0\0\0\0\0\0\0\0\x50\0\2\0\x18\0"s; // 80 x 2 pixels of 24 bits
  // The rest of the last row would be what was in memory.
  add(list, "a TGA cut within its last row", "i.tga", header + std::string(480 - 5, 'x'), truncated);
  add(list, "a TGA larger than its file", "i.tga", "\0\0\x0a\0\0\0\0\0\0\0\0\0\xff\xff\xff\x0f\x18\0"s,
      "found 65535 x 4095 pixels, expected as many as a file of 18 bytes can hold");
}

void add_hdr(List& list) {
  const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 10\n";
  const auto add_row = [&](const std::string& name, const std::string& row, const std::string& expected) {
    add(list, name, "i.hdr", header + row, expected);
  };
  // stb_image reads these for ever: nothing is a run of 0 bytes to it.
  add_row("an HDR cut within a coded row", "\2\2\0\x0a\x8a\x80"s, truncated);
  add_row("an HDR with an empty run", "\2\2\0\x0a\0\0\x80"s, "row 0: found a run of 0, expected 1 to 10");
  add_row("an HDR with a run beyond its row", "\2\2\0\x0a\x83\x80\x88\x80"s,
          "row 0: found a run of 8, expected 1 to 7");
  add_row("an HDR with a row of another width", "\2\2\0\x0b"s, "row 0: found 11 pixels, expected 10");
  add_row("an HDR of the time before 1991", "\x80\x80\x80\x80\1\1\1\x09"s + std::string(40, '\x80'),
          "row 0: found run lengths of the old kind, expected those since 1991");
  add(list, "an HDR with rows from the bottom", "i.hdr",
      "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n+Y 1 +X 1\n\x80\x80\x80\x80",
      "found \"+Y 1 +X 1\", expected -Y height +X width");
  add(list, "an HDR in XYZ", "i.hdr", "#?RGBE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n\x80\x80\x80\x80",
      "found \"FORMAT=32-bit_rle_xyze\", expected FORMAT=32-bit_rle_rgbe");
  const auto add_line = [&](const std::string& name, const std::string& line, const std::string& expected) {
    const std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n" + line + "\n\n-Y 1 +X 1\n\x80\x80\x80\x80";
    list.push_back(
        {name, Reader::image, "i.hdr", {{"i.hdr", bytes}}, "i.hdr:3: found \"" + line + "\", expected " + expected});
  };
  for (const char* const wrong : {"0", "-1", "nan", "inf", "1e999", "one", "", "1 2", "1.2.3", "1e-320"})
    add_line("an HDR with the exposure \"" + std::string(wrong) + "\"", "EXPOSURE=" + std::string(wrong),
             "EXPOSURE= and a number > 0");
  for (const char* const wrong : {"1", "1 1", "1 1 1 1", "1 0 1", "1 1 x"})
    add_line("an HDR with the colour correction \"" + std::string(wrong) + "\"", "COLORCORR=" + std::string(wrong),
             "COLORCORR= and three numbers > 0");
  add(list, "an HDR larger than its file", "i.hdr", "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 4000\n",
      "found 4000 x 60000 pixels, expected as many as a file of 48 bytes can hold");
}

void add_exr(List& list) {
  const std::string row(8, 'x'), packed = "\x07x"s; // 8 bytes, by run length
  add(list, "a deep OpenEXR file", "i.exr", exr_bytes(2, 0, {row}, 0x800),
      "found deep or several images in one file, expected a flat one");
  add(list, "an OpenEXR file that calls itself deep", "i.exr",
      exr_bytes(2, 0, {row}, 0, "type\0string\0\x0c\0\0\0deepscanline"s),
      "type: found \"deepscanline\", expected scanlineimage or tiledimage");
  add(list, "an OpenEXR file with channels that are not the image's", "i.exr",
      exr_bytes(2, 0, {row}, 0, "more\0chlist\0\x01\0\0\0\0"s), "more: found a second list of channels, expected one");
  add(list, "an OpenEXR file with a row that is too short", "i.exr", exr_bytes(2, 0, {row, "x"}),
      "chunk 1: found 1 bytes of pixels, expected 8");
  add(list, "an OpenEXR file with a row that unpacks to too little", "i.exr", exr_bytes(2, 1, {packed, "\x06x"s}),
      "chunk 1: found 7 bytes of pixels, expected 8");
  add(list, "an OpenEXR file with a row that is no deflate stream", "i.exr", exr_bytes(2, 2, {"x"}),
      "chunk 0: found 0 bytes of pixels, expected 8");
  std::string cut = exr_bytes(2, 1, {packed, packed});
  cut.pop_back();
  add(list, "an OpenEXR file without its end", "i.exr", cut, truncated);
  add(list, "an OpenEXR file larger than its bytes", "i.exr", exr_bytes(65536, 0, {}),
      "found 65536 x 0 pixels, expected at least 1 x 1");
  add(list, "an OpenEXR file of huge tiles", "i.exr",
      exr_bytes(2, 0, {row}, 0x200, "tiles\0tiledesc\0\x09\0\0\0\xff\xff\xff\x7f\xff\xff\xff\x7f\0"s),
      "tiles: found 4611686014132420609 pixels that are packed together, expected at most 16777216 here");
}

} // namespace

std::string bmp_bytes(std::int32_t width, std::int32_t height, int bits, const std::string& palette,
                      const std::string& rows) {
  const auto start = static_cast<std::uint32_t>(54 + palette.size());
  return "BM" + bytes_of(static_cast<std::uint32_t>(start + rows.size())) + bytes_of(0u) + bytes_of(start) +
         bytes_of(40u) + bytes_of(width) + bytes_of(height) + "\1\0"s + bytes_of(static_cast<std::uint16_t>(bits)) +
         std::string(24, '\0') + palette + rows;
}

std::string exr_bytes(std::int32_t width, char compression, const std::vector<std::string>& chunks, std::uint32_t flags,
                      const std::string& more_attributes) {
  const auto attribute = [](const std::string& name, const std::string& type, const std::string& value) {
    return name + '\0' + type + '\0' + bytes_of(static_cast<std::uint32_t>(value.size())) + value;
  };
  const std::string window = bytes_of(std::int32_t{0}) + bytes_of(std::int32_t{0}) + bytes_of(width - 1) +
                             bytes_of(static_cast<std::int32_t>(chunks.size()) - 1);
  std::string file = "\x76\x2f\x31\x01"s + bytes_of(2 | flags) +
                     attribute("channels", "chlist", "Y\0\2\0\0\0\0\0\0\0\1\0\0\0\1\0\0\0\0"s) +
                     attribute("compression", "compression", std::string(1, compression)) +
                     attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window) +
                     attribute("lineOrder", "lineOrder", "\0"s) +
                     attribute("pixelAspectRatio", "float", bytes_of(1.0f)) +
                     attribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
                     attribute("screenWindowWidth", "float", bytes_of(1.0f)) + more_attributes + '\0';
  std::uint64_t at = file.size() + 8 * chunks.size();
  for (const std::string& chunk : chunks) {
    file += bytes_of(at);
    at += 8 + chunk.size();
  }
  std::int32_t y = 0;
  for (const std::string& chunk : chunks)
    file += bytes_of(y++) + bytes_of(static_cast<std::uint32_t>(chunk.size())) + chunk;
  return file;
}

std::vector<MalformedInput> malformed_images() {
  List list;
  for (const auto add_some : {add_png, add_jpeg, add_bmp, add_tga, add_hdr, add_exr}) add_some(list);
  return list;
}

} // namespace refraster::test
