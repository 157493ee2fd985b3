#pragma once
// Images in memory.

#include <cstddef>
#include <vector>

namespace refraster {

/// width x height pixels of `channels` values, row-major, row 0 at the top, channels interleaved.
template <class Value>
struct Image {
  int width = 0;                  ///< pixels
  int height = 0;                 ///< pixels
  int channels = 0;               ///< values a pixel
  std::vector<Value> values = {}; ///< width * height * channels

  /// Empty.
  Image() = default;
  /// w x h pixels of c channels, each `fill`. None is negative. Throws std::bad_alloc.
  Image(int w, int h, int c, Value fill = Value{})
      : width(w), height(h), channels(c),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c), fill) {}

  /// Whether it has no pixel.
  bool empty() const { return values.empty(); }
  /// The first channel of pixel (x, y), which must be within the image; the others follow.
  Value* at(int x, int y) { return &values[offset(x, y)]; }
  /// The same.
  const Value* at(int x, int y) const { return &values[offset(x, y)]; }

private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
  }
};

} // namespace refraster
