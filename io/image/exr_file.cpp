#include "io/file/atomic_file.h"
#include "io/file/text.h"
#include "io/image/exr_header.h"
#include "io/image/exr_layers.h"
#include "io/image/image_formats.h"
#include "raster/frame_context.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <type_traits>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

namespace refraster {
namespace {

/// An AtomicFile as OpenEXR wants to write it.
class ExrStream : public Imf::OStream {
public:
  ExrStream(const std::string& path, AtomicFile& file) : Imf::OStream(path.c_str()), file_(file) {}
  void write(const char bytes[], int size) override {
    report_errors([&] { file_.write(bytes, static_cast<std::size_t>(size)); });
    if (!is_table_) return;
    for (int i = 0; i + 8 <= size; i += 8) {
      std::uint64_t offset = 0;
      std::memcpy(&offset, bytes + i, sizeof offset);
      if (offset == 0) part_is_missing_ = true;
    }
  }
  std::uint64_t tellp() override { return file_.position(); }
  void seekp(std::uint64_t position) override {
    report_errors([&] { file_.seek(position); });
    is_table_ = true;
  }

  /// To be called when OpenEXR has closed the file. It keeps to itself what goes wrong while it closes one, and where
  /// memory for compression is missing: the block of rows is not written then, and its place in the table of blocks,
  /// the only thing that is written behind a seek, stays 0.
  void check(const std::string& path) const {
    if (error_) std::rethrow_exception(error_);
    if (part_is_missing_) throw OutputError(path, "OpenEXR has left out a part of the image");
  }

private:
  template <class Action>
  void report_errors(Action&& action) {
    try {
      action();
    } catch (...) {
      if (!error_) error_ = std::current_exception();
      throw;
    }
  }

  AtomicFile& file_;
  std::exception_ptr error_;
  bool is_table_ = false, part_is_missing_ = false;
};

/// Bytes in memory as OpenEXR wants to read them: what was checked is what is read.
class ExrBytes : public Imf::IStream {
public:
  ExrBytes(const std::string& path, std::string_view bytes) : Imf::IStream(path.c_str()), bytes_(bytes) {}
  bool read(char to[], int size) override {
    if (size < 0 || at_ > bytes_.size() || static_cast<std::size_t>(size) > bytes_.size() - at_)
      throw std::runtime_error("the file ends early");
    std::memcpy(to, bytes_.data() + at_, static_cast<std::size_t>(size));
    at_ += static_cast<std::size_t>(size);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }

private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// Channel c of an image whose first pixel is that of the buffer that OpenEXR addresses.
template <class Value>
Imf::Slice slice(const Image<Value>& image, int c, int x_origin, int y_origin) {
  const std::size_t pixel = sizeof(Value) * static_cast<std::size_t>(image.channels);
  const std::size_t row = pixel * static_cast<std::size_t>(image.width);
  // OpenEXR takes one type of pointer for reading and writing; a writer only reads.
  char* const base = reinterpret_cast<char*>(const_cast<Value*>(image.values.data() + c));
  return {std::is_same_v<Value, float> ? Imf::FLOAT : Imf::UINT,
          base - static_cast<std::ptrdiff_t>(pixel) * x_origin - static_cast<std::ptrdiff_t>(row) * y_origin, pixel,
          row};
}

/// How many threads OpenEXR is to pack blocks of rows with; they are written in their order all the same. The threads
/// are one pool of the whole process, which another file may be written with at this moment: it grows, and stays. Where
/// the system gives no thread there are fewer, and 0 is the caller's own.
int packing_threads(const WriteOptions& options) {
  const int wanted = thread_count({.threads = options.threads});
  if (wanted <= 1) return 0;
  try {
    if (Imf::globalThreadCount() < wanted) Imf::setGlobalThreadCount(wanted);
  } catch (const std::exception&) {
  }
  return std::min(wanted, Imf::globalThreadCount());
}

/// Rows of a layer that are written at a time.
class RowBlock {
public:
  RowBlock(const ExrLayer& layer, int rows)
      : layer_(layer), rows_(rows), floats_(layer.image.width, type() == Imf::FLOAT ? rows : 0, layer.image.channels),
        numbers_(layer.image.width, type() == Imf::UINT ? rows : 0, layer.image.channels) {}

  Imf::PixelType type() const { return layer_.values == LayerValues::floats ? Imf::FLOAT : Imf::UINT; }
  int rows() const { return rows_; }

  /// Rows y to y + count.
  void read(int y, int count) {
    const std::size_t row_values = layer_.image.row_values();
    for (int i = 0; i < count; ++i) {
      const float* const row = layer_.image.row(y + i, scratch_);
      if (type() == Imf::FLOAT) std::copy_n(row, row_values, floats_.at(0, i));
      else
        std::transform(row, row + row_values, numbers_.at(0, i),
                       [](float value) { return static_cast<std::uint32_t>(value); });
    }
  }
  void insert_into(Imf::FrameBuffer& buffer, int y) const {
    for (int c = 0; c < layer_.image.channels; ++c)
      buffer.insert(layer_.channels[static_cast<std::size_t>(c)],
                    type() == Imf::FLOAT ? slice(floats_, c, 0, y) : slice(numbers_, c, 0, y));
  }

private:
  const ExrLayer& layer_;
  int rows_;
  Image<float> floats_;
  Image<std::uint32_t> numbers_;
  std::vector<float> scratch_;
};

/// Whole blocks of ZIP compression, so many that no thread waits long for another.
int rows_at_a_time(int threads, int height) {
  constexpr int block_rows = 16, blocks_a_thread = 4;
  return std::min(block_rows * blocks_a_thread * std::max(1, threads), height);
}

} // namespace

ImageFile read_exr(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  check_before_exr(path, bytes, request);
  try {
    ExrBytes stream(path, bytes);
    Imf::InputFile file(stream);
    const Imath::Box2i window = file.header().dataWindow();
    ImageFile result;
    result.bits = 32;
    result.full_scale = 1;
    result.names_channels = true;
    const Imf::ChannelList& list = file.header().channels();
    for (auto it = list.begin(); it != list.end(); ++it) {
      result.channels.push_back(it.name());
      if (it.channel().type == Imf::HALF) result.unit_roundoff = 0x1p-11;
    }
    // The file has them in alphabetic order: A B G R. The colour comes first here, as R G B A.
    std::size_t front = 0;
    for (const char* const name : {"R", "G", "B", "A"})
      for (std::size_t i = front; i < result.channels.size(); ++i)
        if (result.channels[i] == name)
          std::rotate(result.channels.begin() + static_cast<std::ptrdiff_t>(front++),
                      result.channels.begin() + static_cast<std::ptrdiff_t>(i),
                      result.channels.begin() + static_cast<std::ptrdiff_t>(i + 1));
    const auto pixels = static_cast<std::uint64_t>(window.max.x - window.min.x + 1) *
                        static_cast<std::uint64_t>(window.max.y - window.min.y + 1);
    need_image(request, path, pixels, static_cast<int>(result.channels.size()), 0);
    result.values = Image<float>(window.max.x - window.min.x + 1, window.max.y - window.min.y + 1,
                                 static_cast<int>(result.channels.size()));
    Imf::FrameBuffer buffer;
    for (std::size_t c = 0; c < result.channels.size(); ++c)
      buffer.insert(result.channels[c], slice(result.values, static_cast<int>(c), window.min.x, window.min.y));
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    return result;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) { // whatever OpenEXR has to say about it
    throw InputError(
        InputFault{path, 0, 0, "", "an image that cannot be decoded: " + one_line(error.what()), "an OpenEXR image"});
  }
}

void write_exr_layers(const std::string& path, std::span<const ExrLayer> layers, const WriteOptions& options) {
  const int width = layers.front().image.width, height = layers.front().image.height;
  const int threads = packing_threads(options);
  std::vector<RowBlock> blocks;
  AtomicFile file(path);
  ExrStream stream(path, file);
  std::exception_ptr unreadable; // OpenEXR must not take for a fault of its own what reading rows throws
  try {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION; // lossless
    for (const ExrLayer& layer : layers) {
      blocks.emplace_back(layer, rows_at_a_time(threads, height));
      for (const std::string& name : layer.channels) header.channels().insert(name, Imf::Channel(blocks.back().type()));
    }
    Imf::OutputFile output(stream, header, threads);
    const int step = blocks.front().rows();
    for (int y = 0; y < height && !unreadable; y += step) {
      Imf::FrameBuffer buffer;
      const int count = std::min(step, height - y);
      try {
        for (RowBlock& block : blocks) block.read(y, count), block.insert_into(buffer, y);
      } catch (...) {
        unreadable = std::current_exception();
        break;
      }
      output.setFrameBuffer(buffer);
      output.writePixels(count);
    }
  } catch (const OutputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    stream.check(path); // why the system refused it
    throw OutputError(path, error.what());
  }
  if (unreadable) std::rethrow_exception(unreadable);
  stream.check(path);
  file.commit();
}

void write_exr(const std::string& path, const ImageRows<float>& image, const std::vector<std::string>& channels,
               const WriteOptions& options) {
  const ExrLayer layer{image, channels};
  write_exr_layers(path, {&layer, 1}, options);
}

} // namespace refraster
