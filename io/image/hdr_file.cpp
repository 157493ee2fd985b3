#include "io/file/atomic_file.h"
#include "io/file/number_text.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

// Radiance RGBE: three mantissas of 8 bits and the exponent of the largest, e: value = mantissa 2^(e - 136). Read and
// written here and not by stb. stb_image 2.27 reads a file that is cut within a coded row for ever, and puts rows that
// are not coded, behind one that is, into the wrong place; stb_image_write cuts the mantissas off where they should be
// rounded, and has no answer to a negative value or NaN. Rows are written without run lengths: a first pixel that a
// reader takes for the mark of a coded row, 2 2 below 128, has no mantissa of 128 or more, and is never written.

namespace refraster {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Each channel to the nearest of the 256 steps that the largest leaves. Negative and NaN become 0; beyond 1.7e38, the
/// largest.
Rgbe encode(const float* rgb) {
  std::array<double, 3> value;
  for (std::size_t c = 0; c < 3; ++c)
    value[c] = rgb[c] > 0 ? std::min(static_cast<double>(rgb[c]), 255 * std::ldexp(1.0, 119)) : 0;
  const double largest = std::max({value[0], value[1], value[2]});
  if (largest < std::ldexp(1.0, -128)) return {0, 0, 0, 0};
  int exponent = 0;
  std::frexp(largest, &exponent);                                          // largest in [2^(exponent-1), 2^exponent)
  if (std::nearbyint(std::ldexp(largest, 8 - exponent)) > 255) ++exponent; // rounds up to 256
  Rgbe pixel{0, 0, 0, static_cast<std::uint8_t>(exponent + 128)};
  for (std::size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::nearbyint(std::ldexp(value[c], 8 - exponent)));
  return pixel;
}

/// Six digits, for a message.
std::string factor_text(double factor) {
  std::array<char, 32> text;
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), factor, std::chars_format::general, 6).ptr};
}

/// Runs of up to 127 equal bytes, of two bytes each, in four planes: 16 pixels a byte are more than a row can have.
constexpr std::uint64_t pixels_per_byte = 16;
/// Rows of these widths may be coded.
constexpr std::uint64_t min_coded = 8, max_coded = 32767;

class HdrReader {
public:
  HdrReader(const std::string& path, std::string_view bytes, const ImageRequest& request)
      : path_(path), bytes_(bytes), request_(request) {}

  /// What was multiplied into the stored values, and is divided out: for ImageFile::notes.
  NoteList notes;

  Image<float> read() {
    header();
    const auto [width, height] = size();
    Image<float> image(static_cast<int>(width), static_cast<int>(height), 3);
    std::vector<Rgbe> row(width);
    float* at = image.values.data();
    for (std::uint64_t y = 0; y < height; ++y) {
      place_ = "row " + std::to_string(y);
      if (min_coded <= width && width <= max_coded && rest().starts_with("\2\2") && peek(2) < 128) coded(row);
      else plain(row);
      for (const Rgbe& pixel : row) {
        const float unit = pixel[3] ? std::ldexp(1.0f, pixel[3] - 136) : 0;
        for (std::size_t c = 0; c < 3; ++c) *at++ = original(static_cast<float>(pixel[c]) * unit, multiplier_[c]);
      }
    }
    return image;
  }

private:
  [[noreturn]] void fail(std::string found, std::string expected) const {
    throw InputError(InputFault{path_, 0, 0, place_, std::move(found), std::move(expected)});
  }
  std::string_view rest() const { return bytes_.substr(at_); }
  std::uint8_t peek(std::size_t ahead) const {
    if (bytes_.size() - at_ <= ahead) throw truncated_image(path_);
    return static_cast<std::uint8_t>(bytes_[at_ + ahead]);
  }
  std::uint8_t take() {
    const std::uint8_t byte = peek(0);
    ++at_;
    return byte;
  }
  std::string_view take_line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) throw truncated_image(path_);
    const std::string_view line = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }

  /// Variables and comments, a line each, up to an empty one. Primaries change nothing here: values are those of the
  /// file's red, green and blue. EXPOSURE and COLORCORR are multipliers that were applied to all pixels, each line on
  /// top of those before (Ward, "Radiance File Formats": the original radiance is the stored value divided by the
  /// product of all).
  void header() {
    bool is_rgbe = false;
    int number = 0, first_multiplier = 0;
    std::uint64_t multipliers = 0;
    for (std::string_view line = take_line(); ++number, !line.empty(); line = take_line()) {
      if (line.starts_with("FORMAT=")) {
        is_rgbe = line == "FORMAT=32-bit_rle_rgbe";
        if (!is_rgbe) fail(in_quotes(line), "FORMAT=32-bit_rle_rgbe");
      }
      const bool exposure = line.starts_with("EXPOSURE="), correction = line.starts_with("COLORCORR=");
      if (!exposure && !correction) continue;
      multiply(line, number, exposure ? 1 : 3);
      if (multipliers++ == 0) first_multiplier = number;
    }
    if (!is_rgbe) fail("no format", "FORMAT=32-bit_rle_rgbe");
    if (multiplier_ == std::array<double, 3>{1, 1, 1}) return;
    const bool one = multiplier_[0] == multiplier_[1] && multiplier_[1] == multiplier_[2];
    std::string factors = factor_text(multiplier_[0]);
    if (!one) factors += ", " + factor_text(multiplier_[1]) + ", " + factor_text(multiplier_[2]) + " (R, G, B)";
    notes.add({path_, first_multiplier, counted(multipliers, "line") + " of EXPOSURE or COLORCORR",
               "values are divided by " + factors});
  }

  /// One number for all channels, or one for each of them, with blanks around.
  void multiply(std::string_view line, int number, std::size_t count) {
    std::string_view text = line.substr(line.find('=') + 1);
    std::array<double, 3> factors{1, 1, 1};
    std::size_t words = 0;
    bool good = true;
    while (true) {
      text.remove_prefix(std::min(text.find_first_not_of(" \t\r"), text.size()));
      if (text.empty()) break;
      const std::string_view word = text.substr(0, text.find_first_of(" \t\r"));
      text.remove_prefix(word.size());
      if (words == count) good = false;
      else good &= read_number(word, factors[words++]) == NumberText::good;
    }
    good &= words == count;
    for (std::size_t c = 0; c < 3; ++c) {
      multiplier_[c] *= factors[count == 1 ? 0 : c];
      // A product beyond these ends leaves nothing of any value.
      good &= multiplier_[c] >= std::numeric_limits<double>::min() && std::isfinite(multiplier_[c]);
    }
    if (!good)
      throw InputError(InputFault{path_, number, 0, "", in_quotes(line),
                                  count == 1 ? "EXPOSURE= and a number > 0" : "COLORCORR= and three numbers > 0"});
  }

  static float original(float stored, double multiplier) {
    return static_cast<float>(static_cast<double>(stored) / multiplier);
  }

  /// Rows from the top, pixels from the left: the only order of the eight that is in use.
  std::pair<std::uint64_t, std::uint64_t> size() {
    const std::string_view line = take_line();
    std::string_view left = line;
    const auto number = [&](std::string_view prefix, std::uint64_t& value) {
      if (!left.starts_with(prefix)) return false;
      left.remove_prefix(prefix.size());
      const auto [stop, error] = std::from_chars(left.data(), left.data() + left.size(), value);
      left.remove_prefix(static_cast<std::size_t>(stop - left.data()));
      return error == std::errc();
    };
    std::uint64_t width = 0, height = 0;
    if (!number("-Y ", height) || !number(" +X ", width) || !left.empty()) fail(in_quotes(line), "-Y height +X width");
    check_image_size(path_, width, height, bytes_.size(), pixels_per_byte, request_);
    need_image(request_, path_, width * height, 3, 0);
    return {width, height};
  }

  void plain(std::vector<Rgbe>& row) {
    for (Rgbe& pixel : row) {
      for (std::uint8_t& byte : pixel) byte = take();
      // Files from before 1991 repeat a pixel so. No other pixel looks like it: one mantissa is at least 128.
      if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) fail("run lengths of the old kind", "those since 1991");
    }
  }

  void coded(std::vector<Rgbe>& row) {
    const std::size_t width = std::size_t{256} * peek(2) + peek(3);
    if (width != row.size()) fail(std::to_string(width) + " pixels", std::to_string(row.size()));
    at_ += 4;
    for (std::size_t channel = 0; channel < 4; ++channel)
      for (std::size_t x = 0; x < row.size();) {
        const std::size_t code = take(), count = code > 128 ? code - 128 : code;
        if (count == 0 || count > row.size() - x)
          fail("a run of " + std::to_string(count), "1 to " + std::to_string(row.size() - x));
        const bool is_run = code > 128;
        const std::uint8_t value = is_run ? take() : std::uint8_t{0};
        for (const std::size_t end = x + count; x < end; ++x) row[x][channel] = is_run ? value : take();
      }
  }

  const std::string& path_;
  std::string_view bytes_;
  const ImageRequest& request_;
  std::size_t at_ = 0;
  std::string place_;
  std::array<double, 3> multiplier_{1, 1, 1};
};

} // namespace

ImageFile read_hdr(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  ImageFile result;
  result.bits = 32;
  result.full_scale = 1;
  HdrReader reader(path, bytes, request);
  result.values = reader.read();
  result.notes = std::move(reader.notes);
  result.unit_roundoff = 0x1p-8; // half a step of a mantissa that is at least 128
  result.channels = default_channels(3);
  return result;
}

void write_hdr(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>&,
               const WriteOptions&) {
  AtomicFile file(path);
  file.write("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(image.height) + " +X " +
             std::to_string(image.width) + "\n");
  std::vector<Rgbe> row(static_cast<std::size_t>(image.width));
  std::vector<float> scratch;
  for (int y = 0; y < image.height; ++y) {
    const float* rgb = image.row(y, scratch);
    for (Rgbe& pixel : row) pixel = encode(rgb), rgb += 3;
    file.write(row.data(), row.size() * sizeof(Rgbe));
  }
  file.commit();
}

} // namespace refraster
