#pragma once
// JPEG files of flat blocks, written here, so that what they mean can be worked out by hand.

#include <string>
#include <vector>

namespace refraster::test {

struct JpegComponent {
  int id, horizontal = 1, vertical = 1; // samples
};

/// What the first scan has, and all others if there are more: each component's blocks in the order of T.81, A.2.
struct JpegScan {
  std::vector<int> components;      // numbers in the list of JpegBytes
  std::vector<std::vector<int>> of; // for each MCU the means of its blocks, 0 to 255
};

struct JpegBytes {
  int frame = 0xc0; // SOF0
  int precision = 8, width = 1, height = 1;
  std::vector<JpegComponent> components = {{1}};
  std::string segments = {}; // before the frame
  std::vector<JpegScan> scans = {};
  int restart_interval = 0; // in MCUs; 0: none
  std::string tail = "\xff\xd9";
};

/// Quantization by 8 throughout, so that the coefficient of a block's mean m is m - 128; all others are 0.
std::string jpeg_bytes(const JpegBytes& jpeg);

/// One component's flat image in one block, and so for more: the usual case.
std::string flat_jpeg(JpegBytes jpeg, const std::vector<int>& means);

std::string jpeg_segment(int marker, const std::string& data);

/// Adobe's APP14: 0 no transform, 1 YCbCr, 2 YCCK.
std::string adobe_segment(char transform);

} // namespace refraster::test
