#include "tests/support/files/jpeg_bytes.h"

#include <bit>
#include <cstdlib>

namespace refraster::test {
namespace {

using namespace std::string_literals;

std::string byte(int value) {
  return {static_cast<char>(value)};
}
std::string word(int value) {
  return byte(value >> 8 & 255) + byte(value & 255);
}

/// Bits of a scan; a byte of ones is followed by a zero (T.81, B.1.1.5).
class Bits {
public:
  void add(unsigned value, int count) {
    for (int i = count - 1; i >= 0; --i) {
      byte_ = byte_ << 1 | (value >> i & 1u);
      if (++count_ == 8) flush();
    }
  }
  /// Filled up with ones.
  std::string ended() {
    while (count_ > 0) add(1, 1);
    return std::move(text_);
  }

private:
  void flush() {
    text_ += static_cast<char>(byte_);
    if (byte_ == 255) text_ += '\0';
    byte_ = 0;
    count_ = 0;
  }
  unsigned byte_ = 0;
  int count_ = 0;
  std::string text_;
};

/// The difference of a mean to the one before, by category (T.81, F.1.2.1); the code of a category is its number, in
/// four bits. All else is 0: the code 0, in one bit.
void add_block(Bits& bits, int difference, bool is_progressive) {
  const int category = static_cast<int>(std::bit_width(static_cast<unsigned>(std::abs(difference))));
  bits.add(static_cast<unsigned>(category), 4);
  bits.add(static_cast<unsigned>(difference > 0 ? difference : difference - 1), category);
  if (!is_progressive) bits.add(0, 1);
}

std::string scan_bytes(const JpegBytes& jpeg, const JpegScan& scan) {
  const bool is_progressive = jpeg.frame == 0xc2;
  std::string header = byte(static_cast<int>(scan.components.size()));
  std::vector<std::size_t> of_block; // the component of each block of an MCU
  for (const int number : scan.components) {
    const JpegComponent& component = jpeg.components[static_cast<std::size_t>(number)];
    header += byte(component.id) + byte(0);
    const int blocks = scan.components.size() == 1 ? 1 : component.horizontal * component.vertical;
    for (int i = 0; i < blocks; ++i) of_block.push_back(static_cast<std::size_t>(number));
  }
  std::string result = jpeg_segment(0xda, header + byte(0) + byte(is_progressive ? 0 : 63) + byte(0));
  Bits bits;
  std::vector<int> before(jpeg.components.size(), 128);
  for (std::size_t mcu = 0; mcu < scan.of.size(); ++mcu) {
    const int interval = jpeg.restart_interval, number = static_cast<int>(mcu);
    if (interval > 0 && number > 0 && number % interval == 0) {
      result += bits.ended() + "\xff" + byte(0xd0 + (number / interval - 1) % 8);
      before.assign(before.size(), 128);
    }
    for (std::size_t i = 0; i < scan.of[mcu].size(); ++i) {
      int& last = before[of_block[i]];
      add_block(bits, scan.of[mcu][i] - last, is_progressive);
      last = scan.of[mcu][i];
    }
  }
  return result + bits.ended();
}

} // namespace

std::string jpeg_segment(int marker, const std::string& data) {
  return "\xff" + byte(marker) + word(static_cast<int>(data.size()) + 2) + data;
}

std::string adobe_segment(char transform) {
  return jpeg_segment(0xee, "Adobe\0\x64\0\0\0\0"s + transform);
}

std::string jpeg_bytes(const JpegBytes& jpeg) {
  std::string frame =
      byte(jpeg.precision) + word(jpeg.height) + word(jpeg.width) + byte(static_cast<int>(jpeg.components.size()));
  for (const JpegComponent& component : jpeg.components)
    frame += byte(component.id) + byte(component.horizontal << 4 | component.vertical) + byte(0);
  // Twelve codes of four bits: the categories; one code of one bit: the end of a block.
  const std::string means = "\0\0\0\0\x0c"s + std::string(12, '\0') + "\0\1\2\3\4\5\6\7\x08\x09\x0a\x0b"s,
                    others = "\x10\1"s + std::string(15, '\0') + "\0"s;
  std::string bytes = "\xff\xd8" + jpeg.segments + jpeg_segment(0xdb, "\0"s + std::string(64, '\x08')) +
                      jpeg_segment(jpeg.frame, frame) + jpeg_segment(0xc4, means) + jpeg_segment(0xc4, others);
  if (jpeg.restart_interval > 0) bytes += jpeg_segment(0xdd, word(jpeg.restart_interval));
  for (const JpegScan& scan : jpeg.scans) bytes += scan_bytes(jpeg, scan);
  return bytes + jpeg.tail;
}

std::string flat_jpeg(JpegBytes jpeg, const std::vector<int>& means) {
  JpegScan scan;
  std::vector<int> mcu;
  for (std::size_t i = 0; i < means.size(); ++i) {
    scan.components.push_back(static_cast<int>(i));
    const int blocks = means.size() == 1 ? 1 : jpeg.components[i].horizontal * jpeg.components[i].vertical;
    mcu.insert(mcu.end(), static_cast<std::size_t>(blocks), means[i]);
  }
  scan.of = {mcu};
  jpeg.scans = {scan};
  return jpeg_bytes(jpeg);
}

} // namespace refraster::test
