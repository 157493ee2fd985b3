#include "raster/shade/projective_lines.h"

namespace refraster {

namespace {

constexpr int piece_bits = 29;
constexpr std::int64_t piece_mask = (std::int64_t{1} << piece_bits) - 1;

// Part 0 and 1 are the lowest and the next 29 bits, never negative; part 2 is the rest, with the sign.
double part(Int128 x, int p) {
  const Int128 shifted = x >> (p * piece_bits);
  return static_cast<double>(static_cast<std::int64_t>(p < 2 ? shifted & piece_mask : shifted));
}

SplitLine::Piece pieces(const ProjectiveLine& line, int p) {
  return {part(line.a, p), part(line.b, p), part(line.c, p)};
}

} // namespace

SplitLine::SplitLine(const ProjectiveLine& line)
    : low(pieces(line, 0)), middle(pieces(line, 1)), high(pieces(line, 2)) {}

ProjectiveLines::ProjectiveLines(const ProjectiveTriangle& triangle)
    : pieces(triangle.pieces), owns_ties(triangle.piece[0].line[1].owns_ties()) {
  for (std::size_t p = 0; p < static_cast<std::size_t>(pieces); ++p) {
    const ProjectivePiece& from = triangle.piece[p];
    Piece& to = piece[p];
    for (std::size_t v = 0; v < 3; ++v) {
      to.line[v] = SplitLine(from.line[v]);
      for (std::size_t k = 0; k < 3; ++k) {
        const double factor = to.factor[v][k] = from.weight[v] * from.share[v][k];
        to.slope_x[k] += static_cast<double>(from.line[v].a) * factor;
        to.slope_y[k] += static_cast<double>(from.line[v].b) * factor;
      }
    }
  }
}

} // namespace refraster
