#include "suite/actions/thumbnail.h"

#include "io/html/base64.h"
#include "io/image/png/png_write.h"
#include "shading/srgb_curve.h"

#include <algorithm>
#include <cmath>

namespace refraster::suite {
namespace {

/// The first pixel of a cell, of `cells` over `pixels`.
int cell_begin(int cell, int cells, int pixels) {
  return static_cast<int>(static_cast<std::int64_t>(cell) * pixels / cells);
}

Image<std::uint8_t> reduced(const Image<std::uint8_t>& image) {
  const int longer = std::max(image.width, image.height);
  if (longer <= thumbnail_side) return image;
  const auto side = [&](int pixels) {
    return std::max(1, static_cast<int>(static_cast<std::int64_t>(pixels) * thumbnail_side / longer));
  };
  Image<std::uint8_t> small(side(image.width), side(image.height), image.channels);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      const int x_begin = cell_begin(x, small.width, image.width), x_end = cell_begin(x + 1, small.width, image.width);
      const int y_begin = cell_begin(y, small.height, image.height),
                y_end = cell_begin(y + 1, small.height, image.height);
      for (int c = 0; c < image.channels; ++c) {
        std::uint32_t sum = 0;
        for (int from_y = y_begin; from_y < y_end; ++from_y)
          for (int from_x = x_begin; from_x < x_end; ++from_x) sum += image.at(from_x, from_y)[c];
        const auto count = static_cast<std::uint32_t>((x_end - x_begin) * (y_end - y_begin));
        small.at(x, y)[c] = static_cast<std::uint8_t>((sum + count / 2) / count);
      }
    }
  return small;
}

} // namespace

std::string thumbnail_of(const Image<std::uint8_t>& rgb8) {
  if (rgb8.empty()) return {};
  const std::string file = png_file(reduced(rgb8), WriteOptions{.threads = 1});
  return base64({file.begin(), file.end()});
}

Image<std::uint8_t> levels_of(const Image<float>& values, double white, Transfer transfer) {
  Image<std::uint8_t> levels(values.width, values.height, 3);
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const double value = static_cast<double>(values.at(x, y)[values.channels < 3 ? 0 : c]) / white;
        const double clamped = value > 0 ? std::min(value, 1.0) : 0; // NaN too
        const double shown = transfer == Transfer::srgb ? srgb_encoded(clamped) : clamped;
        levels.at(x, y)[c] = static_cast<std::uint8_t>(std::nearbyint(shown * 255));
      }
  return levels;
}

} // namespace refraster::suite
