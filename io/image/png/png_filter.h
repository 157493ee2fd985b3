#pragma once
// PNG's filters: a row becomes differences to its neighbours, which pack better.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace refraster {

/// Filters rows of one image, each by the filter whose bytes, taken as signed, have the smallest sum of magnitudes: W3C,
/// Portable Network Graphics, second edition, 12.8. Of equal sums the filter with the smaller number.
/// Holds scratch memory: one for each thread.
class RowFilter {
public:
  /// row_bytes: of a row, without its filter's number; pixel_bytes: of a whole pixel, or 1.
  RowFilter(std::size_t row_bytes, std::size_t pixel_bytes);

  /// Writes the filter's number and the filtered row, 1 + row_bytes bytes, to `to`. `above` is the row before, as it is
  /// stored, and null for the first, which counts as below a row of zeros.
  void filter(const std::uint8_t* row, const std::uint8_t* above, std::uint8_t* to);

private:
  std::size_t row_bytes_, pixel_bytes_;
  std::vector<std::uint8_t> zeros_, candidate_;
};

} // namespace refraster
