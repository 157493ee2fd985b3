#pragma once
// From a visible triangle to what is interpolated over it: perspective-correct attributes at pixel centres, in the
// number of a rung. Here the rung begins.

#include "math/rungs.h"
#include "raster/bin.h"

#include <array>
#include <cstdint>

namespace refraster {

/// What shading needs of one visible triangle, attributes in the rung's precision.
///
/// An attribute is kept as its value at one corner and the differences to the other two: f = f0 + b1 (f1 - f0) +
/// b2 (f2 - f0). So a value that is the same at all three corners comes out unchanged, bit for bit, and nothing is
/// anchored at the framebuffer's origin, where a small far triangle would lose its digits.
template <class Real>
struct SurfaceTriangle {
  std::array<std::array<double, 3>, 3> line; // [k] = a, b, c: exact; unused where projective
  const ProjectiveTriangle* projective = nullptr;
  std::array<Real, 3> weight;                  // of perspective: see SnappedTriangle
  std::array<std::array<Real, 3>, 3> position; // [0] at corner 0, [1] and [2] the differences
  std::array<std::array<Real, 3>, 3> normal;
  std::array<std::array<Real, 2>, 3> uv; // less uv_whole
  std::array<double, 2> uv_whole;        // whole repeats taken off, so that uv keeps its fraction's digits
  std::uint32_t object = 0;
  std::uint32_t number = 0; // in the frame
};

template <class Real>
SurfaceTriangle<Real> surface_triangle(const Scene& scene, const Geometry& geometry, const Bins& bins,
                                       std::uint32_t number);

extern template SurfaceTriangle<double> surface_triangle(const Scene&, const Geometry&, const Bins&, std::uint32_t);
extern template SurfaceTriangle<float> surface_triangle(const Scene&, const Geometry&, const Bins&, std::uint32_t);

/// The triangle's own normal in world space, from its winding: for places where the mesh gives none. May be 0.
Double3 face_normal(const Scene& scene, const Geometry& geometry, std::uint32_t number);

/// As many fragments as T has lanes: each a triangle, and a pixel centre in subpixels of the window.
template <class T, class Triangle>
struct Packet {
  static constexpr int lanes = NumberTraits<T>::lanes;
  std::array<const Triangle*, lanes> triangle;
  std::array<std::int32_t, lanes> x, y;
  int count = 0; // lanes in use; the others repeat the last one
  bool one_triangle = false;

  /// value(triangle) in each lane: broadcast if they are all the same, gathered if not.
  template <class Number, class Value>
  Number each(Value&& value) const {
    if (one_triangle) return Number(value(*triangle[0]));
    Number result;
    for (int lane = 0; lane < lanes; ++lane) result.set(lane, value(*triangle[static_cast<std::size_t>(lane)]));
    return result;
  }
};

/// Weights of the two corners that are not the anchor.
template <class T>
struct Barycentric {
  T b1, b2;
};

/// Of the three lines: the value at the sample, and the change by one pixel to the right and down. All exact but for a
/// projective triangle, and then all times one power of two: only ratios are used.
template <int lanes>
struct LineValues {
  using Exact = Wide<double, lanes>;
  std::array<Exact, 3> value, right, down;
};

template <class T, class Triangle>
LineValues<NumberTraits<T>::lanes> line_values(const Packet<T, Triangle>& packet) {
  constexpr int lanes = NumberTraits<T>::lanes;
  using Exact = Wide<double, lanes>;
  LineValues<lanes> lines;
  bool any_projective = false;
  for (const Triangle* t : packet.triangle) any_projective |= t->projective != nullptr;
  if (!any_projective) {
    Exact x, y;
    for (int lane = 0; lane < lanes; ++lane) {
      x.set(lane, packet.x[static_cast<std::size_t>(lane)]);
      y.set(lane, packet.y[static_cast<std::size_t>(lane)]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const auto coefficient = [&](std::size_t i) {
        return packet.template each<Exact>([=](const Triangle& t) { return t.line[k][i]; });
      };
      const Exact a = coefficient(0), b = coefficient(1);
      lines.value[k] = a * x + (b * y + coefficient(2));
      lines.right[k] = a * Exact(subpixels);
      lines.down[k] = b * Exact(subpixels);
    }
    return lines;
  }
  for (int lane = 0; lane < lanes; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    const Triangle& t = *packet.triangle[l];
    const auto set = [&](std::size_t k, double value, double a, double b) {
      lines.value[k].set(lane, value);
      lines.right[k].set(lane, a * subpixels);
      lines.down[k].set(lane, b * subpixels);
    };
    for (std::size_t k = 0; k < 3; ++k) {
      if (t.projective) {
        const ProjectiveLine& line = t.projective->line[k];
        const double weight = t.projective->weight[k];
        set(k, static_cast<double>(line.at(packet.x[l], packet.y[l])) * weight, static_cast<double>(line.a) * weight,
            static_cast<double>(line.b) * weight);
      } else {
        set(k, t.line[k][0] * packet.x[l] + (t.line[k][1] * packet.y[l] + t.line[k][2]), t.line[k][0], t.line[k][1]);
      }
    }
  }
  // The sizes of projective lines differ without bound: bring each lane's largest value near 1 before T rounds it.
  const Exact scale = reciprocal_binade(
      maximum(magnitude(lines.value[0]), maximum(magnitude(lines.value[1]), magnitude(lines.value[2]))));
  for (std::size_t k = 0; k < 3; ++k) {
    lines.value[k] *= scale;
    lines.right[k] *= scale;
    lines.down[k] *= scale;
  }
  return lines;
}

/// Perspective-correct weights at the sample, each in [0, 1] inside the triangle; and, where asked for, how they change
/// by one pixel to the right and down: the derivative of the quotient, not a difference of neighbours.
template <class T>
struct PacketBarycentrics {
  Barycentric<T> at, right, down;
};
enum class Derivatives { no, yes };

template <class T, class Triangle>
PacketBarycentrics<T> barycentrics(const Packet<T, Triangle>& packet, Derivatives derivatives) {
  const auto lines = line_values<T>(packet);
  const auto weighted = [&](const auto& exact, std::size_t k) {
    const T rounded(__builtin_convertvector(exact[k].v, typename T::Lanes));
    return rounded * packet.template each<T>([=](const Triangle& t) { return t.weight[k]; });
  };
  PacketBarycentrics<T> result;
  const T mu1 = weighted(lines.value, 1), mu2 = weighted(lines.value, 2);
  const T sum = weighted(lines.value, 0) + mu1 + mu2;
  result.at = {mu1 / sum, mu2 / sum};
  if (derivatives == Derivatives::yes) {
    const auto change = [&](const auto& step) -> Barycentric<T> {
      const T step1 = weighted(step, 1), step2 = weighted(step, 2);
      const T step_sum = weighted(step, 0) + step1 + step2;
      return {(step1 - result.at.b1 * step_sum) / sum, (step2 - result.at.b2 * step_sum) / sum};
    };
    result.right = change(lines.right);
    result.down = change(lines.down);
  }
  return result;
}

/// Component `c` of the attribute that attribute(triangle) gives.
template <class T, class Triangle, class Attribute>
T interpolate(const Packet<T, Triangle>& packet, const Barycentric<T>& at, Attribute&& attribute, std::size_t c) {
  const auto term = [&](std::size_t corner) {
    return packet.template each<T>([&](const Triangle& t) { return attribute(t)[corner][c]; });
  };
  return term(0) + at.b1 * term(1) + at.b2 * term(2);
}

/// How that component changes with the weights.
template <class T, class Triangle, class Attribute>
T change(const Packet<T, Triangle>& packet, const Barycentric<T>& step, Attribute&& attribute, std::size_t c) {
  const auto term = [&](std::size_t corner) {
    return packet.template each<T>([&](const Triangle& t) { return attribute(t)[corner][c]; });
  };
  return step.b1 * term(1) + step.b2 * term(2);
}

template <class T, class Triangle, class Attribute>
Vec3<T> interpolate3(const Packet<T, Triangle>& packet, const Barycentric<T>& at, Attribute&& attribute) {
  return {interpolate(packet, at, attribute, 0), interpolate(packet, at, attribute, 1),
          interpolate(packet, at, attribute, 2)};
}

} // namespace refraster
