#pragma once
// Frames into a film, by ffmpeg.

#include <refraster/image.h>

#include <cstdint>
#include <string>

namespace refraster {

/// Whether a name is that of a film: .mp4, in any case.
bool is_film(const std::string& path);

/// A film that is there whole or not at all: ffmpeg writes it beside `path`, under a name that clean_when_interrupted()
/// knows, and finish() puts it in place. Every function throws OutputError; the constructor also where ffmpeg is not
/// installed.
class Film {
public:
  /// width, height: of every frame, in pixels. A side that is odd, which H.264 has not, gets one more row or column.
  Film(const std::string& path, int width, int height, int frames_per_second);
  /// Ends ffmpeg, and removes what it has written, unless finish() was called.
  ~Film();
  Film(const Film&) = delete;

  void add(const Image<std::uint8_t>& rgb8);
  void finish();

private:
  int wait();

  std::string path_, temporary_;
  int process_ = -1, pipe_ = -1;
};

} // namespace refraster
