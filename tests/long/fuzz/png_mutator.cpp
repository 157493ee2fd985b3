// How libFuzzer changes images: as it likes, and then the checksums of a PNG are made to fit again, most of the time.
// Otherwise nothing behind a changed byte would ever be read.

#include <zlib.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);

namespace {

using Bytes = std::span<std::uint8_t>;

std::uint32_t number(Bytes bytes) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data(), sizeof value);
  return __builtin_bswap32(value);
}
void set(Bytes bytes, std::uint32_t value) {
  value = __builtin_bswap32(value);
  std::memcpy(bytes.data(), &value, sizeof value);
}

/// Of a zlib stream that ends within the bytes: RFC 1950.
void fit_adler(Bytes stream) {
  constexpr std::size_t header = 2, adler = 4;
  if (stream.size() < header + adler) return;
  z_stream inflater{};
  if (inflateInit2(&inflater, -15) != Z_OK) return; // no header, no checksum
  inflater.next_in = stream.data() + header;
  inflater.avail_in = static_cast<uInt>(stream.size() - header - adler);
  uLong sum = adler32(0, nullptr, 0);
  std::array<std::uint8_t, 1 << 14> out;
  int status = Z_OK;
  while (status == Z_OK) {
    inflater.next_out = out.data();
    inflater.avail_out = static_cast<uInt>(out.size());
    status = inflate(&inflater, Z_NO_FLUSH);
    sum = adler32(sum, out.data(), static_cast<uInt>(out.size() - inflater.avail_out));
  }
  const std::size_t used = stream.size() - adler - inflater.avail_in;
  if (status == Z_STREAM_END) set(stream.subspan(used, adler), static_cast<std::uint32_t>(sum));
  inflateEnd(&inflater);
}

void fit_checksums(Bytes png) {
  constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t around_data = 12;
  if (png.size() < signature.size() || std::memcmp(png.data(), signature.data(), signature.size()) != 0) return;
  for (std::size_t at = signature.size(); png.size() - at >= around_data;) {
    const std::size_t length = number(png.subspan(at, 4));
    if (length > png.size() - at - around_data) return;
    const Bytes type_and_data = png.subspan(at + 4, 4 + length);
    if (std::memcmp(type_and_data.data(), "IDAT", 4) == 0) fit_adler(type_and_data.subspan(4));
    set(png.subspan(at + 8 + length, 4),
        static_cast<std::uint32_t>(crc32(0, type_and_data.data(), static_cast<uInt>(type_and_data.size()))));
    at += around_data + length;
  }
}

} // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed) {
  size = LLVMFuzzerMutate(data, size, max_size);
  if (seed % 16 != 0) fit_checksums({data, size});
  return size;
}
