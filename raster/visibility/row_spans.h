#pragma once
// Where a triangle begins and ends in each row of its bounding box, found for a register of rows at once.
//
// Spans are a little too wide at times, never too narrow, and so they need no exactness: who owns a sample is tested
// again. At the pixel `x` of row `r` an edge function's value is start + x right + r down. With right > 0 its triangle
// lies where x >= edge + r slope, with edge = -start / right and slope = -down / right; with right < 0 where x is not
// greater.
//
// How far off edge + r slope may be: |start| < 2^52 and |right| >= 2^8, so |edge| < 2^44; |r slope| < 2^7 2^25. Three
// roundings to 2^-53 of each, and one of the sum, are less than 5 2^-53 2^44 < 2^-6 = `slack`.

#include "raster/lanes.h"

#include <array>
#include <cstdint>

namespace refraster {

/// The bounds of N triangles: each has at most two edges to the left, and at most two to the right. Where there is one,
/// it is there twice.
template <int N>
struct SpanEdges {
  using T = Wide<double, N>;
  struct Edge {
    T edge, slope;
  };
  std::array<Edge, 2> left, right;
};

template <int N>
SpanEdges<N> span_edges(const std::array<Wide<double, N>, 3>& start, const std::array<Wide<double, N>, 3>& right,
                        const std::array<Wide<double, N>, 3>& down) {
  using T = Wide<double, N>;
  using Edge = typename SpanEdges<N>::Edge;
  std::array<Edge, 3> at;
  for (std::size_t k = 0; k < 3; ++k) {
    const T reciprocal = T(-1.0) / right[k]; // a level edge is chosen by neither side
    at[k] = {start[k] * reciprocal, down[k] * reciprocal};
  }
  const auto chosen = [](auto m, const Edge& a, const Edge& b) {
    return Edge{select(m, a.edge, b.edge), select(m, a.slope, b.slope)};
  };
  const T zero(0.0);
  const auto l0 = right[0] > zero, l1 = right[1] > zero, l2 = right[2] > zero;
  const auto r0 = right[0] < zero, r1 = right[1] < zero, r2 = right[2] < zero;
  return {{chosen(l0, at[0], chosen(l1, at[1], at[2])), chosen(l2, at[2], chosen(l1, at[1], at[0]))},
          {chosen(r0, at[0], chosen(r1, at[1], at[2])), chosen(r2, at[2], chosen(r1, at[1], at[0]))}};
}

/// One triangle's, as numbers.
struct SpanBounds {
  struct Edge {
    double edge, slope;
  };
  std::array<Edge, 2> left, right;
};

/// The spans of one triangle, and the values of its edge functions at their first pixels.
class RowSpans {
public:
  static constexpr int max_rows = 128;

  /// `rows` rows of `width` pixels. The values of edge functions are exact.
  template <int N>
  void find(const SpanBounds& bounds, int rows, int width, const std::array<double, 3>& start,
            const std::array<double, 3>& right, const std::array<double, 3>& down) {
    using T = Wide<double, N>;
    constexpr double slack = 0x1p-6;
    const T last_pixel(static_cast<double>(width - 1));
    T r = lane_numbers<double, N>();
    for (int row = 0; row < rows; row += N, r += T(double{N})) {
      const auto at = [&](const SpanBounds::Edge& e) { return T(e.edge) + r * T(e.slope); };
      const T from = max(at(bounds.left[0]), at(bounds.left[1]));
      const T to = min(at(bounds.right[0]), at(bounds.right[1]));
      // Rounded up and down by cutting off; within the row they are not negative.
      const auto first = integers(min(max(from + T(1 - slack), T(0.0)), last_pixel + T(1.0)));
      const auto place = static_cast<std::size_t>(row);
      store_lanes(&first_[place], first);
      store_lanes(&last_[place], integers(min(max(to + T(slack), T(-1.0)), last_pixel)));
      const T x = numbers<N>(first);
      for (std::size_t k = 0; k < 3; ++k)
        store_lanes(&value_[k][place], T(start[k]) + r * T(down[k]) + x * T(right[k]));
    }
  }

  int first(int row) const { return first_[static_cast<std::size_t>(row)]; }
  int last(int row) const { return last_[static_cast<std::size_t>(row)]; }
  double value(std::size_t edge, int row) const { return value_[edge][static_cast<std::size_t>(row)]; }

private:
  static constexpr std::size_t room = max_rows + 8; // for a whole register after the last row
  std::array<std::int32_t, room> first_, last_;
  std::array<std::array<double, room>, 3> value_;
};

} // namespace refraster
