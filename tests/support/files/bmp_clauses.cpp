#include "tests/support/files/image_clauses.h"
#include "tests/support/files/malformed_inputs.h"

namespace refraster::test {
namespace {

using namespace std::string_literals;

struct Fields {
  std::uint32_t header = 40;
  std::int32_t width = 2, height = 1;
  std::uint16_t bits = 24;
  std::uint32_t compression = 0, colours = 0;
  std::string masks = {}, palette = {}, gap = {}; // masks: behind 40 bytes, whether they are of the header or not
  std::uint16_t planes = 1;
};

std::string bmp(const Fields& f, const std::string& pixels) {
  std::string info = bytes_of(f.header);
  if (f.header == 12) {
    info += bytes_of(static_cast<std::uint16_t>(f.width)) + bytes_of(static_cast<std::uint16_t>(f.height)) +
            bytes_of(f.planes) + bytes_of(f.bits);
  } else {
    info += bytes_of(f.width) + bytes_of(f.height) + bytes_of(f.planes) + bytes_of(f.bits);
    if (f.header > 16)
      info += bytes_of(f.compression) + std::string(12, '\0') + bytes_of(f.colours) + std::string(4, '\0');
    info += f.masks;
    if (info.size() < f.header) info.resize(f.header);
  }
  const std::string before = info + f.palette + f.gap;
  return "BM" + bytes_of(0u) + bytes_of(0u) + bytes_of(static_cast<std::uint32_t>(14 + before.size())) + before +
         pixels;
}

std::string masks(std::initializer_list<std::uint32_t> list) {
  std::string text;
  for (const std::uint32_t mask : list) text += bytes_of(mask);
  return text;
}

const std::string two = "\3\2\1\6\5\4\0\0"s; // 1 2 3, 4 5 6 in 24 bits
const std::vector<float> one_to_six = {1, 2, 3, 4, 5, 6};
const std::string colours = "\3\2\1\0\6\5\4\0"s; // the same as a palette

} // namespace

std::vector<ImageClause> bmp_clauses() {
  std::vector<ImageClause> list;
  const auto reads = [&](const char* clause, const char* what, const std::string& bytes, int channels,
                         std::vector<float> values, const std::string& note = "", int bits = 8) {
    list.push_back({"BMP "s + clause, what, "i.bmp", bytes, channels, std::move(values), note, bits});
  };
  const auto refuses = [&](const char* clause, const char* what, const std::string& bytes, const std::string& said) {
    list.push_back({"BMP "s + clause, what, "i.bmp", bytes, 0, {}, said});
  };
  const auto of = [](auto change) {
    Fields fields;
    change(fields);
    return fields;
  };

  reads("bfOffBits", "pixels behind a gap", bmp(of([](Fields& f) { f.gap = "a gap"; }), two), 3, one_to_six);
  reads("biClrUsed", "a palette before pixels of 24 bits", bmp(of([](Fields& f) { f.palette = colours; }), two), 3,
        one_to_six);
  std::string early = bmp({}, two);
  early[10] = 53;
  refuses("bfOffBits", "pixels within the header", early,
          "found pixels that start at byte 53, expected byte 54 or later, behind the header");
  reads("BITMAPCOREHEADER", "a header of 12 bytes", bmp(of([](Fields& f) { f.header = 12; }), two), 3, one_to_six);
  reads("BITMAPCOREHEADER", "a palette of three bytes a colour",
        bmp(of([](Fields& f) { f.header = 12, f.bits = 8, f.palette = "\3\2\1\6\5\4"s; }), "\0\1\0\0"s), 3, one_to_six);
  reads("BITMAPINFOHEADER2", "a header of 16 bytes", bmp(of([](Fields& f) { f.header = 16; }), two), 3, one_to_six);
  reads("BITMAPINFOHEADER2", "a header of 64 bytes", bmp(of([](Fields& f) { f.header = 64; }), two), 3, one_to_six);
  refuses("BITMAPINFOHEADER2", "Huffman codes",
          bmp(of([](Fields& f) { f.header = 64, f.bits = 1, f.compression = 3; }), two),
          "found Huffman compression, expected pixels that are not compressed");
  reads("BITMAPV2INFOHEADER", "a header of 52 bytes with masks",
        bmp(of([](Fields& f) {
              f.header = 52, f.bits = 32, f.compression = 3, f.masks = masks({0xff, 0xff00, 0xff0000});
            }),
            "\1\2\3\x63\4\5\6\x63"s),
        3, one_to_six);
  reads("BITMAPV3INFOHEADER", "a header of 56 bytes with masks",
        bmp(of([](Fields& f) {
              f.header = 56, f.bits = 32, f.compression = 3, f.masks = masks({0xff, 0xff00, 0xff0000, 0xff000000});
            }),
            "\1\2\3\7\4\5\6\x08"s),
        4, {1, 2, 3, 7, 4, 5, 6, 8});
  reads("BITMAPV3INFOHEADER", "a header of 56 bytes without", bmp(of([](Fields& f) { f.header = 56; }), two), 3,
        one_to_six);
  reads("BITMAPV4HEADER", "a header of 108 bytes", bmp(of([](Fields& f) { f.header = 108; }), two), 3, one_to_six);
  reads("BITMAPV5HEADER", "a header of 124 bytes, alpha of 0 throughout",
        bmp(of([](Fields& f) {
              f.header = 124, f.bits = 32, f.compression = 3, f.masks = masks({0xff0000, 0xff00, 0xff, 0xff000000});
            }),
            "\3\2\1\0\6\5\4\0"s),
        4, {1, 2, 3, 0, 4, 5, 6, 0});
  refuses("BITMAPINFOHEADER", "a header of 20 bytes", bmp(of([](Fields& f) { f.header = 20; }), two),
          "found a header of 20 bytes, expected 12, 16, 40, 52, 56, 64, 108 or 124");
  reads("biHeight", "the top row first", bmp(of([](Fields& f) { f.width = 1, f.height = -2; }), "\3\2\1\0\6\5\4\0"s), 3,
        one_to_six);
  reads("biHeight", "the bottom row first, without the padding of the last",
        bmp(of([](Fields& f) { f.width = 1, f.height = 2; }), "\6\5\4\0\3\2\1"s), 3, one_to_six);
  refuses("biPlanes", "two planes", bmp(of([](Fields& f) { f.planes = 2; }), two), "found 2 planes, expected 1");
  reads("biBitCount", "1 bit", bmp(of([](Fields& f) { f.bits = 1, f.palette = colours; }), "\x40\0\0\0"s), 3,
        one_to_six);
  reads("biBitCount", "4 bits, fewer colours than 16, and a gap",
        bmp(of([](Fields& f) { f.bits = 4, f.palette = colours, f.colours = 2, f.gap = std::string(2000, 'x'); }),
            "\x01\0\0\0"s),
        3, one_to_six);
  reads("biBitCount", "8 bits, more colours than 256",
        bmp(of([](Fields& f) { f.bits = 8, f.palette = colours + std::string(4 * 300, 'x'), f.colours = 302; }),
            "\0\1\0\0"s),
        3, one_to_six);
  refuses("biBitCount", "2 bits", bmp(of([](Fields& f) { f.bits = 2, f.palette = colours; }), two),
          "found 2 bits a pixel, expected 1, 4, 8, 16, 24 or 32");
  refuses("biClrUsed", "a colour beyond the palette",
          bmp(of([](Fields& f) { f.bits = 8, f.palette = colours + colours, f.colours = 2; }), "\0\2\0\0"s),
          "pixel 1 of stored row 0: found colour 2, expected 0 to 1");
  // 3 of 31 is 24.7 of 255, which repeated bits make 24.
  reads("biCompression, BI_RGB", "16 bits: five a channel",
        bmp(of([](Fields& f) { f.bits = 16; }), bytes_of(std::uint16_t{3 << 10 | 31 << 5}) + "\0\0"s), 3,
        {25, 255, 0, 0, 0, 0});
  reads("biCompression, BI_RGB", "a fourth byte that means nothing",
        bmp(of([](Fields& f) { f.bits = 32; }), "\3\2\1\x63\6\5\4\0"s), 3, one_to_six,
        "found a fourth byte that differs from pixel to pixel, and no alpha mask, read as red, green and blue, without "
        "alpha");
  reads("biCompression, BI_BITFIELDS", "16 bits: five, six and five",
        bmp(of([](Fields& f) {
              f.bits = 16, f.compression = 3, f.masks = masks({0xf800, 0x07e0, 0x1f});
            }),
            bytes_of(std::uint16_t{3 << 11 | 63 << 5}) + "\x1f\0"s),
        3, {25, 255, 0, 0, 0, 255});
  reads("biCompression, BI_BITFIELDS", "ten bits a channel",
        bmp(of([](Fields& f) {
              f.width = 1, f.bits = 32, f.compression = 3, f.masks = masks({0x3ff00000, 0x000ffc00, 0x3ff});
            }),
            bytes_of(1u << 20 | 1023u << 10)),
        3, {64, 65535, 0}, "", 16);
  refuses("biCompression, BI_BITFIELDS", "a mask with a hole",
          bmp(of([](Fields& f) {
                f.bits = 16, f.compression = 3, f.masks = masks({0xf800, 0x0720, 0x1f});
              }),
              "\0\0\0\0"s),
          "green mask: found 1824, expected 1 to 16 bits of a pixel, side by side");
  refuses("biCompression, BI_BITFIELDS", "masks for 24 bits", bmp(of([](Fields& f) { f.compression = 3; }), two),
          "found masks for 24 bits a pixel, expected masks for 16 or 32");
  reads("biCompression, BI_ALPHABITFIELDS", "four masks behind the header",
        bmp(of([](Fields& f) {
              f.bits = 16, f.compression = 6, f.masks = masks({0xf000, 0x0f00, 0x00f0, 0x000f});
            }),
            "\x34\x12\x78\x56"s),
        4, {17, 34, 51, 68, 85, 102, 119, 136});
  const std::pair<std::uint32_t, const char*> packed[] = {
      {1, "RLE8 compression"}, {2, "RLE4 compression"}, {4, "a JPEG inside"}, {5, "a PNG inside"}};
  for (const auto& [compression, name] : packed)
    refuses("biCompression", name, bmp(of([c = compression](Fields& f) { f.bits = 8, f.compression = c; }), two),
            "found "s + name + ", expected pixels that are not compressed");
  return list;
}

} // namespace refraster::test
