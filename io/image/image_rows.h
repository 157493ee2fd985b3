#pragma once
// An image row by row, wherever its rows are.

#include <refraster/image.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace refraster {

/// What writers of images read: an image in memory; or rows that are read from files or made when they are asked for,
/// so that no more than a few of them are in memory at a time.
template <class Value>
class ImageRows {
public:
  /// Gives row y, width * channels values, which may be in `scratch`. Called by several threads, each with its own.
  using Row = std::function<const Value*(int y, std::vector<Value>& scratch)>;

  int width = 0, height = 0, channels = 0;

  /// Implicit, since an image is one: it must outlive this.
  ImageRows(const Image<Value>& image) // NOLINT(google-explicit-constructor)
      : width(image.width), height(image.height), channels(image.channels), whole_(image.values.data()) {}
  ImageRows(int its_width, int its_height, int its_channels, Row row)
      : width(its_width), height(its_height), channels(its_channels), row_(std::move(row)) {}

  std::size_t row_values() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(channels); }
  /// Good until the next call with this scratch.
  const Value* row(int y, std::vector<Value>& scratch) const {
    return whole_ ? whole_ + static_cast<std::size_t>(y) * row_values() : row_(y, scratch);
  }
  /// All rows one after the other, for what cannot do with less: `image` is filled with them unless they are in memory.
  const Value* values(Image<Value>& image) const {
    if (whole_) return whole_;
    image = Image<Value>(width, height, channels);
    std::vector<Value> scratch;
    for (int y = 0; y < height; ++y) std::copy_n(row(y, scratch), row_values(), image.at(0, y));
    return image.values.data();
  }

private:
  const Value* whole_ = nullptr;
  Row row_;
};

} // namespace refraster
