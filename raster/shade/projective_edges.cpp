#include "raster/shade/projective_edges.h"

namespace refraster {

namespace {

constexpr int piece_bits = 29;
constexpr std::int64_t piece_mask = (std::int64_t{1} << piece_bits) - 1;

// Part 0 and 1 are the lowest and the next 29 bits, never negative; part 2 is the rest, with the sign.
double part(Int128 x, int p) {
  const Int128 shifted = x >> (p * piece_bits);
  return static_cast<double>(static_cast<std::int64_t>(p < 2 ? shifted & piece_mask : shifted));
}

SplitEdge::Piece pieces(const ProjectiveEdge& edge, int p) {
  return {part(edge.a, p), part(edge.b, p), part(edge.c, p)};
}

} // namespace

SplitEdge::SplitEdge(const ProjectiveEdge& edge)
    : low(pieces(edge, 0)), middle(pieces(edge, 1)), high(pieces(edge, 2)) {}

ProjectiveEdges::ProjectiveEdges(const ProjectiveTriangle& triangle)
    : pieces(triangle.pieces), owns_ties(triangle.piece[0].edge[1].owns_ties()) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(pieces); ++p) {
    const ProjectivePiece& from = triangle.piece[p];
    Piece& to = piece[p];
    for (std::size_t v = 0; v < 3; ++v) {
      to.edge[v] = SplitEdge(from.edge[v]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double factor = to.factor[v][k] = from.weight[v] * from.fraction[v][k];
        to.slope_x[k] += static_cast<double>(from.edge[v].a) * factor;
        to.slope_y[k] += static_cast<double>(from.edge[v].b) * factor;
      }
    }
  }
}

} // namespace refraster
