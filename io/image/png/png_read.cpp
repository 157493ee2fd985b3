#include "io/file/text.h"
#include "io/image/exif.h"
#include "io/image/image_formats.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdio>
#include <cstring>

// PNG by libpng, which checks what stb_image does not: the CRC of each chunk, the checksum of the pixels, the order of
// chunks. Values are as stored: chunks that say how to show them (gAMA, cHRM, sRGB, iCCP) are not even looked at.

namespace refraster {
namespace {

/// Deflate makes at most 1032 bytes of one, and the smallest pixel is one bit.
constexpr std::uint64_t pixels_per_byte = 8 * 1032;

/// The first of some remarks of libpng, and how many there are.
struct Remark {
  char first[128];
  int count;

  void add(const char* text) {
    if (count++ == 0) std::snprintf(first, sizeof first, "%s", text);
  }
};

/// What libpng's callbacks work on. libpng leaves them by longjmp: everything here and in them is trivially
/// destructible, and nothing in them throws.
struct State {
  std::string_view bytes;
  std::size_t at;
  bool is_truncated;
  Remark error, skipped, other; // skipped: chunks whose CRC is wrong
};

/// Of a chunk that is longer than the file, the bound that libpng is given. Only a warning to libpng, which then takes
/// memory for it.
constexpr std::string_view too_long = "chunk data is too large";

[[noreturn]] void on_error(png_structp png, png_const_charp text) {
  static_cast<State*>(png_get_error_ptr(png))->error.add(text);
  png_longjmp(png, 1);
}

/// Pixels depend on IDAT and tRNS: where libpng would go on without what is wrong there, that is an error here.
void on_warning(png_structp png, png_const_charp text) {
  State& state = *static_cast<State*>(png_get_error_ptr(png));
  const std::string_view said(text);
  const bool of_pixels = said.starts_with("IDAT: ") || said.starts_with("tRNS: ");
  if ((of_pixels && said != "IDAT: Extra compressed data") || said.ends_with(too_long)) png_error(png, text);
  (said.ends_with(": CRC error") ? state.skipped : state.other).add(text);
}

void on_read(png_structp png, png_bytep data, std::size_t size) {
  State& state = *static_cast<State*>(png_get_io_ptr(png));
  if (size > state.bytes.size() - state.at) {
    state.is_truncated = true;
    png_error(png, "the file ends");
  }
  std::memcpy(data, state.bytes.data() + state.at, size);
  state.at += size;
}

/// libpng's structures, and the one place where its errors arrive.
class Png {
public:
  explicit Png(State& state) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &state, on_error, on_warning);
    if (png_) info_ = png_create_info_struct(png_);
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png_, &state, on_read);
  }
  ~Png() { png_destroy_read_struct(&png_, &info_, nullptr); }
  Png(const Png&) = delete;
  Png& operator=(const Png&) = delete;

  /// Runs a step of libpng; false if it ends in an error. The step must hold nothing that has a destructor.
  template <class Step>
  bool runs(const Step& step) {
    if (setjmp(png_jmpbuf(png_))) return false; // NOLINT(cert-err52-cpp): what libpng has
    step(png_, info_);
    return true;
  }

private:
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

/// What libpng says, `IDAT: CRC error`, as place, found and expected.
[[noreturn]] void refuse(const std::string& path, const State& state) {
  const std::string text = one_line(state.error.first);
  if (text == "Out of memory") throw std::bad_alloc();
  if (state.is_truncated || text.ends_with(too_long)) throw truncated_image(path);
  const bool names_chunk = text.size() > 6 && text.compare(4, 2, ": ") == 0;
  const std::string place = names_chunk ? "chunk " + text.substr(0, 4) : "", what = names_chunk ? text.substr(6) : text;
  if (what == "CRC error")
    refuse_image(path, place, "a CRC that does not fit the chunk", "that of its type and data: the file is damaged");
  if (what == "incorrect data check")
    refuse_image(path, place, "a checksum that does not fit the pixels", "their Adler-32: the file is damaged");
  if (what == "unhandled critical chunk")
    refuse_image(path, place, "a chunk that a reader must know", "IHDR, PLTE, IDAT, IEND, or one that may be skipped");
  const std::string more = state.other.count > 0 ? ", " + one_line(state.other.first) : "";
  refuse_image(path, place, "what libpng refuses: " + what + more, "a PNG by its specification");
}

struct Header {
  png_uint_32 width, height;
  int bits, colour_type, palette_size;
  int channels, passes; // as the rows are read
  std::size_t row_bytes;
  std::array<std::array<std::uint8_t, 4>, 256> palette; // R G B A
};

/// The chunks before the pixels. No memory is taken for a row yet.
void read_header(png_structp png, png_infop info, Header& header) {
  // Chunks that cannot change a value are skipped unread, so that none asks for memory.
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_AS_DEFAULT, reinterpret_cast<png_const_bytep>("eXIf"), 1);
  png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); // check_image_size has ours
  png_read_info(png, info);
  png_get_IHDR(png, info, &header.width, &header.height, &header.bits, &header.colour_type, nullptr, nullptr, nullptr);
}

/// Rows are asked for as bytes, or 16-bit numbers in this machine's order. Palettes are applied here, since libpng
/// takes an index beyond the palette for black.
void prepare_rows(png_structp png, png_infop info, Header& header) {
  png_bytep alpha = nullptr;
  int alphas = 0;
  if (!png_get_tRNS(png, info, &alpha, &alphas, nullptr)) alphas = 0;
  if (header.colour_type == PNG_COLOR_TYPE_PALETTE) {
    png_colorp colours = nullptr;
    png_get_PLTE(png, info, &colours, &header.palette_size);
    for (int i = 0; i < header.palette_size; ++i)
      header.palette[static_cast<std::size_t>(i)] = {colours[i].red, colours[i].green, colours[i].blue,
                                                     i < alphas ? alpha[i] : std::uint8_t{255}};
    png_set_packing(png);
  } else {
    png_set_expand(png); // grey of 1, 2, 4 bits to 8; the transparent colour to alpha
  }
  if (header.bits == 16) png_set_swap(png);
  header.passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  header.channels = header.colour_type == PNG_COLOR_TYPE_PALETTE ? (alphas > 0 ? 4 : 3) : png_get_channels(png, info);
  header.row_bytes = png_get_rowbytes(png, info);
}

/// One row of libpng into one of floats.
void convert_row(const std::string& path, const Header& header, int y, const png_byte* row, float* out) {
  if (header.colour_type == PNG_COLOR_TYPE_PALETTE) {
    for (std::size_t x = 0; x < header.width; ++x) {
      if (row[x] >= header.palette_size)
        refuse_image(path, "pixel " + std::to_string(x) + " of row " + std::to_string(y),
                     "colour " + std::to_string(row[x]), "0 to " + std::to_string(header.palette_size - 1));
      const auto& colour = header.palette[row[x]];
      out = std::copy_n(colour.begin(), header.channels, out);
    }
  } else if (header.bits == 16) {
    for (std::size_t i = 0; i < header.row_bytes; i += 2) {
      std::uint16_t value = 0;
      std::memcpy(&value, &row[i], sizeof value);
      *out++ = value;
    }
  } else {
    std::copy_n(row, header.row_bytes, out);
  }
}

void add_notes(ImageFile& image, const std::string& path, const State& state) {
  const auto add = [&](const Remark& remark, const std::string& found, const std::string& consequence) {
    if (remark.count > 0) image.notes.add({path, 0, found, consequence, static_cast<std::uint64_t>(remark.count)});
  };
  const std::string_view skipped(state.skipped.first);
  add(state.skipped, "a CRC that does not fit the chunk " + one_line(skipped.substr(0, 4)),
      "skipped: the file may be damaged");
  add(state.other, "what libpng warns of (" + one_line(state.other.first) + ")", "read without it");
}

} // namespace

ImageFile read_png(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  State state{};
  state.bytes = bytes;
  Png png(state);
  Header header{};
  const std::size_t file_bytes = bytes.size();
  const auto begin = [&header, file_bytes](png_structp p, png_infop info) {
    png_set_chunk_malloc_max(p, file_bytes);
    read_header(p, info, header);
  };
  if (!png.runs(begin)) refuse(path, state);
  check_image_size(path, header.width, header.height, file_bytes, pixels_per_byte, request);
  if (!png.runs([&header](png_structp p, png_infop info) { prepare_rows(p, info, header); })) refuse(path, state);
  const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
  const int height = static_cast<int>(header.height);
  const bool interlaced = header.passes > 1;
  need_image(request, path, pixels, header.channels, interlaced ? static_cast<std::uint64_t>(header.bits + 7) / 8 : 0);

  ImageFile result;
  result.values = Image<float>(static_cast<int>(header.width), height, header.channels);
  // The passes of an interlaced image fill all rows step by step.
  std::vector<png_byte> rows(header.row_bytes * (interlaced ? header.height : 1));
  for (int pass = 0; pass < header.passes; ++pass)
    for (int y = 0; y < height; ++y) {
      png_byte* const row = rows.data() + (interlaced ? header.row_bytes * static_cast<std::size_t>(y) : 0);
      if (!png.runs([row](png_structp p, png_infop) { png_read_row(p, row, nullptr); })) refuse(path, state);
      if (pass + 1 == header.passes) convert_row(path, header, y, row, result.values.at(0, y));
    }

  std::string_view exif;
  const auto end = [&exif](png_structp p, png_infop info) {
    png_read_end(p, info);
    png_uint_32 size = 0;
    png_bytep data = nullptr;
    if (png_get_eXIf_1(p, info, &size, &data)) exif = {reinterpret_cast<const char*>(data), size};
  };
  if (!png.runs(end)) refuse(path, state);
  add_notes(result, path, state);
  note_orientation(result, path, exif_orientation(exif));
  if (header.bits == 16) {
    result.bits = 16;
    result.full_scale = 65535;
  }
  result.channels = default_channels(header.channels);
  return result;
}

} // namespace refraster
