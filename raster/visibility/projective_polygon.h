#pragma once
// What is in front of the eye of a triangle that reaches behind it, as a polygon in exact integers. For
// setup_projective.cpp, which rounds it, and for exact_pieces.cpp, which does not.

#include "raster/visibility/setup.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <tuple>
#include <vector>

namespace refraster::projective {

using Integer = boost::multiprecision::cpp_int;

/// mantissa 2^exponent == x, exactly.
struct Binary {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

inline Binary binary(double x) {
  constexpr int bias = 1075;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const int field = static_cast<int>(bits >> 52 & 0x7ff);
  const auto fraction = static_cast<std::int64_t>(bits & 0xfffffffffffff);
  Binary result{field == 0 ? fraction : fraction | std::int64_t{1} << 52, (field == 0 ? 1 : field) - bias};
  if (bits >> 63) result.mantissa = -result.mantissa;
  return result;
}

/// 2^n x without libm, for |n| <= 2000: exact unless the result is subnormal.
inline double times_power_of_two(double x, int n) {
  const auto power_of_two = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52); };
  for (; n < -1000; n += 1000) x *= power_of_two(-1000);
  for (; n > 1000; n -= 1000) x *= power_of_two(1000);
  return x * power_of_two(n);
}

inline int bit_length(const Integer& x) {
  return x == 0 ? 0 : static_cast<int>(msb(abs(x))) + 1;
}

/// x / 2^shift toward zero, so that an edge function and its negative are cut alike.
template <class Target>
Target cut(const Integer& x, int shift) {
  const Integer magnitude = abs(x) >> shift;
  const Target value = static_cast<Target>(magnitude);
  return x < 0 ? -value : value;
}

/// 2^exponent x, to an ulp.
inline double to_double(const Integer& x, int exponent) {
  const int shift = std::max(bit_length(x) - 62, 0);
  return times_power_of_two(static_cast<double>(cut<std::int64_t>(x, shift)), shift + exponent);
}

/// Clip coordinates: the true ones are 2^exponent times these.
struct ExactClip {
  Integer x, y, z, w;
  int exponent = 0;

  ExactClip aligned(int to) const {
    const int shift = exponent - to;
    return {x << shift, y << shift, z << shift, w << shift, to};
  }
};

/// A zero has no exponent of its own. Were it to have that of its bits, 2^-1074, then beside one zero all other numbers
/// would be a thousand bits long.
inline ExactClip exact_clip(const Double4& clip) {
  const std::array<Binary, 4> parts{binary(clip.x), binary(clip.y), binary(clip.z), binary(clip.w)};
  std::optional<int> exponent;
  for (const Binary& part : parts)
    if (part.mantissa != 0) exponent = std::min(part.exponent, exponent.value_or(part.exponent));
  const auto aligned = [&](const Binary& part) {
    return part.mantissa == 0 ? Integer() : Integer(part.mantissa) << (part.exponent - *exponent);
  };
  return {aligned(parts[0]), aligned(parts[1]), aligned(parts[2]), aligned(parts[3]), exponent.value_or(0)};
}

/// A vertex of a piece: a corner of the triangle, or a point where one of its edges is cut.
struct Vertex {
  // Homogeneous window point (x : y : w) in subpixels: the true one times 2^-exponent; or, on the lattice, with w = 1.
  Integer x, y, w;
  int exponent = 0;
  const WindowVertex* lattice = nullptr; // null if not on the lattice
  double factor = 1;                     // from the point, without its exponent, to clip coordinates
  double z_clip = 0, w_clip = 0;
  std::array<Integer, 3> fraction{}; // of the corners: the true ones times 2^fraction_shift
  int fraction_shift = 0;
};

inline Vertex window_point(const ExactClip& clip, int width, int height) {
  Vertex vertex;
  vertex.x = (clip.x + clip.w) * (subpixels / 2 * width);
  vertex.y = (clip.w - clip.y) * (subpixels / 2 * height);
  vertex.w = clip.w;
  vertex.exponent = clip.exponent;
  return vertex;
}

/// The edge function of the line through two points, without rounding: (a, b, c), up to a positive factor.
struct ExactEdge {
  Integer a, b, c;
};
inline ExactEdge edge_through(const Vertex& p, const Vertex& q) {
  return {p.y * q.w - p.w * q.y, p.w * q.x - p.x * q.w, p.x * q.y - p.y * q.x};
}

/// The triangle's vertices and what is in front of the eye of it, as a polygon.
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
    result.fraction[k] = 1;
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
    const int bits = std::max(bit_length(a_part), bit_length(b_part)); // fractions are brought below 1
    const ExactClip point{a_part * a.x + b_part * b.x, a_part * a.y + b_part * b.y, a_part * a.z + b_part * b.z,
                          a_part * a.w + b_part * b.w, exponent - bits};
    Vertex result = window_point(point, shape_.width, shape_.height);
    result.z_clip = to_double(point.z, point.exponent), result.w_clip = to_double(point.w, point.exponent);
    result.fraction[front] = a_part, result.fraction[back] = b_part;
    result.fraction_shift = bits;
    return result;
  }

  const std::array<const WindowVertex*, 3>& window_;
  const std::array<Double4, 3>& clip_;
  const ImageShape& shape_;
  std::array<ExactClip, 3> exact_;
};

/// The determinant of three points: 0 if they are on one line, positive if they run clockwise in the window.
inline Integer area(const std::array<const Vertex*, 3>& point) {
  const auto& [p0, p1, p2] = point;
  return p0->x * (p1->y * p2->w - p1->w * p2->y) + p0->y * (p1->w * p2->x - p1->x * p2->w) +
         p0->w * (p1->x * p2->y - p1->y * p2->x);
}

/// The order of corners in which a triangle is set up: by their places, however it was submitted.
struct CornerOrder {
  std::array<std::uint8_t, 3> corner = {0, 1, 2};
  bool odd = false; // an odd number of exchanges
};
inline CornerOrder corner_order(const std::array<Double4, 3>& clip) {
  CornerOrder order;
  const auto exchange_if_after = [&](std::size_t i, std::size_t j) {
    const Double4 &p = clip[order.corner[i]], &q = clip[order.corner[j]];
    if (std::tie(p.x, p.y, p.w, p.z) > std::tie(q.x, q.y, q.w, q.z)) {
      std::swap(order.corner[i], order.corner[j]);
      order.odd = !order.odd;
    }
  };
  exchange_if_after(0, 1), exchange_if_after(1, 2), exchange_if_after(0, 1);
  return order;
}

} // namespace refraster::projective
