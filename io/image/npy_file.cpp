#include "io/file/atomic_file.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"
#include "io/image/little_endian.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

// An array of NumPy: "\x93NUMPY", a version, the size of the header, the header, which is a literal of Python, and the
// values, of which the last index runs fastest. An image has the shape (height, width), or (height, width, channels),
// the top row first. NumPy, numpy.lib.format, version 1.0.

namespace refraster {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::size_t prefix_bytes = 10;                  // of the signature, the version and the size
constexpr std::size_t block_bytes = std::size_t{1} << 20; // of values, that are written at once

/// Why a header is refused.
struct Unreadable {
  std::string place, found, expected;
};

/// What the header says.
struct NpyHeader {
  std::string type;
  std::optional<bool> fortran_order;
  std::optional<std::vector<std::uint64_t>> shape;
};

/// Reads a dictionary of Python as NumPy writes them: strings without escapes, True and False, tuples of whole numbers.
class HeaderReader {
public:
  explicit HeaderReader(std::string_view text) : rest_(text) {}

  NpyHeader header() {
    NpyHeader header;
    need('{');
    while (!takes('}')) {
      const std::string key = string();
      need(':');
      if (key == "descr") {
        if (next() == '[') throw Unreadable{"descr", "a structured array", "an array of numbers"};
        header.type = string();
      } else if (key == "fortran_order") {
        header.fortran_order = boolean();
      } else if (key == "shape") {
        header.shape = tuple();
      } else {
        throw Unreadable{"header", "the key " + in_quotes(key), "descr, fortran_order and shape"};
      }
      if (takes(',')) continue;
      need('}');
      break;
    }
    if (next() != '\0') fail();
    if (header.type.empty() || !header.fortran_order || !header.shape)
      throw Unreadable{"header", "a dictionary without all of its keys", "descr, fortran_order and shape"};
    return header;
  }

private:
  [[noreturn]] void fail() const {
    throw Unreadable{"header", in_quotes(rest_.substr(0, 20)), "a dictionary of Python as NumPy writes it"};
  }
  /// Behind blanks; 0 at the end.
  char next() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size()));
    return rest_.empty() ? '\0' : rest_[0];
  }
  bool takes(char c) {
    if (next() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void need(char c) {
    if (!takes(c)) fail();
  }
  std::string string() {
    const char quote = next();
    if (quote != '\'' && quote != '"') fail();
    const std::size_t end = rest_.find(quote, 1);
    if (end == std::string_view::npos) fail();
    std::string text(rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return text;
  }
  bool boolean() {
    next();
    for (const auto& [word, value] : {std::pair("True", true), std::pair("False", false)})
      if (rest_.starts_with(word)) {
        rest_.remove_prefix(std::strlen(word));
        return value;
      }
    fail();
  }
  std::vector<std::uint64_t> tuple() {
    std::vector<std::uint64_t> numbers;
    need('(');
    while (!takes(')')) {
      next();
      std::uint64_t number = 0;
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), number);
      if (error != std::errc()) fail();
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      numbers.push_back(number);
      if (takes(',')) continue;
      need(')');
      break;
    }
    return numbers;
  }

  std::string_view rest_;
};

/// Of what type values can be, and what a file says of it. `int` is anything that no float holds exactly.
struct NpyType {
  std::string_view descr;
  std::size_t bytes;
  int bits;
  double full_scale;
};
constexpr NpyType types[] = {
    {"|u1", 1, 8, 255}, {"<u2", 2, 16, 65535}, {"<u4", 4, 32, 1}, {"<f4", 4, 32, 1}, {"<f8", 8, 32, 1}};

const NpyType& type_of(const std::string& path, const std::string& descr) {
  for (const NpyType& type : types)
    if (type.descr == descr) return type;
  std::vector<std::string> known;
  for (const NpyType& type : types) known.emplace_back(type.descr);
  refuse_image(path, "descr", in_quotes(descr), alternatives(known));
}

/// The number of those that a float does not hold exactly is returned.
template <class Value>
std::uint64_t copy_values(std::string_view bytes, std::vector<float>& to) {
  std::uint64_t inexact = 0;
  for (std::size_t i = 0; i < to.size(); ++i) {
    const auto value = little_endian<Value>(bytes, i * sizeof(Value));
    if constexpr (std::same_as<Value, double>) {
      constexpr double largest = static_cast<double>(std::numeric_limits<float>::max());
      to[i] = static_cast<float>(std::isfinite(value) ? std::clamp(value, -largest, largest) : value);
    } else {
      to[i] = static_cast<float>(value);
    }
    if constexpr (std::same_as<Value, std::uint32_t>) inexact += static_cast<double>(to[i]) != value;
  }
  return inexact;
}

template <class Value>
constexpr std::string_view descr_of() {
  if (sizeof(Value) == 1) return "|u1";
  if (sizeof(Value) == 2) return "<u2";
  return std::same_as<Value, float> ? "<f4" : "<u4";
}

template <class Value>
void write_array(const std::string& path, const ImageRows<Value>& image) {
  std::string shape = std::to_string(image.height) + ", " + std::to_string(image.width);
  if (image.channels > 1) shape += ", " + std::to_string(image.channels);
  std::string header =
      "{'descr': '" + std::string(descr_of<Value>()) + "', 'fortran_order': False, 'shape': (" + shape + "), }";
  // The values begin at a multiple of 64 bytes, behind a line end.
  constexpr std::size_t alignment = 64;
  header.resize((prefix_bytes + header.size() + alignment) / alignment * alignment - prefix_bytes - 1, ' ');
  header += '\n';
  std::string prefix = "\x93NUMPY\x01";
  prefix += '\0';
  append_little_endian(prefix, static_cast<std::uint16_t>(header.size()));
  AtomicFile file(path);
  file.write(prefix + header);
  std::string block; // rows that are written at once: a call for each would take longer than they do
  std::vector<Value> scratch;
  for (int y = 0; y < image.height; ++y) {
    block.append(reinterpret_cast<const char*>(image.row(y, scratch)), image.row_values() * sizeof(Value));
    if (block.size() < block_bytes && y + 1 < image.height) continue;
    file.write(block);
    block.clear();
  }
  file.commit();
}

} // namespace

ImageFile read_npy(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  if (bytes.size() < prefix_bytes) throw truncated_image(path);
  const auto major = little_endian<std::uint8_t>(bytes, 6), minor = little_endian<std::uint8_t>(bytes, 7);
  if (major != 1 || minor != 0)
    refuse_image(path, "", "version " + std::to_string(major) + "." + std::to_string(minor), "1.0");
  const std::size_t header_bytes = little_endian<std::uint16_t>(bytes, 8);
  if (bytes.size() < prefix_bytes + header_bytes) throw truncated_image(path);
  NpyHeader header;
  try {
    header = HeaderReader(bytes.substr(prefix_bytes, header_bytes)).header();
  } catch (const Unreadable& fault) {
    refuse_image(path, fault.place, fault.found, fault.expected);
  }
  const NpyType& type = type_of(path, header.type);
  const std::vector<std::uint64_t>& shape = *header.shape;
  if (*header.fortran_order) refuse_image(path, "fortran_order", "True", "False: rows one after the other");
  if (shape.size() != 2 && shape.size() != 3)
    refuse_image(path, "shape", std::to_string(shape.size()) + " numbers",
                 "(height, width) or (height, width, channels)");
  const std::uint64_t height = shape[0], width = shape[1], channels = shape.size() == 3 ? shape[2] : 1;
  if (channels == 0 || channels > limit::image_channels.value)
    refuse_image(path, "shape", std::to_string(channels) + " channels",
                 "1 to " + std::to_string(limit::image_channels.value));
  check_image_size(path, width, height, bytes.size(), 1, request);
  const std::string_view values = bytes.substr(prefix_bytes + header_bytes);
  const std::uint64_t expected = width * height * channels * type.bytes;
  if (values.size() != expected)
    refuse_image(path, "values", std::to_string(values.size()) + " bytes", std::to_string(expected) + " bytes");
  need_image(request, path, width * height, static_cast<int>(channels), 0);

  ImageFile image;
  image.bits = type.bits;
  image.full_scale = type.full_scale;
  image.values = Image<float>(static_cast<int>(width), static_cast<int>(height), static_cast<int>(channels));
  image.channels = default_channels(image.values.channels);
  if (channels == 2) image.channels = {"U", "V"}; // of arrays nothing says that the second is an alpha
  std::vector<float>& to = image.values.values;
  std::uint64_t inexact = 0;
  if (type.descr == "|u1") copy_values<std::uint8_t>(values, to);
  else if (type.descr == "<u2") copy_values<std::uint16_t>(values, to);
  else if (type.descr == "<u4") inexact = copy_values<std::uint32_t>(values, to);
  else if (type.descr == "<f4") copy_values<float>(values, to);
  else copy_values<double>(values, to);
  if (inexact > 0)
    image.notes.add(
        {path, 0, "a whole number beyond 2^24 that no float holds", "read as the nearest that does", inexact});
  return image;
}

void write_npy(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions&) {
  write_array(path, image);
}
void write_npy(const std::string& path, const ImageRows<std::uint16_t>& image, const WriteOptions&) {
  write_array(path, image);
}
void write_npy(const std::string& path, const ImageRows<std::uint32_t>& image, const WriteOptions&) {
  write_array(path, image);
}
void write_npy(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>&,
               const WriteOptions&) {
  write_array(path, image);
}

} // namespace refraster
