#include "io/image/image_formats.h"
#include "tests/support/files/image_clauses.h"
#include "tests/support/files/malformed_inputs.h"

namespace refraster::test {
namespace {

using namespace std::string_literals;

struct Fields {
  int type = 2, bits = 24, descriptor = 0x20; // the first row at the top
  std::uint16_t width = 2, height = 1;
  std::string id = {}, map = {};
  int map_bits = 0;
  std::uint16_t map_first = 0, map_length = 0;
};

std::string tga(const Fields& f, const std::string& pixels) {
  const auto byte = [](std::size_t value) { return std::string{static_cast<char>(value)}; };
  return byte(f.id.size()) + byte(f.map_length > 0) + byte(static_cast<std::size_t>(f.type)) + bytes_of(f.map_first) +
         bytes_of(f.map_length) + byte(static_cast<std::size_t>(f.map_bits)) + bytes_of(0u) + bytes_of(f.width) +
         bytes_of(f.height) + byte(static_cast<std::size_t>(f.bits)) + byte(static_cast<std::size_t>(f.descriptor)) +
         f.id + f.map + pixels;
}

const std::string two = "\3\2\1\6\5\4"; // 1 2 3, 4 5 6
const std::vector<float> one_to_six = {1, 2, 3, 4, 5, 6};

/// Two colours, the same as above, of which the first has a number.
Fields mapped(std::uint16_t first, int type = 1, int bits = 8) {
  Fields fields;
  fields.type = type, fields.bits = bits;
  fields.map = two, fields.map_bits = 24, fields.map_first = first, fields.map_length = 2;
  return fields;
}

} // namespace

std::vector<ImageClause> tga_clauses() {
  std::vector<ImageClause> list;
  const auto reads = [&](const char* clause, const char* what, const std::string& bytes, int channels,
                         std::vector<float> values) {
    list.push_back({"TGA "s + clause, what, "i.tga", bytes, channels, std::move(values)});
  };
  const auto refuses = [&](const char* clause, const char* what, const std::string& bytes, const std::string& said) {
    list.push_back({"TGA "s + clause, what, "i.tga", bytes, 0, {}, said});
  };
  const auto of = [](int type, int bits) {
    Fields fields;
    fields.type = type, fields.bits = bits;
    return fields;
  };
  const auto square = [&](int descriptor) {
    Fields fields = of(3, 8);
    fields.height = 2, fields.descriptor = descriptor;
    return tga(fields, "\1\2\3\4");
  };

  reads("field 5.6, bits 5-4", "from the bottom left", square(0x00), 1, {3, 4, 1, 2});
  reads("field 5.6, bits 5-4", "from the bottom right", square(0x10), 1, {4, 3, 2, 1});
  reads("field 5.6, bits 5-4", "from the top left", square(0x20), 1, {1, 2, 3, 4});
  reads("field 5.6, bits 5-4", "from the top right", square(0x30), 1, {2, 1, 4, 3});
  refuses("field 5.6, bits 7-6", "interleaved rows", square(0x40),
          "found interleaved rows, expected rows one after the other");
  Fields with_id;
  with_id.id = "an id";
  reads("field 1", "an id before the pixels", tga(with_id, two), 3, one_to_six);
  refuses("field 2", "no colour map", tga(of(1, 8), "\0\1"s),
          "found pixels that are numbers of colours, and no colour map, expected a colour map");
  Fields unused = mapped(0, 2, 24);
  reads("field 2", "a colour map that pixels do not use", tga(unused, two), 3, one_to_six);
  reads("field 3, type 1", "a colour map", tga(mapped(0), "\0\1"s), 3, one_to_six);
  reads("field 3, type 1", "numbers of 16 bits", tga(mapped(0, 1, 16), "\0\0\1\0"s), 3, one_to_six);
  reads("field 3, type 2", "colours", tga({}, two), 3, one_to_six);
  reads("field 3, type 3", "grey", tga(of(3, 8), "\x0a\x14"), 1, {10, 20});
  reads("field 3, type 3", "grey and alpha", tga(of(3, 16), "\x0a\1\x14\2"), 2, {10, 1, 20, 2});
  reads("field 3, type 9", "a colour map, in runs", tga(mapped(0, 9), "\x81\1"), 3, {4, 5, 6, 4, 5, 6});
  reads("field 3, type 10", "colours, in runs", tga(of(10, 24), "\x80\3\2\1"s + "\0\6\5\4"s), 3, one_to_six);
  Fields runs = of(11, 8);
  runs.height = 2;
  reads("field 3, type 11", "grey, a run across rows", tga(runs, "\x82\7\0\x08"s), 1, {7, 7, 7, 8});
  refuses("field 3, type 11", "a run that is cut", tga(runs, "\x82\7\0"s),
          "found a truncated image, expected a whole one");
  const std::string unknown = "found an unknown image type, expected " + readable_formats();
  refuses("field 3, type 0", "no image", tga(of(0, 24), two), unknown);
  refuses("field 3, type 32", "Huffman and delta codes", tga(of(32, 24), two), unknown);
  reads("field 4.1", "a map whose first colour has the number 5", tga(mapped(5), "\5\6"), 3, one_to_six);
  reads("field 4.1", "the same in runs", tga(mapped(5, 9), "\x80\5\x80\6"), 3, one_to_six);
  refuses("field 4.1", "a number below the first", tga(mapped(5), "\5\4"),
          "pixel 1 of stored row 0: found colour 4, expected 5 to 6");
  refuses("field 4.2", "a number beyond the last", tga(mapped(0), "\0\2"s),
          "pixel 1 of stored row 0: found colour 2, expected 0 to 1");
  Fields words = mapped(0);
  words.map = bytes_of(std::uint16_t{3 << 10 | 31 << 5}) + "\x1f\x80", words.map_bits = 16;
  reads("field 4.3", "colours of 16 bits in the map", tga(words, "\0\1"s), 3, {25, 255, 0, 0, 0, 255});
  Fields fours = mapped(0);
  fours.map = "\3\2\1\7\6\5\4\x08", fours.map_bits = 32;
  reads("field 4.3", "colours with alpha in the map", tga(fours, "\1\0"s), 4, {4, 5, 6, 8, 1, 2, 3, 7});
  Fields eight = mapped(0);
  eight.map_bits = 8;
  refuses("field 4.3", "colours of 8 bits in the map", tga(eight, "\0\1"s),
          "found 8 bits a colour of the map, expected 15, 16, 24 or 32");
  // 3 of 31 is 24.7 of 255.
  reads("field 5.5", "15 bits", tga(of(2, 15), bytes_of(std::uint16_t{3 << 10 | 31 << 5}) + "\x1f\0"s), 3,
        {25, 255, 0, 0, 0, 255});
  reads("field 5.5", "16 bits: the attribute bit is not read", tga(of(2, 16), "\0\x80\x1f\0"s), 3,
        {0, 0, 0, 0, 0, 255});
  reads("field 5.5", "32 bits", tga(of(2, 32), "\3\2\1\7\6\5\4\x08"), 4, {1, 2, 3, 7, 4, 5, 6, 8});
  refuses("field 5.5", "8 bits of colour", tga(of(2, 8), two), "found 8 bits a pixel, expected 15, 16, 24 or 32");
  reads("file footer", "version 2.0", tga({}, two) + std::string(8, '\0') + "TRUEVISION-XFILE.\0"s, 3, one_to_six);
  return list;
}

std::vector<ImageClause> all_image_clauses() {
  std::vector<ImageClause> list;
  for (const auto clauses :
       {png_clauses, jpeg_clauses, bmp_clauses, tga_clauses, hdr_clauses, pfm_clauses, exr_clauses, npy_clauses})
    for (ImageClause& clause : clauses()) list.push_back(std::move(clause));
  return list;
}

} // namespace refraster::test
