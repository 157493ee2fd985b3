#include "raster/setup.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>
#include <vector>

namespace refraster {

namespace {

using Integer = boost::multiprecision::cpp_int;

// mantissa 2^exponent == x, exactly.
struct Binary {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

Binary binary(double x) {
  constexpr int bias = 1075;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const auto fraction = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  Binary result{field == 0 ? fraction : fraction | std::int64_t{1} << 52, (field == 0 ? 1 : field) - bias};
  if (bits >> 63) result.mantissa = -result.mantissa;
  return result;
}

// 2^n x without libm, for |n| <= 2000: exact unless the result is subnormal.
double times_power_of_two(double x, int n) {
  const auto power = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); };
  for (; n < -1000; n += 1000) x *= power(-1000);
  for (; n > 1000; n -= 1000) x *= power(1000);
  return x * power(n);
}

int bit_length(const Integer& x) {
  return x == 0 ? 0 : static_cast<int>(msb(abs(x))) + 1;
}

// x / 2^shift toward zero, so that a line and its negative are cut alike.
template <class Target>
Target cut(const Integer& x, int shift) {
  const Integer magnitude = abs(x) >> shift;
  const Target value = static_cast<Target>(magnitude);
  return x < 0 ? -value : value;
}

// 2^exponent x, to an ulp.
double to_double(const Integer& x, int exponent) {
  const int shift = std::max(bit_length(x) - 62, 0);
  return times_power_of_two(static_cast<double>(cut<std::int64_t>(x, shift)), shift + exponent);
}

// Clip coordinates: the true ones are 2^exponent times these.
struct ExactClip {
  Integer x, y, z, w;
  int exponent = 0;

  ExactClip aligned(int to) const {
    const int shift = exponent - to;
    return {x << shift, y << shift, z << shift, w << shift, to};
  }
};

ExactClip exact_clip(const Double4& clip) {
  const Binary x = binary(clip.x), y = binary(clip.y), z = binary(clip.z), w = binary(clip.w);
  const int exponent = std::min({x.exponent, y.exponent, z.exponent, w.exponent});
  const auto aligned = [&](const Binary& b) { return Integer(b.mantissa) << (b.exponent - exponent); };
  return {aligned(x), aligned(y), aligned(z), aligned(w), exponent};
}

// A vertex of a piece: a corner of the triangle, or a point where one of its edges is cut.
struct Vertex {
  // Homogeneous window point (x : y : w) in subpixels: the true one times 2^-exponent; or, on the lattice, with w = 1.
  Integer x, y, w;
  int exponent = 0;
  const WindowVertex* lattice = nullptr; // null if not on the lattice
  double factor = 1;                     // from the point, without its exponent, to clip coordinates
  double z_clip = 0, w_clip = 0;
  std::array<double, 3> share{}; // of the corners
};

Vertex window_point(const ExactClip& clip, int width, int height) {
  Vertex vertex;
  vertex.x = (clip.x + clip.w) * (subpixels / 2 * width);
  vertex.y = (clip.w - clip.y) * (subpixels / 2 * height);
  vertex.w = clip.w;
  vertex.exponent = clip.exponent;
  return vertex;
}

struct CutLine {
  ProjectiveLine line;
  int shift = 0; // the exact line is 2^shift times this, up to the cut
};

CutLine line_through(const Vertex& p, const Vertex& q) {
  const Integer a = p.y * q.w - p.w * q.y, b = p.w * q.x - p.x * q.w, c = p.x * q.y - p.y * q.x;
  CutLine result;
  result.shift = std::max({bit_length(a) - 61, bit_length(b) - 61, bit_length(c) - 110, 0});
  ProjectiveLine& line = result.line;
  line.a = cut<std::int64_t>(a, result.shift);
  line.b = cut<std::int64_t>(b, result.shift);
  // An end on the lattice stays exactly on the line: around such a vertex, which may be in view, the triangles of a fan
  // must still own every sample once. An end off the lattice is out of view, where a difference of 2^-61 harms nobody.
  const auto through = [&](const WindowVertex& v) {
    return -(static_cast<Int128>(line.a) * v.x + static_cast<Int128>(line.b) * v.y);
  };
  if (p.lattice) line.c = through(*p.lattice);
  else if (q.lattice) line.c = through(*q.lattice);
  else line.c = cut<Int128>(c, result.shift);
  return result;
}

// The triangle's vertices and what is in front of the eye of it, as a polygon.
class Cutter {
public:
  Cutter(const std::array<const WindowVertex*, 3>& window, const std::array<Double4, 3>& clip, const ImageShape& shape)
      : window_(window), clip_(clip), shape_(shape) {
    for (std::size_t k = 0; k < 3; ++k) exact_[k] = exact_clip(clip[k]);
  }

  std::vector<Vertex> polygon() const {
    std::vector<Vertex> result;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (!behind(k)) result.push_back(corner(k));
      if (behind(k) != behind(next)) result.push_back(behind(k) ? between(next, k) : between(k, next));
    }
    return result;
  }

private:
  // A corner on the lattice is in front; and of no other are clip coordinates asked for.
  bool behind(std::size_t k) const { return (window_[k]->outcode & outcode::unsnapped) && clip_[k].w <= 0; }

  Vertex corner(std::size_t k) const {
    const WindowVertex& vertex = *window_[k];
    Vertex result = vertex.outcode & outcode::unsnapped ? window_point(exact_[k], shape_.width, shape_.height)
                                                        : Vertex{vertex.x, vertex.y, 1, 0, &vertex};
    result.factor = vertex.outcode & outcode::unsnapped ? 1.0 : vertex.inverse_w;
    result.z_clip = clip_[k].z, result.w_clip = clip_[k].w;
    result.share[k] = 1;
    return result;
  }

  // The point of the edge from a corner in front to one behind, at half the distance of the near plane: or at half that
  // of the corner in front, should that be nearer. It depends on the edge alone.
  Vertex between(std::size_t front, std::size_t back) const {
    const ExactClip near_plane = exact_clip({0, 0, 0, shape_.near});
    const int exponent =
        std::min({exact_[front].exponent, exact_[back].exponent, near_plane.exponent}) - 1; // so that halves are whole
    const ExactClip a = exact_[front].aligned(exponent), b = exact_[back].aligned(exponent);
    const Integer w = std::min<Integer>(near_plane.aligned(exponent).w, a.w) / 2;
    const Integer a_part = w - b.w, b_part = a.w - w; // both positive: the point is a_part a + b_part b
    const int bits = std::max(bit_length(a_part), bit_length(b_part)); // shares are brought below 1
    const ExactClip point{a_part * a.x + b_part * b.x, a_part * a.y + b_part * b.y, a_part * a.z + b_part * b.z,
                          a_part * a.w + b_part * b.w, exponent - bits};
    Vertex result = window_point(point, shape_.width, shape_.height);
    result.z_clip = to_double(point.z, point.exponent), result.w_clip = to_double(point.w, point.exponent);
    result.share[front] = to_double(a_part, -bits);
    result.share[back] = to_double(b_part, -bits);
    return result;
  }

  const std::array<const WindowVertex*, 3>& window_;
  const std::array<Double4, 3>& clip_;
  const ImageShape& shape_;
  std::array<ExactClip, 3> exact_;
};

// Nothing if the three points are on one line.
std::optional<ProjectivePiece> piece_of(const std::array<const Vertex*, 3>& point, bool odd) {
  const auto& [p0, p1, p2] = point;
  const Integer area = p0->x * (p1->y * p2->w - p1->w * p2->y) + p0->y * (p1->w * p2->x - p1->x * p2->w) +
                       p0->w * (p1->x * p2->y - p1->y * p2->x);
  if (area == 0) return std::nullopt;
  ProjectivePiece piece;
  piece.facing = (area < 0) != odd ? Facing::front : Facing::back;

  std::array<int, 3> exponent{};
  for (std::size_t k = 0; k < 3; ++k) {
    const CutLine cut_line = line_through(*point[(k + 1) % 3], *point[(k + 2) % 3]);
    piece.line[k] = area > 0 ? cut_line.line : -cut_line.line;
    exponent[k] = cut_line.shift - point[k]->exponent;
    piece.z[k] = point[k]->z_clip;
    piece.w[k] = point[k]->w_clip;
    piece.share[k] = point[k]->share;
  }
  // p = sum of lambda_k point_k, and point_k = (1 / w_k or 2^-exponent_k) times the clip point. So the clip point of
  // p is the sum of nu_k clip_k with nu_k = lambda_k times that factor, up to one factor common to all three.
  const int common = std::max({exponent[0], exponent[1], exponent[2]});
  for (std::size_t k = 0; k < 3; ++k)
    piece.weight[k] = times_power_of_two(point[k]->factor, std::max(exponent[k] - common, -1100));
  return piece;
}

} // namespace

std::optional<ProjectiveTriangle> set_up_projective(const std::array<WindowVertex, 3>& v,
                                                    const std::array<Double4, 3>& clip, const ImageShape& shape) {
  ProjectiveTriangle triangle;
  std::array<std::uint8_t, 3>& corner = triangle.corner;
  corner = {0, 1, 2};
  bool odd = false;
  const auto exchange_if_after = [&](std::size_t i, std::size_t j) {
    const Double4 &p = clip[corner[i]], &q = clip[corner[j]];
    if (std::tie(p.x, p.y, p.w, p.z) > std::tie(q.x, q.y, q.w, q.z)) {
      std::swap(corner[i], corner[j]);
      odd = !odd;
    }
  };
  exchange_if_after(0, 1), exchange_if_after(1, 2), exchange_if_after(0, 1);

  const std::array<Double4, 3> sorted_clip{clip[corner[0]], clip[corner[1]], clip[corner[2]]};
  const std::array<const WindowVertex*, 3> sorted{&v[corner[0]], &v[corner[1]], &v[corner[2]]};
  const std::vector<Vertex> polygon = Cutter(sorted, sorted_clip, shape).polygon();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    if (const auto piece = piece_of({&polygon[0], &polygon[i], &polygon[i + 1]}, odd))
      triangle.piece[static_cast<std::size_t>(triangle.pieces++)] = *piece;
  if (triangle.pieces == 0) return std::nullopt;
  triangle.facing = triangle.piece[0].facing;
  return triangle;
}

bool ProjectivePiece::covers(std::int32_t x, std::int32_t y) const {
  return line[0].covers(x, y) && line[1].covers(x, y) && line[2].covers(x, y);
}

double ProjectivePiece::depth(std::int32_t x, std::int32_t y) const {
  double z_sum = 0, w_sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double nu = static_cast<double>(line[k].at(x, y)) * weight[k];
    z_sum += nu * z[k];
    w_sum += nu * w[k];
  }
  return z_sum / w_sum;
}

} // namespace refraster
