#include "io/atomic_file.h"
#include "io/image_formats.h"
#include "io/text.h"

#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>

namespace refraster {
namespace {

/// A file in memory that notices when more is asked for than it holds: stb goes on with zeros then, or with whatever
/// was in its memory, and some of its decoders return the image as if nothing were missing. Of its buffer, which it
/// fills first and again and again, the end may stay empty; what it reads past that buffer, it needs.
struct Source {
  std::string_view bytes;
  std::size_t at = 0;
  const char* buffer = nullptr;
  bool ran_out = false;

  static int read(void* user, char* data, int size) {
    Source& self = *static_cast<Source*>(user);
    if (!self.buffer) self.buffer = data;
    const std::size_t count = std::min(static_cast<std::size_t>(size), self.bytes.size() - self.at);
    if (count < static_cast<std::size_t>(size) && (count == 0 || data != self.buffer)) self.ran_out = true;
    std::memcpy(data, self.bytes.data() + self.at, count);
    self.at += count;
    return static_cast<int>(count);
  }
  static void skip(void* user, int count) {
    Source& self = *static_cast<Source*>(user);
    const std::int64_t wanted = static_cast<std::int64_t>(self.at) + count;
    if (wanted > static_cast<std::int64_t>(self.bytes.size())) self.ran_out = true;
    self.at =
        static_cast<std::size_t>(std::clamp<std::int64_t>(wanted, 0, static_cast<std::int64_t>(self.bytes.size())));
  }
  static int at_end(void* user) {
    const Source& self = *static_cast<const Source*>(user);
    return self.at == self.bytes.size();
  }
  static constexpr stbi_io_callbacks calls{read, skip, at_end};
};

[[noreturn]] void not_decoded(const std::string& path, bool ran_out) {
  if (ran_out) throw truncated_image(path);
  const char* const reason = stbi_failure_reason(); // may quote the file
  if (reason && std::string_view(reason) == "outofmem") throw std::bad_alloc();
  throw InputError(InputFault{path, 0, 0, "",
                              "an image that cannot be decoded: " + one_line(reason ? reason : "unknown"), "an image"});
}

/// Decodes by one of stb's functions and copies to float, row 0 at the top.
template <class Value>
void decode(const std::string& path, std::string_view bytes, Image<float>& values,
            Value* (*load)(const stbi_io_callbacks*, void*, int*, int*, int*, int)) {
  Source source{bytes};
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<Value, void (*)(void*)> pixels(load(&Source::calls, &source, &width, &height, &channels, 0),
                                                       stbi_image_free);
  if (!pixels || source.ran_out) not_decoded(path, source.ran_out);
  values = Image<float>(width, height, channels);
  std::transform(pixels.get(), pixels.get() + values.values.size(), values.values.begin(),
                 [](Value value) { return static_cast<float>(value); });
}

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

void check_stb_prefix(const std::string& path, std::string_view prefix) {
  if (prefix.starts_with("\x89PNG\r\n\x1a\n")) return; // stb calls one that is too large an unknown image
  if (prefix.starts_with("\xff\xd8")) return;          // JPEG: what a camera notes may come first, and is long
  Source source{prefix};
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_callbacks(&Source::calls, &source, &width, &height, &channels)) return;
  // Any other reason may be that the rest is missing.
  if (std::string_view(stbi_failure_reason()) == "unknown image type") not_decoded(path, source.ran_out);
}

ImageFile read_stb(const std::string& path, std::string_view bytes, const ImageRequest& request) {
  const std::uint64_t pixels_per_byte = check_before_stb(path, bytes, request);
  Source source{bytes};
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_callbacks(&Source::calls, &source, &width, &height, &channels)) not_decoded(path, source.ran_out);
  height = std::abs(height); // negative of a BMP with its top row first
  check_image_size(path, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height), bytes.size(),
                   pixels_per_byte, request);
  const auto need = [&](std::uint64_t decoded_bytes) {
    need_image(request, path, static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height), channels,
               decoded_bytes);
  };
  ImageFile result;
  if (Source again{bytes}; stbi_is_16_bit_from_callbacks(&Source::calls, &again)) {
    need(2);
    decode<stbi_us>(path, bytes, result.values, stbi_load_16_from_callbacks);
    result.bits = 16;
    result.full_scale = 65535;
  } else {
    need(1);
    decode<stbi_uc>(path, bytes, result.values, stbi_load_from_callbacks);
  }
  result.channels = default_channels(result.values.channels);
  return result;
}

void write_png(const std::string& path, const Image<std::uint8_t>& image) {
  AtomicFile file(path);
  Sink sink{file, nullptr};
  const int done = stbi_write_png_to_func(Sink::write, &sink, image.width, image.height, image.channels,
                                          image.values.data(), image.width * image.channels);
  if (sink.error) std::rethrow_exception(sink.error);
  if (!done) throw OutputError(path, "out of memory");
  file.commit();
}

} // namespace refraster
