#include "raster/shade/exact_pieces.h"

#include "raster/visibility/projective_polygon.h"

namespace refraster {

namespace {

using namespace projective;

Exact exact(const Integer& x) {
  return Exact(Exact::Value(x));
}
Exact times_power_of_two(const Exact& x, int n) {
  return Exact(Exact::Value(ldexp(x.value(), n)));
}

} // namespace

std::vector<ExactPiece> exact_pieces(const std::array<WindowVertex, 3>& v, const std::array<Double4, 3>& clip,
                                     const ImageShape& shape) {
  const auto [c0, c1, c2] = corner_order(clip).corner;
  const std::array<const WindowVertex*, 3> sorted{&v[c0], &v[c1], &v[c2]};
  const std::array<Double4, 3> sorted_clip{clip[c0], clip[c1], clip[c2]};
  const std::vector<Vertex> polygon = Cutter(sorted, sorted_clip, shape).polygon();
  std::vector<ExactPiece> pieces;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const std::array<const Vertex*, 3> point = {&polygon[0], &polygon[i], &polygon[i + 1]};
    const Integer determinant = area(point);
    if (determinant == 0) continue;
    ExactPiece& piece = pieces.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const ExactEdge edge = edge_through(*point[(k + 1) % 3], *point[(k + 2) % 3]);
      const Exact sign(determinant > 0 ? 1 : -1);
      piece.edge[k] = {exact(edge.a) * sign, exact(edge.b) * sign, exact(edge.c) * sign};
      // As in piece_of: the clip point of a sample is the sum of nu_k clip_k with nu_k = lambda_k times this.
      const Exact weight = times_power_of_two(Exact(point[k]->factor), -point[k]->exponent);
      for (std::size_t c = 0; c < 3; ++c)
        piece.factor[k][c] = weight * times_power_of_two(exact(point[k]->fraction[c]), -point[k]->fraction_shift);
    }
  }
  return pieces;
}

} // namespace refraster
