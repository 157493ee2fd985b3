#include "tests/support/files/image_clauses.h"
#include "tests/support/files/npy_bytes.h"

namespace refraster::test {

using namespace std::string_literals;

std::vector<ImageClause> npy_clauses() {
  std::vector<ImageClause> list;
  const auto reads = [&](const char* clause, const char* what, const std::string& bytes, int channels,
                         std::vector<float> values, int bits, const std::string& note = {}) {
    list.push_back({"NumPy "s + clause, what, "i.npy", bytes, channels, std::move(values), note, bits});
  };
  const auto refuses = [&](const char* clause, const char* what, const std::string& bytes, const std::string& said) {
    list.push_back({"NumPy "s + clause, what, "i.npy", bytes, 0, {}, said});
  };
  const std::string one = "\0\0\x80\x3f"s, two = "\0\0\0\x40"s;
  const auto with_header = [](const std::string& header, const std::string& values) {
    return "\x93NUMPY\x01\0"s + std::string{static_cast<char>(header.size()), '\0'} + header + values;
  };

  reads("shape", "two numbers: height and width, the top row first", npy_bytes("<f4", "(2, 1)", one + two), 1, {1, 2},
        32);
  reads("shape", "three: the channels run fastest", npy_bytes("|u1", "(1, 2, 3)", "\1\2\3\4\5\6"), 3,
        {1, 2, 3, 4, 5, 6}, 8);
  reads("descr", "16 bits", npy_bytes("<u2", "(1, 2)", "\1\0\0\1"s), 1, {1, 256}, 16);
  reads("descr", "32 bits", npy_bytes("<u4", "(1, 1)", "\0\0\1\0"s), 1, {65536}, 32);
  reads("descr", "32 bits that no float holds: 2^24 + 1", npy_bytes("<u4", "(1, 1)", "\1\0\0\1"s), 1, {16777216}, 32,
        "found a whole number beyond 2^24 that no float holds, read as the nearest that does");
  reads("descr", "double: 1.5", npy_bytes("<f8", "(1, 1)", "\0\0\0\0\0\0\xf8\x3f"s), 1, {1.5f}, 32);
  reads("header", "other quotes, another order, no comma at the end, no padding",
        with_header("{\"shape\":(1,1),\"descr\":\"|u1\",\"fortran_order\":False}", "\7"), 1, {7}, 8);
  refuses("descr", "big-endian", npy_bytes(">f4", "(1, 1)", one),
          "descr: found \">f4\", expected |u1, <u2, <u4, <f4 or <f8");
  refuses("descr", "a structured array", with_header("{'descr': [('a', '<f4')], }", one),
          "descr: found a structured array, expected an array of numbers");
  refuses("fortran_order", "columns one after the other", npy_bytes("<f4", "(1, 1)", one, "True"),
          "fortran_order: found True, expected False: rows one after the other");
  refuses("shape", "a single number", npy_bytes("<f4", "(1,)", one),
          "shape: found 1 numbers, expected (height, width) or (height, width, channels)");
  refuses("shape", "no channels", npy_bytes("<f4", "(1, 1, 0)", ""), "shape: found 0 channels, expected 1 to 64");
  refuses("header", "no shape", with_header("{'descr': '<f4', 'fortran_order': False}", one),
          "header: found a dictionary without all of its keys, expected descr, fortran_order and shape");
  refuses("header", "no dictionary", with_header("(1, 2)", one),
          "header: found \"(1, 2)\", expected a dictionary of Python as NumPy writes it");
  refuses("version", "2.0", "\x93NUMPY\x02\0\0\0\0\0"s, "found version 2.0, expected 1.0");
  return list;
}

} // namespace refraster::test
