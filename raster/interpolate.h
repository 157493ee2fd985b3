#pragma once
// Perspective-correct interpolation of a packet of fragments. Here the rung begins.

#include "raster/fragments.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace refraster {

/// Whether a packet's fragments lie in one triangle: its data are then broadcast to all lanes, else gathered.
enum class Triangles { one, many };

/// The numbers of a packet's triangles, each in its lane.
template <class T, Triangles triangles>
class PacketData {
public:
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  // Line values are exact in double. Float packets have twice as many lanes as a register of doubles: they go by parts.
  static constexpr int part_lanes = std::min(lanes, NumberTraits<Native<double>>::lanes);
  static constexpr int parts = lanes / part_lanes;
  using Exact = Wide<double, part_lanes>;

  explicit PacketData(const Packet<T>& packet) : packet_(packet), base_(packet.triangle[0]) {
    if constexpr (triangles == Triangles::many)
      for (int lane = 0; lane < lanes; ++lane)
        step_[lane] = static_cast<std::int32_t>(packet.triangle[static_cast<std::size_t>(lane)] - base_);
  }

  T value(int i) const {
    const Real* const at = base_->value.data() + i;
    if constexpr (triangles == Triangles::one) return T(*at);
    else return gather<Real, lanes>(at, step_ * static_cast<std::int32_t>(sizeof *base_ / sizeof(Real)));
  }
  /// Coefficient i of the lines, of the lanes in a part.
  Exact line(int i, int part) const {
    const double* const at = base_->line.data() + i;
    if constexpr (triangles == Triangles::one) return Exact(*at);
    else
      return gather<double, part_lanes>(at, part_of(step_, part) *
                                                static_cast<std::int32_t>(sizeof *base_ / sizeof(double)));
  }
  /// The pixel centres of the lanes in a part.
  Exact x(int part) const { return in_double(packet_.x.data() + part * part_lanes); }
  Exact y(int part) const { return in_double(packet_.y.data() + part * part_lanes); }

  /// Component c of an attribute, with weights b1, b2 of the corners that are not the anchor.
  T interpolated(Attribute attribute, int c, const T& b1, const T& b2) const {
    return value(static_cast<int>(attribute) + c) + changed(attribute, c, b1, b2);
  }
  /// How an attribute changes when the weights change by b1, b2.
  T changed(Attribute attribute, int c, const T& b1, const T& b2) const {
    const int at = static_cast<int>(attribute) + c, n = components(attribute);
    return b1 * value(at + n) + b2 * value(at + 2 * n);
  }

  /// The parts put together, each lane rounded once.
  static T rounded(const std::array<Exact, parts>& exact) {
    const auto narrow = [](const Exact& e) {
      return Wide<Real, part_lanes>(__builtin_convertvector(e.v, VectorOf<Real, part_lanes>));
    };
    if constexpr (parts == 1) return narrow(exact[0]);
    else return joined(narrow(exact[0]), narrow(exact[1]));
  }

  const Packet<T>& packet() const { return packet_; }

private:
  using PartInts = VectorOf<std::int32_t, part_lanes>;
  static PartInts part_of(const VectorOf<std::int32_t, lanes>& ints, int part) {
    PartInts result;
    std::memcpy(&result, reinterpret_cast<const std::int32_t*>(&ints) + part * part_lanes, sizeof result);
    return result;
  }
  static Exact in_double(const std::int32_t* ints) {
    PartInts part;
    std::memcpy(&part, ints, sizeof part);
    return __builtin_convertvector(part, typename Exact::Lanes);
  }

  const Packet<T>& packet_;
  const SurfaceTriangle<Real>* base_;
  VectorOf<std::int32_t, lanes> step_{};
};

/// Whether changes by one pixel are asked for.
enum class Derivatives { no, yes };

/// Of the three lines: the value at the sample, exact and then rounded once; and its change by one pixel to the right
/// and down. For a projective triangle all are times one factor: only ratios are used.
template <class T>
struct LineValues {
  std::array<T, 3> value, right, down;
};

template <Derivatives derivatives, class T, Triangles triangles>
LineValues<T> line_values(const PacketData<T, triangles>& data) {
  using Data = PacketData<T, triangles>;
  using Parts = std::array<typename Data::Exact, Data::parts>;
  LineValues<T> lines;
  for (int k = 0; k < 3; ++k) {
    Parts value, right, down;
    for (int part = 0; part < Data::parts; ++part) {
      const auto p = static_cast<std::size_t>(part);
      const auto a = data.line(3 * k, part), b = data.line(3 * k + 1, part);
      value[p] = a * data.x(part) + (b * data.y(part) + data.line(3 * k + 2, part));
      if constexpr (derivatives == Derivatives::yes) {
        right[p] = a * typename Data::Exact(subpixels);
        down[p] = b * typename Data::Exact(subpixels);
      }
    }
    const auto i = static_cast<std::size_t>(k);
    lines.value[i] = Data::rounded(value);
    if constexpr (derivatives == Derivatives::yes) {
      lines.right[i] = Data::rounded(right);
      lines.down[i] = Data::rounded(down);
    }
  }
  return lines;
}

/// The same where a triangle of the packet is projective: lane by lane. Kept out of line: few packets come here.
template <class T>
[[gnu::noinline]] LineValues<T> projective_line_values(const Packet<T>& packet) {
  using Real = RealOf<T>;
  LineValues<T> lines;
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
    const auto l = static_cast<std::size_t>(lane);
    const auto& t = *packet.triangle[l];
    std::array<double, 3> value{}, a{}, b{};
    if (t.projective) {
      // By way of the piece's vertices to the corners: sums of what is not negative.
      const ProjectivePiece& piece = t.projective->piece_at(packet.x[l], packet.y[l]);
      for (std::size_t v = 0; v < 3; ++v) {
        const ProjectiveLine& line = piece.line[v];
        for (std::size_t k = 0; k < 3; ++k) {
          const double weight = piece.weight[v] * piece.share[v][k];
          value[k] += static_cast<double>(line.at(packet.x[l], packet.y[l])) * weight;
          a[k] += static_cast<double>(line.a) * weight, b[k] += static_cast<double>(line.b) * weight;
        }
      }
    } else {
      for (std::size_t k = 0; k < 3; ++k) {
        a[k] = t.line[3 * k], b[k] = t.line[3 * k + 1];
        value[k] = a[k] * packet.x[l] + (b[k] * packet.y[l] + t.line[3 * k + 2]);
      }
    }
    // The sizes of projective lines differ without bound: bring the largest value near 1 before T rounds it.
    const double scale =
        t.projective
            ? reciprocal_binade(maximum(magnitude(value[0]), maximum(magnitude(value[1]), magnitude(value[2]))))
            : 1;
    for (std::size_t k = 0; k < 3; ++k) {
      lines.value[k].set(lane, static_cast<Real>(value[k] * scale));
      lines.right[k].set(lane, static_cast<Real>(a[k] * scale * subpixels));
      lines.down[k].set(lane, static_cast<Real>(b[k] * scale * subpixels));
    }
  }
  return lines;
}

/// Weights of the two corners that are not the anchor: perspective-correct, each in [0, 1] inside the triangle.
template <class T>
struct Barycentric {
  T b1, b2;
};

/// At the sample; and, where asked for, their change by one pixel to the right and down: the derivative of the
/// quotient, not a difference of neighbours.
template <class T>
struct PacketBarycentrics {
  Barycentric<T> at, right, down;
  MaskOf<T> inside; // the sample lies in the triangle, by signs that no rounding has touched
};

template <Derivatives derivatives, class T, Triangles triangles>
PacketBarycentrics<T> barycentrics(const PacketData<T, triangles>& data) {
  bool any_projective = false;
  for (const auto* t : data.packet().triangle) {
    any_projective |= t->projective != nullptr;
    if constexpr (triangles == Triangles::one) break;
  }
  const LineValues<T> lines = any_projective ? projective_line_values(data.packet()) : line_values<derivatives>(data);
  const std::array<T, 3> weight{data.value(0), data.value(1), data.value(2)};
  const auto weighted = [&](const std::array<T, 3>& values, std::size_t k) { return values[k] * weight[k]; };
  PacketBarycentrics<T> result;
  const T mu0 = weighted(lines.value, 0), mu1 = weighted(lines.value, 1), mu2 = weighted(lines.value, 2);
  result.inside = minimum(mu0, minimum(mu1, mu2)) >= T(0);
  const T reciprocal = T(1) / (mu0 + mu1 + mu2);
  result.at = {mu1 * reciprocal, mu2 * reciprocal};
  if constexpr (derivatives == Derivatives::yes) {
    const auto change = [&](const auto& step) -> Barycentric<T> {
      const T step1 = weighted(step, 1), step2 = weighted(step, 2);
      const T step_sum = weighted(step, 0) + step1 + step2;
      return {(step1 - result.at.b1 * step_sum) * reciprocal, (step2 - result.at.b2 * step_sum) * reciprocal};
    };
    result.right = change(lines.right);
    result.down = change(lines.down);
  }
  return result;
}

/// Texture coordinate c; in the triangle kept within the range of its corners': where an edge has the coordinate 0,
/// rounding would else show the last texel beside the first. NaN stays NaN.
template <class T, Triangles triangles>
T interpolated_uv(const PacketData<T, triangles>& data, int c, const PacketBarycentrics<T>& at) {
  const T uv = data.interpolated(Attribute::uv, c, at.at.b1, at.at.b2);
  return select(at.inside, minimum(data.value(most_uv + c), maximum(data.value(least_uv + c), uv)), uv);
}

template <class T, Triangles triangles>
Vec3<T> interpolated3(const PacketData<T, triangles>& data, Attribute attribute, const Barycentric<T>& at) {
  return {data.interpolated(attribute, 0, at.b1, at.b2), data.interpolated(attribute, 1, at.b1, at.b2),
          data.interpolated(attribute, 2, at.b1, at.b2)};
}

} // namespace refraster
