#include "tests/support/files/image_clauses.h"
#include "tests/support/files/jpeg_bytes.h"

namespace refraster::test {
namespace {

using namespace std::string_literals;

const std::vector<JpegComponent> three = {{1}, {2}, {3}}, four = {{1}, {2}, {3}, {4}};

JpegBytes with(int frame, std::vector<JpegComponent> components = {{1}}, const std::string& segments = "") {
  JpegBytes jpeg;
  jpeg.frame = frame;
  jpeg.components = std::move(components);
  jpeg.segments = segments;
  return jpeg;
}

/// 24 x 8 pixels, each block of one value, a restart marker before each but the first.
std::string restarted(int interval) {
  JpegBytes jpeg;
  jpeg.width = 17;
  jpeg.restart_interval = interval;
  jpeg.scans = {{{0}, {{10}, {20}, {30}}}};
  return jpeg_bytes(jpeg);
}

std::vector<float> three_blocks() {
  std::vector<float> row(17, 10);
  for (std::size_t x = 8; x < 17; ++x) row[x] = x < 16 ? 20 : 30;
  return row;
}

} // namespace

std::vector<ImageClause> jpeg_clauses() {
  std::vector<ImageClause> list;
  const auto reads = [&](const char* clause, const char* what, const std::string& bytes, int channels,
                         std::vector<float> values, const std::string& note = "") {
    list.push_back({clause, what, "i.jpg", bytes, channels, std::move(values), note});
  };
  const auto refuses = [&](const char* clause, const char* what, const std::string& bytes, const std::string& found) {
    list.push_back({clause, what, "i.jpg", bytes, 0, {}, "found " + found});
  };
  const std::string readable = ", expected baseline or progressive JPEG: 8 bits, Huffman codes, a whole file",
                    libjpeg = "what libjpeg refuses: ", truncated = "a truncated image, expected a whole one",
                    inks = "found inks, C M Y K, read as red (1 - C) (1 - K), and so on, without a colour profile";

  reads("T.81 B.2.2, SOF0", "grey", flat_jpeg(with(0xc0), {77}), 1, {77});
  reads("T.81 B.2.2, SOF1", "extended, of 8 bits", flat_jpeg(with(0xc1), {200}), 1, {200});
  reads("T.81 B.2.2, SOF2", "progressive: means only", flat_jpeg(with(0xc2, three), {100, 128, 128}), 3,
        {100, 100, 100});
  JpegBytes deep = with(0xc1);
  deep.precision = 12;
  refuses("T.81 B.2.2, SOF1", "12 bits", flat_jpeg(deep, {77}),
          libjpeg + "Unsupported JPEG data precision 12" + readable);
  refuses("T.81 B.2.2, SOF3", "lossless", flat_jpeg(with(0xc3), {77}),
          libjpeg + "Unsupported JPEG process: SOF type 0xc3" + readable);
  refuses("T.81 B.2.2, SOF5", "hierarchical", flat_jpeg(with(0xc5), {77}),
          libjpeg + "Unsupported JPEG process: SOF type 0xc5" + readable);
  refuses("T.81 B.2.2, SOF9", "arithmetic coding", flat_jpeg(with(0xc9), {77}), "arithmetic coding" + readable);
  refuses("T.81 B.2.2, SOF10", "arithmetic coding, progressive", flat_jpeg(with(0xca), {77}),
          "arithmetic coding" + readable);
  JpegBytes no_height;
  no_height.height = 0;
  refuses("T.81 B.2.5, DNL", "a height that follows the first scan", flat_jpeg(no_height, {77}),
          libjpeg + "Empty JPEG image (DNL not supported)" + readable);

  // R = Y + 1.402 (Cr - 128), G = Y - 0.714 (Cr - 128), B = Y.
  const std::vector<float> red = {240, 29, 100};
  reads("T.871 7", "Y Cb Cr", flat_jpeg(with(0xc0, three), {100, 128, 228}), 3, red);
  reads("T.81 A.1.1", "Cb and Cr at half the resolution", flat_jpeg(with(0xc0, {{1, 2, 2}, {2}, {3}}), {100, 128, 228}),
        3, red);
  reads("T.81 B.2.2", "components that are named R, G, B", flat_jpeg(with(0xc0, {{'R'}, {'G'}, {'B'}}), {10, 20, 30}),
        3, {10, 20, 30});
  reads("Adobe 5116, 18", "three components, not transformed",
        flat_jpeg(with(0xc0, three, adobe_segment(0)), {10, 20, 30}), 3, {10, 20, 30});
  // Adobe stores 255 - ink: 204 is a fifth of black.
  reads("Adobe 5116, 18", "C M Y K", flat_jpeg(with(0xc0, four, adobe_segment(0)), {255, 128, 0, 204}), 3,
        {204, 102, 0}, inks);
  reads("Adobe 5116, 18", "Y C C K", flat_jpeg(with(0xc0, four, adobe_segment(2)), {100, 128, 228, 255}), 3,
        {255 - 240, 255 - 29, 255 - 100}, inks);
  refuses("Adobe 5116, 18", "an unknown transform", flat_jpeg(with(0xc0, three, adobe_segment(7)), {10, 20, 30}),
          libjpeg + "Unknown Adobe color transform code 7" + readable);
  refuses(
      "T.81 B.2.2", "four components that nobody names", flat_jpeg(with(0xc0, four), {255, 128, 0, 204}),
      "four colour components, and no Adobe segment that says what they are, expected grey, RGB or YCbCr; or CMYK or "
      "YCCK with that segment");
  refuses("T.81 B.2.2", "two components", flat_jpeg(with(0xc0, {{1}, {2}}), {1, 2}),
          "2 colour components, expected 1, 3 or 4");

  JpegBytes separate = with(0xc0, three);
  separate.scans = {{{0}, {{100}}}, {{1}, {{128}}}, {{2}, {{228}}}};
  reads("T.81 B.2.3", "a scan for each component", jpeg_bytes(separate), 3, red);
  separate.scans.pop_back();
  list.push_back({"T.81 B.2.3",
                  "no scan for a component",
                  "i.jpg",
                  jpeg_bytes(separate),
                  0,
                  {},
                  "colour component 3: found no scan with its means, expected one"});
  reads("T.81 B.2.4.4", "restart markers", restarted(1), 1, three_blocks());
  std::string exchanged = restarted(1);
  exchanged[exchanged.find("\xff\xd1") + 1] = '\xd3';
  refuses("T.81 B.2.4.4", "restart markers in a wrong order", exchanged,
          libjpeg + "Corrupt JPEG data: found marker 0xd3 instead of RST1" + readable);
  JpegBytes few = with(0xc0);
  few.width = 17;
  few.scans = {{{0}, {{10}, {20}}}};
  refuses("T.81 B.1.1.5", "bits for fewer blocks", jpeg_bytes(few),
          libjpeg + "Corrupt JPEG data: premature end of data segment" + readable);
  JpegBytes open = with(0xc0);
  open.tail = "";
  refuses("T.81 B.2.1", "no end of image", flat_jpeg(open, {77}), truncated);
  reads("T.81 B.1.1.2", "bytes between segments",
        flat_jpeg(with(0xc0, {{1}}, jpeg_segment(0xfe, "text") + "abc"), {77}), 1, {77},
        "found what libjpeg warns of (Corrupt JPEG data: 3 extraneous bytes before marker 0xdb), read all the same");
  open.tail = "\xff\xd9 and more";
  reads("T.81 B.2.1", "bytes behind the end of image", flat_jpeg(open, {77}), 1, {77});
  reads("T.81 B.2.4.6", "an application's segment, a comment",
        flat_jpeg(with(0xc0, {{1}}, jpeg_segment(0xe5, "anything") + jpeg_segment(0xfe, "text")), {77}), 1, {77});
  reads("CIPA DC-008 4.6.4 A", "an orientation",
        flat_jpeg(with(0xc0, {{1}}, jpeg_segment(0xe1, "Exif\0\0"s + exif_bytes(3))), {77}), 1, {77},
        "found EXIF orientation 3, to be shown turned by 180 degrees, read as its rows are stored");
  return list;
}

} // namespace refraster::test
