#pragma once
// Edge values of a projective triangle for many samples at once.

#include "math/elementary/double_double.h"
#include "raster/visibility/setup.h"

#include <array>

namespace refraster {

/// A ProjectiveEdge in pieces of which every product with a sample's coordinate, and every sum of them, is an integer
/// below 2^53: exact in double. value = high 2^58 + middle 2^29 + low.
struct SplitEdge {
  /// a x + b y + c
  struct Piece {
    double a = 0, b = 0, c = 0;

    template <class D>
    D at(const D& x, const D& y) const {
      return D(a) * x + (D(b) * y + D(c));
    }
  };
  Piece low, middle, high;

  SplitEdge() = default;
  explicit SplitEdge(const ProjectiveEdge& edge);

  /// The line's value, rounded to double; its sign is exact. |x|, |y| <= 2^22: then each piece's products are below
  /// 2^51 (a, b < 2^29 in the lower pieces, < 2^3 in the highest one), and c < 2^29, or < 2^52 in the highest one.
  template <Lanes D>
  D at(const D& x, const D& y) const {
    const DoubleDouble<D> lower = two_sum(middle.at(x, y) * D(0x1p29), low.at(x, y));
    const DoubleDouble<D> all = two_sum(high.at(x, y) * D(0x1p58), lower.hi);
    return all.hi + (all.lo + lower.lo);
  }
};

/// What edge values of a ProjectiveTriangle are made from, by way of the vertices of its pieces to its corners.
struct ProjectiveEdges {
  struct Piece {
    std::array<SplitEdge, 3> edge;                 // of vertex v
    std::array<std::array<double, 3>, 3> factor{}; // [v][k]: times this, it goes into the value of corner k
    std::array<double, 3> slope_x{}, slope_y{};    // of the value of corner k, by a subpixel
  };
  std::array<Piece, 2> piece;
  int pieces = 0;
  bool owns_ties = false; // samples on the line between the pieces belong to the first

  explicit ProjectiveEdges(const ProjectiveTriangle& triangle);
};

/// Of a sample or lanes of them, in double: the values of three lines, and their change by a pixel to the right and
/// down.
template <class D>
struct DoubleValues {
  std::array<D, 3> value, right, down;
};

/// All scaled by a common power of two, so that the largest value lies in [1, 2): their sizes differ without bound.
template <Lanes D>
DoubleValues<D> projective_values(const ProjectiveEdges& edges, const D& x, const D& y) {
  const auto of_piece = [&](const ProjectiveEdges::Piece& piece) {
    // Sums of what is not negative in the triangle.
    DoubleValues<D> result{{D(0), D(0), D(0)}, {}, {}};
    for (std::size_t v = 0; v < 3; ++v) {
      const D at = piece.edge[v].at(x, y);
      for (std::size_t k = 0; k < 3; ++k) result.value[k] = result.value[k] + at * D(piece.factor[v][k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      result.right[k] = D(piece.slope_x[k]);
      result.down[k] = D(piece.slope_y[k]);
    }
    return result;
  };
  DoubleValues<D> chosen = of_piece(edges.piece[0]);
  if (edges.pieces == 2) {
    const D between = edges.piece[0].edge[1].at(x, y);
    const MaskOf<D> first = edges.owns_ties ? between >= D(0) : between > D(0);
    const DoubleValues<D> other = of_piece(edges.piece[1]);
    for (std::size_t k = 0; k < 3; ++k) {
      chosen.value[k] = select(first, chosen.value[k], other.value[k]);
      chosen.right[k] = select(first, chosen.right[k], other.right[k]);
      chosen.down[k] = select(first, chosen.down[k], other.down[k]);
    }
  }
  const D scale = reciprocal_binade(max(abs(chosen.value[0]), max(abs(chosen.value[1]), abs(chosen.value[2]))));
  for (std::size_t k = 0; k < 3; ++k) {
    chosen.value[k] = chosen.value[k] * scale;
    chosen.right[k] = chosen.right[k] * scale * D(subpixels);
    chosen.down[k] = chosen.down[k] * scale * D(subpixels);
  }
  return chosen;
}

} // namespace refraster
