#include "io/file/atomic_file.h"
#include "io/file/number_text.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>

// Portable float map: "PF" (3 channels) or "Pf" (1), width, height, and a scale whose sign is the byte order, each
// after white space and the last before exactly one; then the rows from the bottom up.

namespace refraster {
namespace {

static_assert(std::endian::native == std::endian::little);

[[noreturn]] void fail(const std::string& path, std::string place, std::string found, std::string expected) {
  throw InputError(InputFault{path, 0, 0, std::move(place), std::move(found), std::move(expected)});
}

std::string_view take_word(std::string_view& text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::uint64_t take_size(const std::string& path, std::string_view& text, const char* place) {
  const std::string_view word = take_word(text);
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || stop != word.data() + word.size())
    fail(path, place, in_quotes(word), "a number of pixels");
  return value;
}

} // namespace

ImageFile read_pfm(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  std::string_view rest = bytes.substr(2);
  const int channels = bytes[1] == 'F' ? 3 : 1;
  const std::uint64_t width = take_size(path, rest, "width"), height = take_size(path, rest, "height");
  const std::string_view word = take_word(rest);
  double scale = 0;
  if (read_number(word, scale) != NumberText::good || scale == 0)
    fail(path, "scale", in_quotes(word), "a number that is not 0");
  check_image_size(path, width, height, bytes.size(), 1, request);
  if (!rest.empty()) rest.remove_prefix(1);
  const std::size_t row_bytes = width * static_cast<std::size_t>(channels) * sizeof(float);
  if (rest.size() != row_bytes * height)
    fail(path, "pixels", std::to_string(rest.size()) + " bytes", std::to_string(row_bytes * height) + " bytes");

  need_image(request, path, width * height, channels, 0);
  ImageFile result;
  result.bits = 32;
  result.full_scale = 1;
  result.values = Image<float>(static_cast<int>(width), static_cast<int>(height), channels);
  result.channels = default_channels(channels);
  for (std::size_t row = 0; row < height; ++row)
    std::memcpy(result.values.at(0, static_cast<int>(height - 1 - row)), rest.data() + row * row_bytes, row_bytes);
  if (scale > 0) // big-endian
    for (float& value : result.values.values)
      value = std::bit_cast<float>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
  return result;
}

void write_pfm(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>&,
               const WriteOptions&) {
  AtomicFile file(path);
  file.write((image.channels == 3 ? "PF\n" : "Pf\n") + std::to_string(image.width) + " " +
             std::to_string(image.height) + "\n-1.0\n");
  std::vector<float> scratch;
  for (int y = image.height - 1; y >= 0; --y) file.write(image.row(y, scratch), image.row_values() * sizeof(float));
  file.commit();
}

} // namespace refraster
