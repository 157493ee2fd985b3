#include "io/file/text.h"
#include "io/image/exif.h"
#include "io/image/image_formats.h"

#include <csetjmp>
#include <cstdio> // jpeglib.h takes it for granted
#include <cstring>

#include <jerror.h>
#include <jpeglib.h>

// JPEG by libjpeg-turbo. Its warnings are faults where pixels are not what was written. The exact integer transform and
// triangular upsampling are the library's defaults, and the same with and without SIMD instructions.

namespace refraster {
namespace {

/// Each component has a scan with its means, which takes a bit a block of 8 x 8 samples at least. The coarsest of
/// components: one with a sample each 4 pixels across, one each 4 down; any third adds blocks. So two blocks, or bits,
/// stand for 32 x 8 pixels.
constexpr std::uint64_t pixels_per_byte = 8 * 32 * 8 / 2;

/// What libjpeg's callbacks work on. libjpeg leaves them by longjmp: everything here and in them is trivially
/// destructible, and nothing in them throws.
struct Jpeg {
  jpeg_decompress_struct decoder;
  jpeg_error_mgr errors;
  jpeg_source_mgr source;
  jpeg_progress_mgr progress;
  std::jmp_buf leave;
  char error[JMSG_LENGTH_MAX], warning[JMSG_LENGTH_MAX];
  bool is_truncated, is_out_of_memory, has_too_many_scans;
  int warnings;
  unsigned components_seen; // a bit each
};

Jpeg& jpeg_of(jpeg_common_struct* decoder) {
  return *static_cast<Jpeg*>(decoder->client_data);
}
Jpeg& jpeg_of(jpeg_decompress_struct* decoder) {
  return *static_cast<Jpeg*>(decoder->client_data);
}

[[noreturn]] void on_error(jpeg_common_struct* decoder) {
  Jpeg& jpeg = jpeg_of(decoder);
  jpeg.errors.format_message(decoder, jpeg.error);
  jpeg.is_out_of_memory = jpeg.errors.msg_code == JERR_OUT_OF_MEMORY;
  std::longjmp(jpeg.leave, 1); // NOLINT(cert-err52-cpp): what libjpeg has
}

/// Bytes that belong to nothing, and a later version of JFIF, change no pixel. Every other warning is of data that are
/// missing or wrong, where libjpeg makes pixels up.
void on_message(jpeg_common_struct* decoder, int level) {
  if (level >= 0) return; // a trace
  Jpeg& jpeg = jpeg_of(decoder);
  const int code = jpeg.errors.msg_code;
  if (code != JWRN_EXTRANEOUS_DATA && code != JWRN_JFIF_MAJOR) on_error(decoder);
  if (jpeg.warnings++ == 0) jpeg.errors.format_message(decoder, jpeg.warning);
}

[[noreturn]] void file_ends(jpeg_decompress_struct* decoder) {
  Jpeg& jpeg = jpeg_of(decoder);
  jpeg.is_truncated = true;
  std::longjmp(jpeg.leave, 1); // NOLINT(cert-err52-cpp)
}

boolean on_empty(jpeg_decompress_struct* decoder) {
  file_ends(decoder);
}

void on_skip(jpeg_decompress_struct* decoder, long count) {
  if (count <= 0) return;
  jpeg_source_mgr& source = *decoder->src;
  if (static_cast<std::size_t>(count) > source.bytes_in_buffer) file_ends(decoder);
  source.next_input_byte += count;
  source.bytes_in_buffer -= static_cast<std::size_t>(count);
}

/// Called before each row of blocks of each scan. A scan of a few bytes goes through the whole image: without a bound,
/// a small file could take hours.
void on_progress(jpeg_common_struct* decoder) {
  Jpeg& jpeg = jpeg_of(decoder);
  const jpeg_decompress_struct& from = jpeg.decoder;
  for (int i = 0; i < from.comps_in_scan; ++i) jpeg.components_seen |= 1u << from.cur_comp_info[i]->component_index;
  if (static_cast<std::uint64_t>(from.input_scan_number) <= limit::jpeg_scans.value) return;
  jpeg.has_too_many_scans = true;
  std::longjmp(jpeg.leave, 1); // NOLINT(cert-err52-cpp)
}

/// libjpeg's structures, and the one place where its errors arrive.
class Decoder {
public:
  Decoder(Jpeg& jpeg, std::string_view bytes) : jpeg_(jpeg) {
    jpeg_.decoder.err = jpeg_std_error(&jpeg_.errors);
    jpeg_.decoder.client_data = &jpeg_;
    jpeg_.errors.error_exit = on_error;
    jpeg_.errors.emit_message = on_message;
    if (!runs([](Jpeg& j) { jpeg_create_decompress(&j.decoder); })) throw std::bad_alloc();
    jpeg_.source.next_input_byte = reinterpret_cast<const JOCTET*>(bytes.data());
    jpeg_.source.bytes_in_buffer = bytes.size();
    jpeg_.source.init_source = [](jpeg_decompress_struct*) {};
    jpeg_.source.fill_input_buffer = on_empty;
    jpeg_.source.skip_input_data = on_skip;
    jpeg_.source.resync_to_restart = jpeg_resync_to_restart;
    jpeg_.source.term_source = [](jpeg_decompress_struct*) {};
    jpeg_.decoder.src = &jpeg_.source;
    jpeg_.progress.progress_monitor = on_progress;
    jpeg_.decoder.progress = &jpeg_.progress;
  }
  ~Decoder() { jpeg_destroy_decompress(&jpeg_.decoder); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Runs a step of libjpeg; false if it ends in an error. The step must hold nothing that has a destructor.
  template <class Step>
  bool runs(const Step& step) {
    if (setjmp(jpeg_.leave)) return false; // NOLINT(cert-err52-cpp)
    step(jpeg_);
    return true;
  }

private:
  Jpeg& jpeg_;
};

constexpr const char* readable = "baseline or progressive JPEG: 8 bits, Huffman codes, a whole file";

[[noreturn]] void refuse(const std::string& path, const Jpeg& jpeg) {
  if (jpeg.is_out_of_memory) throw std::bad_alloc();
  if (jpeg.is_truncated) throw truncated_image(path);
  if (jpeg.has_too_many_scans)
    refuse_image(path, "", found_of(limit::jpeg_scans, static_cast<std::uint64_t>(jpeg.decoder.input_scan_number)),
                 at_most(limit::jpeg_scans));
  refuse_image(path, "", "what libjpeg refuses: " + one_line(jpeg.error), readable);
}

/// What the header says and libjpeg would take in a way that other programs do not.
void check_header(const std::string& path, const jpeg_decompress_struct& decoder) {
  // Its decoder does not notice when data are missing.
  if (decoder.arith_code) refuse_image(path, "", "arithmetic coding", readable);
  const int count = decoder.num_components;
  if (count != 1 && count != 3 && count != 4)
    refuse_image(path, "", counted(static_cast<std::size_t>(count), "colour component"), "1, 3 or 4");
  if (count == 4 && !decoder.saw_Adobe_marker)
    refuse_image(path, "", "four colour components, and no Adobe segment that says what they are",
                 "grey, RGB or YCbCr; or CMYK or YCCK with that segment");
}

/// Of the last row of samples that libjpeg gave: RGB, grey; or CMYK as Adobe writes it, 0 where there is most ink.
void convert_row(const std::vector<JSAMPLE>& row, int channels, bool is_cmyk, float* out) {
  if (!is_cmyk) {
    for (const JSAMPLE value : row) *out++ = value;
    return;
  }
  for (std::size_t x = 0; x < row.size(); x += 4)
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c)
      *out++ = static_cast<float>((row[x + c] * row[x + 3] + 127) / 255); // the nearest whole number
}

/// Of the first APP1 segment with EXIF data.
int orientation(const jpeg_decompress_struct& decoder) {
  using namespace std::string_view_literals;
  constexpr std::string_view mark = "Exif\0\0"sv;
  for (const jpeg_marker_struct* marker = decoder.marker_list; marker; marker = marker->next) {
    const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (data.starts_with(mark)) return exif_orientation(data.substr(mark.size()));
  }
  return 1;
}

/// What libjpeg keeps for an image of several scans: two bytes a coefficient of all blocks.
std::uint64_t coefficient_bytes(const jpeg_decompress_struct& decoder) {
  std::uint64_t blocks = 0;
  for (int i = 0; i < decoder.num_components; ++i)
    blocks += std::uint64_t{decoder.comp_info[i].width_in_blocks} * decoder.comp_info[i].height_in_blocks;
  return jpeg_has_multiple_scans(const_cast<jpeg_decompress_struct*>(&decoder)) ? blocks * DCTSIZE2 * sizeof(JCOEF) : 0;
}

void check_complete(const std::string& path, const Jpeg& jpeg) {
  for (int i = 0; i < jpeg.decoder.num_components; ++i) {
    const bool has_means = !jpeg.decoder.progressive_mode || jpeg.decoder.coef_bits[i][0] >= 0;
    if (jpeg.components_seen >> i & 1u && has_means) continue;
    refuse_image(path, "colour component " + std::to_string(i + 1), "no scan with its means", "one");
  }
}

} // namespace

ImageFile read_jpeg(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  Jpeg jpeg{};
  Decoder decoder(jpeg, bytes);
  const auto begin = [](Jpeg& j) {
    constexpr unsigned longest = 0xffff;
    jpeg_save_markers(&j.decoder, JPEG_APP0 + 1, longest); // EXIF
    jpeg_read_header(&j.decoder, TRUE);
  };
  if (!decoder.runs(begin)) refuse(path, jpeg);
  check_header(path, jpeg.decoder);
  const std::uint64_t width = jpeg.decoder.image_width, height = jpeg.decoder.image_height;
  check_image_size(path, width, height, bytes.size(), pixels_per_byte, request);
  const bool is_cmyk = jpeg.decoder.num_components == 4;
  const int channels = jpeg.decoder.num_components == 1 ? 1 : 3;
  request.memory.need(
      width * height * static_cast<std::uint64_t>(channels) * sizeof(float) + coefficient_bytes(jpeg.decoder), path);

  const auto start = [](Jpeg& j) {
    const int count = j.decoder.num_components;
    j.decoder.out_color_space = count == 1 ? JCS_GRAYSCALE : count == 4 ? JCS_CMYK : JCS_RGB;
    j.decoder.dct_method = JDCT_ISLOW;
    j.decoder.do_fancy_upsampling = TRUE;
    j.decoder.do_block_smoothing = FALSE; // makes up coefficients that a file does not give
    jpeg_start_decompress(&j.decoder);
  };
  if (!decoder.runs(start)) refuse(path, jpeg);
  ImageFile result;
  result.values = Image<float>(static_cast<int>(width), static_cast<int>(height), channels);
  std::vector<JSAMPLE> row(width * static_cast<std::size_t>(jpeg.decoder.output_components));
  for (int y = 0; y < result.values.height; ++y) {
    JSAMPLE* to = row.data();
    if (!decoder.runs([&to](Jpeg& j) { jpeg_read_scanlines(&j.decoder, &to, 1); })) refuse(path, jpeg);
    convert_row(row, channels, is_cmyk, result.values.at(0, y));
  }
  check_complete(path, jpeg);
  note_orientation(result, path, orientation(jpeg.decoder));
  if (!decoder.runs([](Jpeg& j) { jpeg_finish_decompress(&j.decoder); })) refuse(path, jpeg);
  if (is_cmyk)
    result.notes.add({path, 0, "inks, C M Y K", "read as red (1 - C) (1 - K), and so on, without a colour profile", 1});
  if (jpeg.warnings > 0)
    result.notes.add({path, 0, "what libjpeg warns of (" + one_line(jpeg.warning) + ")", "read all the same",
                      static_cast<std::uint64_t>(jpeg.warnings)});
  result.channels = default_channels(channels);
  return result;
}

} // namespace refraster
