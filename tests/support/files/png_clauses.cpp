#include "tests/support/files/image_clauses.h"
#include "tests/support/files/png_bytes.h"

namespace refraster::test {
namespace {

using namespace std::string_literals;

const std::string end = png_chunk("IEND", "");

std::string idat(const std::string& rows) {
  return png_chunk("IDAT", zlib_stored(rows));
}

/// The last byte of a chunk is one of its CRC.
std::string damaged(std::string chunk) {
  chunk.back() ^= 1;
  return chunk;
}

/// Of 2 x 1 pixels of 8 bits: none, one or two more chunks before the pixels.
std::string grey_with(const std::string& chunks, const std::string& pixels = idat("\0\x0a\x14"s)) {
  return png_signature + png_header(2, 1, 8, 0) + chunks + pixels + end;
}

std::string palette_image(int bits, const std::string& row, const std::string& more = "") {
  return png_signature + png_header(2, 1, bits, 3) + png_chunk("PLTE", "\1\2\3\4\5\6") + more + idat(row) + end;
}

} // namespace

std::string exif_bytes(char orientation) {
  return "MM\0*\0\0\0\x08\0\1\1\x12\0\3\0\0\0\1\0"s + orientation + "\0\0\0\0\0\0"s;
}

std::vector<ImageClause> png_clauses() {
  std::vector<ImageClause> list;
  const auto reads = [&](const char* clause, const char* what, const std::string& bytes, int channels,
                         std::vector<float> values, const std::string& note = "", int bits = 8) {
    list.push_back({"PNG "s + clause, what, "i.png", bytes, channels, std::move(values), note, bits});
  };
  const auto refuses = [&](const char* clause, const char* what, const std::string& bytes, const std::string& said) {
    list.push_back({"PNG "s + clause, what, "i.png", bytes, 0, {}, said});
  };
  const auto image = [](std::uint32_t width, std::uint32_t height, int bits, int type, const std::string& rows) {
    return png_signature + png_header(width, height, bits, type) + idat(rows) + end;
  };
  const std::string by_specification = ", expected a PNG by its specification",
                    truncated = "found a truncated image, expected a whole one";

  reads("11.2.2", "grey of 1 bit", image(4, 1, 1, 0, "\0\xa0"s), 1, {255, 0, 255, 0});
  reads("11.2.2", "grey of 2 bits", image(4, 1, 2, 0, "\0\x1b"s), 1, {0, 85, 170, 255});
  reads("11.2.2", "grey of 4 bits", image(4, 1, 4, 0, "\0\x0f\x3c"s), 1, {0, 255, 51, 204});
  reads("11.2.2", "grey of 16 bits", image(2, 1, 16, 0, "\0\1\2\xff\xfe"s), 1, {258, 65534}, "", 16);
  reads("11.2.2", "colour and alpha of 16 bits", image(1, 1, 16, 6, "\0\0\1\0\2\0\3\0\4"s), 4, {1, 2, 3, 4}, "", 16);
  refuses("11.2.2", "colour type 5", image(1, 1, 8, 5, "\0\0"s),
          "found what libpng refuses: Invalid IHDR data, Invalid color type in IHDR" + by_specification);
  refuses("11.2.2", "3 bits", image(1, 1, 3, 0, "\0\0"s),
          "found what libpng refuses: Invalid IHDR data, Invalid bit depth in IHDR" + by_specification);
  refuses("11.2.2", "no pixels", image(0, 1, 8, 0, "\0"s),
          "found what libpng refuses: Invalid IHDR data, Image width is zero in IHDR" + by_specification);
  refuses(
      "5.3", "a wrong CRC of IHDR", png_signature + damaged(png_header(2, 1, 8, 0)) + idat("\0\1\2"s) + end,
      "chunk IHDR: found a CRC that does not fit the chunk, expected that of its type and data: the file is damaged");
  refuses(
      "5.3", "a wrong CRC of IDAT", grey_with("", damaged(idat("\0\1\2"s))),
      "chunk IDAT: found a CRC that does not fit the chunk, expected that of its type and data: the file is damaged");
  refuses(
      "5.3", "a wrong CRC of PLTE",
      png_signature + png_header(1, 1, 8, 3) + damaged(png_chunk("PLTE", "\1\2\3")) + idat("\0\0"s) + end,
      "chunk PLTE: found a CRC that does not fit the chunk, expected that of its type and data: the file is damaged");
  refuses(
      "5.3", "a wrong CRC of IEND", png_signature + png_header(1, 1, 8, 0) + idat("\0\1"s) + damaged(end),
      "chunk IEND: found a CRC that does not fit the chunk, expected that of its type and data: the file is damaged");
  reads("5.3", "a wrong CRC of a chunk that may be skipped", grey_with(damaged(png_chunk("tEXt", "a\0b"s))), 1,
        {10, 20}, "found a CRC that does not fit the chunk tEXt, skipped: the file may be damaged");
  refuses("5.4", "an unknown chunk that must not be skipped", grey_with(png_chunk("CgBI", "\x50\0\x20\2"s)),
          "chunk CgBI: found a chunk that a reader must know, expected IHDR, PLTE, IDAT, IEND, or one that may be "
          "skipped");
  reads("5.4", "an unknown chunk that may be skipped", grey_with(png_chunk("abCd", "efgh")), 1, {10, 20});
  refuses("5.6", "pixels before the palette", png_signature + png_header(1, 1, 8, 3) + idat("\0\0"s) + end,
          "chunk IDAT: found what libpng refuses: Missing PLTE before IDAT" + by_specification);
  reads("8.2", "an interlaced image", png_signature + png_header(2, 2, 8, 0, 1) + idat("\0\x0a\0\x14\0\x1e\x28"s) + end,
        1, {10, 20, 30, 40});
  // Row by row: as it is, less its left neighbour, less its upper one, less their mean, less Paeth's guess.
  reads("9.2", "all filters", image(2, 5, 8, 0, "\0\x0a\x14"s + "\1\x0a\x0a"s + "\2\5\5"s + "\3\3\3"s + "\4\1\2"s), 1,
        {10, 20, 10, 20, 15, 25, 10, 20, 11, 22});
  refuses("9.2", "an unknown filter", image(2, 1, 8, 0, "\5\x0a\x14"s),
          "found what libpng refuses: bad adaptive filter value" + by_specification);
  std::string wrong_sum = zlib_stored("\0\x0a\x14"s);
  wrong_sum.back() ^= 1;
  refuses("10.1", "a wrong Adler-32, with a CRC that fits", grey_with("", png_chunk("IDAT", wrong_sum)),
          "chunk IDAT: found a checksum that does not fit the pixels, expected their Adler-32: the file is damaged");
  const std::string sum_apart = png_chunk("IDAT", wrong_sum.substr(0, wrong_sum.size() - 4)) +
                                png_chunk("IDAT", wrong_sum.substr(wrong_sum.size() - 4));
  refuses("10.1", "a wrong Adler-32, in a chunk of its own", grey_with("", sum_apart),
          "chunk IDAT: found a checksum that does not fit the pixels, expected their Adler-32: the file is damaged");
  const std::string stream = zlib_stored("\0\x0a\x14"s);
  reads("10.1", "pixels in two chunks",
        grey_with("", png_chunk("IDAT", stream.substr(0, 9)) + png_chunk("IDAT", stream.substr(9))), 1, {10, 20});
  reads("10.1", "bytes behind the stream of pixels", grey_with("", png_chunk("IDAT", stream + "xyz")), 1, {10, 20},
        "found what libpng warns of (IDAT: Extra compressed data), read without it");
  refuses("11.2.4", "pixels for fewer rows", image(2, 2, 8, 0, "\0\x0a\x14"s),
          "found what libpng refuses: Not enough image data" + by_specification);
  refuses("11.2.4", "pixels for more rows", image(2, 1, 8, 0, "\0\x0a\x14\0\1\2"s),
          "chunk IDAT: found what libpng refuses: Too much image data" + by_specification);
  refuses("11.2.5", "no IEND", png_signature + png_header(1, 1, 8, 0) + idat("\0\1"s), truncated);
  reads("11.2.3", "a palette", palette_image(1, "\0\x40"s), 3, {1, 2, 3, 4, 5, 6});
  refuses("11.2.3", "a colour beyond the palette", palette_image(2, "\0\x20"s),
          "pixel 1 of row 0: found colour 2, expected 0 to 1");
  reads("11.3.2.1", "alpha of the first colours of a palette", palette_image(8, "\0\1\0"s, png_chunk("tRNS", "\x40")),
        4, {4, 5, 6, 255, 1, 2, 3, 64});
  reads("11.3.2.1", "one transparent colour",
        png_signature + png_header(2, 1, 8, 2) + png_chunk("tRNS", "\0\4\0\5\0\6"s) + idat("\0\1\2\3\4\5\6"s) + end, 4,
        {1, 2, 3, 255, 4, 5, 6, 0});
  refuses(
      "11.3.2.1", "a wrong CRC of tRNS", palette_image(8, "\0\1\0"s, damaged(png_chunk("tRNS", "\x40"))),
      "chunk tRNS: found a CRC that does not fit the chunk, expected that of its type and data: the file is damaged");
  reads("11.3.3.2", "a gamma of 1: values stay as stored", grey_with(png_chunk("gAMA", big_endian(100000))), 1,
        {10, 20});
  reads("11.3.3.4", "3 significant bits: values stay as stored", grey_with(png_chunk("sBIT", "\3")), 1, {10, 20});
  reads("extensions, eXIf", "an orientation", grey_with(png_chunk("eXIf", exif_bytes(6))), 1, {10, 20},
        "found EXIF orientation 6, to be shown turned by 90 degrees clockwise, read as its rows are stored");
  refuses("extensions, eXIf", "longer than the file", grey_with("\x32\xff\0\x1a"s + "eXIf"), truncated);
  reads("extensions, eXIf", "the usual orientation", grey_with(png_chunk("eXIf", exif_bytes(1))), 1, {10, 20});
  return list;
}

} // namespace refraster::test
