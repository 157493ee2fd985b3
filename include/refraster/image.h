#pragma once
// Images in memory.

#include <cstddef>
#include <vector>

namespace refraster {

/// width x height pixels of `channels` values, row-major, row 0 at the top, channels interleaved.
template <class Value>
struct Image {
  int width = 0, height = 0, channels = 0;
  std::vector<Value> values;

  Image() = default;
  Image(int w, int h, int c, Value fill = Value{})
      : width(w), height(h), channels(c),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * static_cast<std::size_t>(c), fill) {}

  bool empty() const { return values.empty(); }
  Value* at(int x, int y) { return &values[offset(x, y)]; }
  const Value* at(int x, int y) const { return &values[offset(x, y)]; }

private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
  }
};

} // namespace refraster
