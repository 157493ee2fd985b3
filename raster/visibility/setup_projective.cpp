#include "raster/visibility/projective_polygon.h"

namespace refraster {

namespace {

using namespace projective;

struct CutEdge {
  ProjectiveEdge edge;
  int shift = 0; // the exact line is 2^shift times this, up to the cut
};

CutEdge cut_edge(const Vertex& p, const Vertex& q) {
  const auto [a, b, c] = edge_through(p, q);
  CutEdge result;
  result.shift = std::max({bit_length(a) - 61, bit_length(b) - 61, bit_length(c) - 110, 0});
  ProjectiveEdge& edge = result.edge;
  edge.a = cut<std::int64_t>(a, result.shift);
  edge.b = cut<std::int64_t>(b, result.shift);
  // An end on the lattice stays exactly on the line: around such a vertex, which may be in view, the triangles of a fan
  // must still own every sample once. An end off the lattice is out of view, where a difference of 2^-61 harms nobody.
  const auto through = [&](const WindowVertex& v) {
    return -(static_cast<Int128>(edge.a) * v.x + static_cast<Int128>(edge.b) * v.y);
  };
  if (p.lattice) edge.c = through(*p.lattice);
  else if (q.lattice) edge.c = through(*q.lattice);
  else edge.c = cut<Int128>(c, result.shift);
  return result;
}

// Nothing if the three points are on one line.
std::optional<ProjectivePiece> piece_of(const std::array<const Vertex*, 3>& point, bool odd) {
  const Integer determinant = area(point);
  if (determinant == 0) return std::nullopt;
  ProjectivePiece piece;
  piece.facing = (determinant < 0) != odd ? Facing::front : Facing::back;

  std::array<int, 3> exponent{};
  for (std::size_t k = 0; k < 3; ++k) {
    const CutEdge cut = cut_edge(*point[(k + 1) % 3], *point[(k + 2) % 3]);
    piece.edge[k] = determinant > 0 ? cut.edge : -cut.edge;
    exponent[k] = cut.shift - point[k]->exponent;
    piece.z[k] = point[k]->z_clip;
    piece.w[k] = point[k]->w_clip;
    for (std::size_t c = 0; c < 3; ++c)
      piece.fraction[k][c] = to_double(point[k]->fraction[c], -point[k]->fraction_shift);
  }
  // p = sum of lambda_k point_k, and point_k = (1 / w_k or 2^-exponent_k) times the clip point. So the clip point of
  // p is the sum of nu_k clip_k with nu_k = lambda_k times that factor, up to one factor common to all three.
  const int common = std::max({exponent[0], exponent[1], exponent[2]});
  for (std::size_t k = 0; k < 3; ++k)
    piece.weight[k] = times_power_of_two(point[k]->factor, std::max(exponent[k] - common, -1100));
  return piece;
}

} // namespace

ImageShape image_shape(const FrameInput& input) {
  return {input.options.width, input.options.height, input.viewpoint.near};
}

std::optional<ProjectiveTriangle> set_up_projective(const std::array<WindowVertex, 3>& v,
                                                    const std::array<Double4, 3>& clip, const ImageShape& shape) {
  ProjectiveTriangle triangle;
  const CornerOrder order = corner_order(clip);
  const std::array<std::uint8_t, 3>& corner = triangle.corner = order.corner;

  const std::array<Double4, 3> sorted_clip{clip[corner[0]], clip[corner[1]], clip[corner[2]]};
  const std::array<const WindowVertex*, 3> sorted{&v[corner[0]], &v[corner[1]], &v[corner[2]]};
  const std::vector<Vertex> polygon = Cutter(sorted, sorted_clip, shape).polygon();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    if (const auto piece = piece_of({&polygon[0], &polygon[i], &polygon[i + 1]}, order.odd))
      triangle.piece[static_cast<std::size_t>(triangle.pieces++)] = *piece;
  if (triangle.pieces == 0) return std::nullopt;
  triangle.facing = triangle.piece[0].facing;
  return triangle;
}

bool ProjectivePiece::covers(std::int32_t x, std::int32_t y) const {
  return edge[0].covers(x, y) && edge[1].covers(x, y) && edge[2].covers(x, y);
}

double ProjectivePiece::depth(std::int32_t x, std::int32_t y) const {
  double z_sum = 0, w_sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double nu = static_cast<double>(edge[k].at(x, y)) * weight[k];
    z_sum += nu * z[k];
    w_sum += nu * w[k];
  }
  return z_sum / w_sum;
}

} // namespace refraster
