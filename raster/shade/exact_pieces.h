#pragma once
// The pieces of a triangle that reaches behind the eye, without rounding: for shading in 60 digits. What is drawn is
// decided by ProjectiveTriangle, whose edge functions are cut to 61 bits.

#include "math/exact.h"
#include "raster/visibility/setup.h"

#include <array>
#include <vector>

namespace refraster {

/// ProjectivePiece (raster/visibility/setup.h) in 60 digits, from the vertices as the vertex stage has them.
struct ExactPiece {
  struct Edge {
    Exact a, b, c; // of a x + b y + c over subpixels, positive inside
  };
  std::array<Edge, 3> edge; // opposite vertex v
  // [v][k]: times this, the value of edge v goes into that of corner k.
  std::array<std::array<Exact, 3>, 3> factor{};
};

/// One or two, in the order of set_up_projective's; corners in its order too.
std::vector<ExactPiece> exact_pieces(const std::array<WindowVertex, 3>& v, const std::array<Double4, 3>& clip,
                                     const ImageShape& shape);

} // namespace refraster
