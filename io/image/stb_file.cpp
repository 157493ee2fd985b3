#include "io/file/atomic_file.h"
#include "io/file/text.h"
#include "io/image/image_formats.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>

namespace refraster {
namespace {

/// A file in memory, in two parts, that notices when more is asked for than it holds: stb goes on with zeros then, or
/// with whatever was in its memory, and some of its decoders return the image as if nothing were missing. Of its
/// buffer, which it fills first and again and again, the end may stay empty; what it reads past that buffer, it needs.
struct Source {
  std::string_view header, pixels;
  std::size_t at = 0;
  const char* buffer = nullptr;
  bool ran_out = false;

  std::size_t size() const { return header.size() + pixels.size(); }

  static int read(void* user, char* data, int size) {
    Source& self = *static_cast<Source*>(user);
    if (!self.buffer) self.buffer = data;
    const std::size_t wanted = static_cast<std::size_t>(size), count = std::min(wanted, self.size() - self.at);
    if (count < wanted && (count == 0 || data != self.buffer)) self.ran_out = true;
    for (std::size_t done = 0; done < count;) {
      const bool in_header = self.at < self.header.size();
      const std::string_view part =
          in_header ? self.header.substr(self.at) : self.pixels.substr(self.at - self.header.size());
      const std::size_t now = std::min(part.size(), count - done);
      std::memcpy(data + done, part.data(), now);
      done += now;
      self.at += now;
    }
    return static_cast<int>(count);
  }
  /// Only padding is skipped, and the last row may lack it.
  static void skip(void* user, int count) {
    Source& self = *static_cast<Source*>(user);
    const std::int64_t wanted = static_cast<std::int64_t>(self.at) + count;
    self.at = static_cast<std::size_t>(std::clamp<std::int64_t>(wanted, 0, static_cast<std::int64_t>(self.size())));
  }
  static int at_end(void* user) {
    const Source& self = *static_cast<const Source*>(user);
    return self.at == self.size();
  }
  static constexpr stbi_io_callbacks calls{read, skip, at_end};
};

/// What stb's writers hand over, into the file. Exceptions must not pass through C code: they wait here.
struct Sink {
  AtomicFile& file;
  std::exception_ptr error;

  static void write(void* user, void* data, int size) {
    Sink& self = *static_cast<Sink*>(user);
    if (self.error) return;
    try {
      self.file.write(data, static_cast<std::size_t>(size));
    } catch (...) {
      self.error = std::current_exception();
    }
  }
};

} // namespace

StbPixels decode_stb(const std::string& path, std::string_view header, std::string_view pixels) {
  Source source{header, pixels};
  StbPixels result{{nullptr, stbi_image_free}, 0, 0, 0};
  result.values.reset(
      stbi_load_from_callbacks(&Source::calls, &source, &result.width, &result.height, &result.channels, 0));
  if (source.ran_out) throw truncated_image(path);
  if (result.values) return result;
  const char* const reason = stbi_failure_reason();
  if (reason && std::string_view(reason) == "outofmem") throw std::bad_alloc();
  refuse_image(path, "", "what stb_image refuses: " + one_line(reason ? reason : "unknown"), "an image");
}

void write_jpeg(const std::string& path, const ImageRows<std::uint8_t>& image, const WriteOptions& options) {
  constexpr int largest_side = 65535; // the header has 16 bits for each; stb writes the lowest
  if (image.width > largest_side || image.height > largest_side)
    refuse_image(path, "", std::to_string(image.width) + " x " + std::to_string(image.height) + " pixels",
                 "at most " + std::to_string(largest_side) + " a side in a JPEG");
  Image<std::uint8_t> own; // stb wants all of it at once
  const std::uint8_t* const values = image.values(own);
  AtomicFile file(path);
  Sink sink{file, nullptr};
  const int done = stbi_write_jpg_to_func(Sink::write, &sink, image.width, image.height, image.channels, values,
                                          options.jpeg_quality);
  if (sink.error) std::rethrow_exception(sink.error);
  if (!done) throw OutputError(path, "out of memory");
  file.commit();
}

} // namespace refraster
