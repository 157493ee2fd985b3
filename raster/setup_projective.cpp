#include "raster/setup.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

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

// A vertex as a homogeneous window point (x : y : w) in subpixels: the true one times 2^-exponent.
struct ExactPoint {
  Integer x, y, w;
  int exponent = 0;
};

ExactPoint exact_point(const WindowVertex& v, const Double4& clip, int width, int height) {
  if (!(v.outcode & outcode::unsnapped)) return {v.x, v.y, 1, 0};
  const Binary x = binary(clip.x), y = binary(clip.y), w = binary(clip.w);
  ExactPoint point;
  point.exponent = std::min({x.exponent, y.exponent, w.exponent});
  const auto aligned = [&](const Binary& b) { return Integer(b.mantissa) << (b.exponent - point.exponent); };
  const Integer cx = aligned(x), cy = aligned(y);
  point.w = aligned(w);
  point.x = (cx + point.w) * (subpixels / 2 * width);
  point.y = (point.w - cy) * (subpixels / 2 * height);
  return point;
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

struct CutLine {
  ProjectiveLine line;
  int shift = 0; // the exact line is 2^shift times this, up to the cut
};

CutLine line_through(const ExactPoint& p, const ExactPoint& q, const WindowVertex& p_window,
                     const WindowVertex& q_window) {
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
  if (!(p_window.outcode & outcode::unsnapped)) line.c = through(p_window);
  else if (!(q_window.outcode & outcode::unsnapped)) line.c = through(q_window);
  else line.c = cut<Int128>(c, result.shift);
  return result;
}

} // namespace

std::optional<ProjectiveTriangle> set_up_projective(const std::array<WindowVertex, 3>& v,
                                                    const std::array<Double4, 3>& clip, int width, int height) {
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

  std::array<ExactPoint, 3> point;
  for (std::size_t k = 0; k < 3; ++k) point[k] = exact_point(v[corner[k]], clip[corner[k]], width, height);
  const auto& [p0, p1, p2] = point;
  const Integer area =
      p0.x * (p1.y * p2.w - p1.w * p2.y) + p0.y * (p1.w * p2.x - p1.x * p2.w) + p0.w * (p1.x * p2.y - p1.y * p2.x);
  if (area == 0) return std::nullopt;
  triangle.facing = (area < 0) != odd ? Facing::front : Facing::back;

  std::array<int, 3> exponent{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const CutLine cut_line = line_through(point[i], point[j], v[corner[i]], v[corner[j]]);
    triangle.line[k] = area > 0 ? cut_line.line : -cut_line.line;
    exponent[k] = cut_line.shift - point[k].exponent;
    triangle.z[k] = clip[corner[k]].z;
    triangle.w[k] = clip[corner[k]].w;
  }
  // p = sum of lambda_k point_k, and point_k = (1 / w_k or 2^-exponent_k) times the clip point. So the clip point of
  // p is the sum of mu_k clip_k with mu_k = lambda_k times that factor, up to one factor common to all three.
  const int common = std::max({exponent[0], exponent[1], exponent[2]});
  for (std::size_t k = 0; k < 3; ++k) {
    const WindowVertex& vertex = v[corner[k]];
    const double factor = vertex.outcode & outcode::unsnapped ? 1.0 : vertex.inverse_w;
    triangle.weight[k] = times_power_of_two(factor, std::max(exponent[k] - common, -1100));
  }
  return triangle;
}

double ProjectiveTriangle::depth(std::int32_t x, std::int32_t y) const {
  double z_sum = 0, w_sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double mu = static_cast<double>(line[k].at(x, y)) * weight[k];
    z_sum += mu * z[k];
    w_sum += mu * w[k];
  }
  return z_sum / w_sum;
}

} // namespace refraster
