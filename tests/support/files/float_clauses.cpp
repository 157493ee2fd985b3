#include "tests/support/files/image_clauses.h"
#include "tests/support/files/malformed_images.h"

namespace refraster::test {
namespace {

using namespace std::string_literals;

class List {
public:
  List(const char* specification, const char* name) : specification_(specification), name_(name) {}

  void reads(const char* clause, const char* what, const std::string& bytes, int channels, std::vector<float> values,
             const std::string& note = {}) {
    clauses.push_back({specification_ + " "s + clause, what, name_, bytes, channels, std::move(values), note, 32});
  }
  void refuses(const char* clause, const char* what, const std::string& bytes, const std::string& said) {
    clauses.push_back({specification_ + " "s + clause, what, name_, bytes, 0, {}, said});
  }

  std::vector<ImageClause> clauses;

private:
  const char *specification_, *name_;
};

const std::string one = "\0\0\x80\x3f"s, two = "\0\0\0\x40"s, minus_two_swapped = "\xc0\0\0\0"s;

} // namespace

std::vector<ImageClause> hdr_clauses() {
  List list("Radiance", "i.hdr");
  const auto hdr = [](const std::string& variables, const std::string& size, const std::string& pixels) {
    return "#?RADIANCE\n" + variables + "FORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + pixels;
  };
  const std::string pixel = "\x80\x40\x20\x81"; // mantissas 128, 64, 32, exponent 1: 1, 0.5, 0.25
  list.reads("pixels", "one pixel", hdr("", "-Y 1 +X 1", pixel), 3, {1, 0.5f, 0.25f});
  list.reads("pixels", "an exponent of 0 is black", hdr("", "-Y 1 +X 1", "\x80\x40\x20\0"s), 3, {0, 0, 0});
  list.reads("header", "the older first line", "#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + pixel, 3,
             {1, 0.5f, 0.25f});
  list.reads("EXPOSURE", "a factor that was applied is divided out", hdr("EXPOSURE=2\n", "-Y 1 +X 1", pixel), 3,
             {0.5f, 0.25f, 0.125f}, ":2: found 1 line of EXPOSURE or COLORCORR, values are divided by 2");
  list.refuses("FORMAT", "XYZ", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel,
               "found \"FORMAT=32-bit_rle_xyze\", expected FORMAT=32-bit_rle_rgbe");
  list.refuses("resolution", "columns first", hdr("", "+X 1 -Y 1", pixel),
               "found \"+X 1 -Y 1\", expected -Y height +X width");
  return list.clauses;
}

std::vector<ImageClause> pfm_clauses() {
  List list("PFM", "i.pfm");
  list.reads("Pf", "grey, little-endian, rows from the bottom", "Pf\n1 2\n-1\n" + one + two, 1, {2, 1});
  list.reads("PF", "red, green, blue", "PF\n1 1\n-1\n" + one + two + one, 3, {1, 2, 1});
  list.reads("scale", "a positive one: big-endian", "Pf\n1 1\n1.0\n" + minus_two_swapped, 1, {-2});
  list.reads("header", "blanks for line ends", "Pf 1 1 -1 " + two, 1, {2});
  list.refuses("scale", "0", "Pf\n1 1\n0\n" + one, "scale: found \"0\", expected a number that is not 0");
  return list.clauses;
}

std::vector<ImageClause> exr_clauses() {
  List list("OpenEXR", "i.exr");
  list.reads("scan lines", "two rows that are not compressed", exr_bytes(2, 0, {one + two, two + two}), 1,
             {1, 2, 2, 2});
  list.refuses("chunk", "a row that is too short", exr_bytes(2, 0, {one + two, one}),
               "chunk 1: found 4 bytes of pixels, expected 8");
  return list.clauses;
}

} // namespace refraster::test
