#pragma once
// Perspective-correct interpolation. Here the precision begins. The formulas are written over where their data come
// from: a packet of fragments in lanes (PacketData), or a sample in any Number (raster/shade/sample_data.h).

#include "math/lanes/rows.h"
#include "math/vec.h"
#include "raster/shade/fragments.h"

#include <array>
#include <bit>
#include <type_traits>
#include <utility>

namespace refraster {

/// The lanes of a packet in parts, as many as a register of doubles holds.
template <class T>
struct Parts {
  static constexpr int lanes = std::min(NumberTraits<T>::lanes, NumberTraits<Native<double>>::lanes);
  static constexpr int count = NumberTraits<T>::lanes / lanes;
  using Double = Wide<double, lanes>;

  template <int part>
  static Double widened(const typename Packet<T>::Ints& ints) {
    return [&]<int... I>(std::integer_sequence<int, I...>) {
      return Double(
          __builtin_convertvector(__builtin_shufflevector(ints, ints, (part * lanes + I)...), typename Double::Lanes));
    }
    (std::make_integer_sequence<int, lanes>{});
  }
  /// Each lane rounded once.
  static Wide<RealOf<T>, lanes> narrowed(const Double& x) {
    return __builtin_convertvector(x.v, VectorOf<RealOf<T>, lanes>);
  }
};

/// face_normal() of the triangle that each lane's number(lane) stands for, of any length.
template <class T>
Vec3<T> face_normals(const FrameContext& context, const auto& number) {
  Vec3<T> normals;
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
    const Double3 n = face_normal(context, number(lane));
    const Double3 scaled = n * reciprocal_binade(n);
    for (int c = 0; c < 3; ++c) normals[c].set(lane, static_cast<RealOf<T>>(scaled[c]));
  }
  return normals;
}

/// What is known of how the values of a packet's edge functions are computed: that all are of the kind wrapped, or
/// nothing.
enum class Edges { wrapped, any };

/// The numbers of a packet's triangles, each in its lane. For as long as the packet's list stays as it is.
template <class T, Triangles triangles, Edges edges_known = Edges::any>
class PacketData {
public:
  using Number = T;
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  using Row = std::array<T, 4>;
  using Ints = typename Packet<T>::Ints;

  explicit PacketData(const Packet<T>& packet) : packet_(packet), first_(&packet.triangle(0)) {}

  /// A row of AttributeSetup.
  Row row(int r) const {
    const auto place = [&](int lane) { return of_lane(lane).row[static_cast<std::size_t>(r)].data(); };
    if constexpr (triangles == Triangles::many) {
      const auto numbers = gather_rows<Real, lanes>(place);
      return {T(numbers[0].v), T(numbers[1].v), T(numbers[2].v), T(numbers[3].v)};
    } else return {T(place(0)[0]), T(place(0)[1]), T(place(0)[2]), T(place(0)[3])};
  }
  /// a, b, c of an edge function modulo 2^32.
  std::array<Ints, 3> edge(int k) const {
    const auto place = [&](int lane) { return &of_lane(lane).edge[static_cast<std::size_t>(k)]; };
    if constexpr (triangles == Triangles::many) {
      // Only moved about, never computed with: any bits are good floats.
      const auto bits =
          gather_rows<float, lanes>([&](int lane) { return reinterpret_cast<const float*>(place(lane)); });
      return {std::bit_cast<Ints>(bits[0]), std::bit_cast<Ints>(bits[1]), std::bit_cast<Ints>(bits[2])};
    } else {
      return {place(0)->a - Ints{}, place(0)->b - Ints{}, place(0)->c - Ints{}};
    }
  }

  const Packet<T>& packet() const { return packet_; }
  bool are_wrapped() const { return edges_known == Edges::wrapped || packet_.edges == EdgeKind::wrapped; }

  /// Of all lanes.
  std::uint32_t object() const { return first_->object; }

  /// Lanes differ in that: without_uv() says which have none.
  static constexpr bool may_have_texture_coordinates() { return true; }

  /// The triangles' own normals, of any length; 0 where a triangle has none.
  Vec3<T> own_normals(const FrameContext& context) const {
    return face_normals<T>(context, [this](int lane) { return packet_.triangle(lane).number; });
  }

private:
  const AttributeSetup<Real>& of_lane(int lane) const {
    if constexpr (triangles == Triangles::one) return *first_;
    else return packet_.triangle(lane);
  }

  Packet<T> packet_;
  const AttributeSetup<Real>* first_;
};

/// Of a large triangle, exact in double.
template <Lanes D>
DoubleValues<D> large_values(const LargeEdges& edges, const D& x, const D& y) {
  DoubleValues<D> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto a = static_cast<double>(edges.edge[k].a), b = static_cast<double>(edges.edge[k].b),
               c = static_cast<double>(edges.edge[k].c);
    result.value[k] = D(a) * x + (D(b) * y + D(c));
    result.right[k] = D(a * subpixels);
    result.down[k] = D(b * subpixels);
  }
  return result;
}

/// Edge functions in full from those modulo 2^32: c follows from a value that is exact, at (x, y).
inline LargeEdges unwrapped(const std::array<WrappedEdge, 3>& edges, std::int32_t x, std::int32_t y) {
  LargeEdges result;
  for (std::size_t k = 0; k < 3; ++k) {
    const WrappedEdge& edge = edges[k];
    const auto value = static_cast<std::int32_t>(static_cast<std::uint32_t>(edge.a) * static_cast<std::uint32_t>(x) +
                                                 static_cast<std::uint32_t>(edge.b) * static_cast<std::uint32_t>(y) +
                                                 static_cast<std::uint32_t>(edge.c));
    const std::int64_t a = edge.a, b = edge.b;
    result.edge[k] = {a, b, value - a * x - b * y};
  }
  return result;
}

/// Whether changes by one pixel are asked for.
enum class Derivatives { no, yes };

/// Of the three edge functions: the value at the sample, exact and then rounded once; and its change by one pixel to
/// the right and down. For a projective triangle all are times one factor: only ratios are used.
template <class T>
struct EdgeValues {
  std::array<T, 3> value, right, down;
};

template <Derivatives derivatives, class T, Triangles triangles, Edges edges_known>
EdgeValues<T> wrapped_edge_values(const PacketData<T, triangles, edges_known>& data) {
  using Ints = typename Packet<T>::Ints;
  using Unsigned = VectorOf<std::uint32_t, NumberTraits<T>::lanes>; // which may overflow
  const auto rounded = [](const Unsigned& bits) {
    return T(__builtin_convertvector(std::bit_cast<Ints>(bits), typename T::Lanes));
  };
  EdgeValues<T> edges;
  const auto x = std::bit_cast<Unsigned>(data.packet().x()), y = std::bit_cast<Unsigned>(data.packet().y());
  // All three add up to the same everywhere (SnappedSetup), and so do they modulo 2^32.
  const std::array<Ints, 3> edge0 = data.edge(0);
  Unsigned rest = std::bit_cast<Unsigned>(edge0[2]);
  const auto step = [&](std::size_t k, const Ints& a, const Ints& b) {
    if constexpr (derivatives == Derivatives::yes) {
      edges.right[k] = rounded(std::bit_cast<Unsigned>(a) * subpixels);
      edges.down[k] = rounded(std::bit_cast<Unsigned>(b) * subpixels);
    }
  };
  step(0, edge0[0], edge0[1]);
  for (std::size_t k = 1; k < 3; ++k) {
    const std::array<Ints, 3> edge = data.edge(static_cast<int>(k));
    const auto a = std::bit_cast<Unsigned>(edge[0]), b = std::bit_cast<Unsigned>(edge[1]);
    const Unsigned at_origin = std::bit_cast<Unsigned>(edge[2]), change = a * x + b * y;
    edges.value[k] = rounded(change + at_origin);
    rest = rest - change;
    step(k, edge[0], edge[1]);
  }
  edges.value[0] = rounded(rest);
  return edges;
}

/// The same for a packet that lies in one large or projective triangle: in double.
template <Derivatives derivatives, class T>
EdgeValues<T> uncommon_edge_values(const Packet<T>& packet) {
  using Part = Parts<T>;
  const auto& triangle = packet.triangle(0);
  const auto part = [&]<int p>(std::integral_constant<int, p>) {
    const auto x = Part::template widened<p>(packet.x()), y = Part::template widened<p>(packet.y());
    return triangle.projective ? projective_values(*triangle.projective, x, y) : large_values(*triangle.large, x, y);
  };
  const auto rounded = [](const auto& low, const auto& high) -> T {
    if constexpr (Part::count == 1) return Part::narrowed(low).v;
    else return joined(Part::narrowed(low), Part::narrowed(high)).v;
  };
  const auto low = part(std::integral_constant<int, 0>{}), high = part(std::integral_constant<int, Part::count - 1>{});
  EdgeValues<T> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    edges.value[k] = rounded(low.value[k], high.value[k]);
    if constexpr (derivatives == Derivatives::yes) {
      edges.right[k] = rounded(low.right[k], high.right[k]);
      edges.down[k] = rounded(low.down[k], high.down[k]);
    }
  }
  return edges;
}

/// The same for any other packet: lane by lane. Kept out of line: few packets come here.
template <class T>
[[gnu::noinline]] EdgeValues<T> mixed_edge_values(const Packet<T>& packet) {
  EdgeValues<T> edges;
  for (int lane = 0; lane < NumberTraits<T>::lanes; ++lane) {
    const auto& t = packet.triangle(lane);
    const std::int32_t x = packet.x_of_lane[lane], y = packet.y_of_lane[lane];
    const DoubleValues<double> values = t.projective ? projective_values<double>(*t.projective, x, y)
                                        : t.large    ? large_values<double>(*t.large, x, y)
                                                     : large_values<double>(unwrapped(t.edge, x, y), x, y);
    for (std::size_t k = 0; k < 3; ++k) {
      edges.value[k].set(lane, static_cast<RealOf<T>>(values.value[k]));
      edges.right[k].set(lane, static_cast<RealOf<T>>(values.right[k]));
      edges.down[k].set(lane, static_cast<RealOf<T>>(values.down[k]));
    }
  }
  return edges;
}

/// x; in a number that has symbols (math/bounds/affine.h) what only x depends on is called by one, so that what is
/// computed from it remembers. Each of a fragment is given to one number only.
template <class T>
T with_symbol(const T& x, int symbol) {
  if constexpr (requires { x.named(symbol); }) return x.named(symbol);
  else return x;
}
/// That of a sum of weights is the one before those of the rows of position, normal and texture coordinates. Further
/// attributes have none: they are read once.
inline constexpr int weights_symbol = 2, first_row_symbol = 3;

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

template <Derivatives derivatives, class T, Triangles triangles, Edges edges_known>
EdgeValues<T> edge_values(const PacketData<T, triangles, edges_known>& data) {
  if (data.are_wrapped()) [[likely]]
    return wrapped_edge_values<derivatives>(data);
  if (triangles == Triangles::one) return uncommon_edge_values<derivatives>(data.packet());
  return mixed_edge_values(data.packet());
}

template <Derivatives derivatives, class Data, class T = typename Data::Number>
PacketBarycentrics<T> barycentrics(const Data& data) {
  const EdgeValues<T> edges = edge_values<derivatives>(data);
  const std::array<T, 3> weight{data.row(0)[3], data.row(1)[3], data.row(2)[3]};
  const auto weighted = [&](const std::array<T, 3>& of, std::size_t k) { return of[k] * weight[k]; };
  PacketBarycentrics<T> result;
  const T mu0 = weighted(edges.value, 0), mu1 = weighted(edges.value, 1), mu2 = weighted(edges.value, 2);
  result.inside = min(mu0, min(mu1, mu2)) >= T(0);
  const T reciprocal = with_symbol(T(1) / (mu0 + mu1 + mu2), weights_symbol);
  result.at = {mu1 * reciprocal, mu2 * reciprocal};
  if constexpr (derivatives == Derivatives::yes) {
    const auto change = [&](const auto& step) -> Barycentric<T> {
      const T step1 = weighted(step, 1), step2 = weighted(step, 2);
      const T step_sum = weighted(step, 0) + step1 + step2;
      return {(step1 - result.at.b1 * step_sum) * reciprocal, (step2 - result.at.b2 * step_sum) * reciprocal};
    };
    result.right = change(edges.right);
    result.down = change(edges.down);
    if constexpr (!NumberTraits<T>::decides) data.take_differences(edges, result);
  }
  return result;
}

/// How a component changes when the weights change by `by`.
template <class T>
T changed(const std::array<T, 4>& row, const Barycentric<T>& by) {
  return by.b1 * row[1] + by.b2 * row[2];
}

/// A component of an attribute, by its row.
template <class Data, class T = typename Data::Number>
T interpolated(const Data& data, int component_row, const Barycentric<T>& at) {
  const std::array<T, 4> row = data.row(component_row);
  if constexpr (is_fast<T>) return multiply_add(at.b1, row[1], multiply_add(at.b2, row[2], row[0]));
  else {
    const T value = row[0] + changed(row, at);
    return component_row < uv_row + 2 ? with_symbol(value, first_row_symbol + component_row) : value;
  }
}

/// Texture coordinate c; in the triangle kept within the range of its corners': where an edge has the coordinate 0,
/// rounding would else show the last texel beside the first. NaN stays NaN.
template <class Data, class T = typename Data::Number>
T interpolated_uv(const Data& data, int c, const PacketBarycentrics<T>& at) {
  const T uv = interpolated(data, uv_row + c, at.at);
  if constexpr (!NumberTraits<T>::decides)
    if (data.is_of_device()) return uv; // which keeps it in no range
  return select(at.inside, min(data.row(max_uv_row + c)[3], max(data.row(min_uv_row + c)[3], uv)), uv);
}

/// Where triangles have no texture coordinates: the least is greater than the greatest. No other triangle's is.
template <class Data, class T = typename Data::Number>
MaskOf<T> without_uv(const Data& data) {
  return data.row(min_uv_row)[3] > data.row(max_uv_row)[3];
}

/// An attribute, interpolated; where the mesh has none of it, what stands for it.
template <auto list, class Data, class T = typename Data::Number>
auto attribute_value(const FrameContext& context, const Data& data, const Barycentric<T>& at) {
  constexpr auto attribute = declared(list);
  using Value = glm::vec<attribute.components, T, glm::defaultp>;
  if constexpr (attribute.need == Need::optional)
    if ((context.scene.objects[data.object()].mesh.get()->*list).empty()) return Value(T(attribute.otherwise));
  // At once, since numbers that are written one by one would go through memory.
  return [&]<int... C>(std::integer_sequence<int, C...>) {
    return Value{interpolated(data, first_row(list) + C, at)...};
  }
  (std::make_integer_sequence<int, attribute.components>{});
}

} // namespace refraster
