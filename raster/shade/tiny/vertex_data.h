#pragma once
// What is interpolated over tiny triangles, straight from their vertices: a register of fragments at a time, each of a
// triangle of its own. A record a triangle (AttributeSetup) that is written once and read once costs more than all that
// is computed for it. The bits are those of the records: every number is made by the same operations.

#include "raster/shade/corner_values.h"
#include "raster/shade/interpolate.h"
#include "raster/vertex/vertex_stage.h"
#include "raster/visibility/tiny/tiny_triangles.h"

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace refraster {

/// As many fragments as T has lanes, of one object and material.
template <class T>
struct TinyPacket {
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Ints = VectorOf<std::int32_t, lanes>;

  std::uint32_t object = 0;
  const std::uint32_t* number = nullptr; // of each lane's triangle in the frame
  Ints x{}, y{};                         // pixel centres, subpixels of the window
  int count = 0;                         // lanes in use; the others repeat one of them
};

/// What is asked of the triangles of a material beside position and normal.
struct VertexNeeds {
  bool uvs = false, derivatives = false;
  Repeats repeats = Repeats::taken_off; // of uvs
};

/// The numbers of a packet's triangles, each in its lane: to formulas the same as PacketData. Where triangles lie is
/// computed in 32-bit integers; what is interpolated, in double, a part of the packet after the other, and kept in
/// memory as the formulas' registers.
template <class T>
class VertexData {
public:
  using Number = T;
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  using Row = std::array<T, 4>;

  [[gnu::always_inline]] VertexData(const FrameContext& context, const TinyPacket<T>& packet, const VertexNeeds& needs)
      : packet_(packet) {
    const Object& object = context.scene.objects[packet.object];
    const Mesh& mesh = *object.mesh;
    const Geometry& geometry = context.geometry;
    const std::uint32_t first_triangle = geometry.first_triangle[packet.object];
    const std::size_t first_vertex = geometry.first_vertex[packet.object];
    const auto* const triangles = mesh.triangles.data();
    const PlacedVertex* const placed = geometry.window.placed.data() + first_vertex;
    const double* const inverse_w = geometry.window.inverse_w.data() + first_vertex;

    // All that the corners bring is read as they are submitted, so that no read waits for what was computed.
    std::array<std::array<std::uint32_t, lanes>, 3> vertices; // of the mesh
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto& triangle = triangles[packet.number[lane] - first_triangle];
      for (std::size_t k = 0; k < 3; ++k) vertices[k][lane] = triangle[k];
    }
    const auto vertex = [&](std::size_t k, int lane) {
      return std::size_t{vertices[k][static_cast<std::size_t>(lane)]};
    };
    Ints x_sides[3], y_state[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto of_part = [&](int part) {
        return gather_doubles<part_lanes>([&](int lane) { return &placed[vertex(k, part * part_lanes + lane)]; });
      };
      if constexpr (parts == 1) part_words<lanes, 1>({of_part(0)}, x_sides[k], y_state[k]);
      else part_words<lanes, 2>({of_part(0), of_part(1)}, x_sides[k], y_state[k]);
    }
    const TinyTriangles<lanes> places(x_sides, y_state);
    fits_ = places.fit;
    if (!fits_) [[unlikely]]
      return;
    const TinySetup<lanes> t(places);
    // The values at pixel centres are exact, and then rounded once.
    typename TinySetup<lanes>::Unsigned e[3];
    t.values(packet.x, packet.y, e);
    for (std::size_t k = 0; k < 3; ++k) store(edge_[k], rounded(std::bit_cast<Ints>(e[k])));
    if (needs.derivatives)
      for (std::size_t k = 0; k < 3; ++k)
        store(edge_[3 + k], rounded(t.a[k] * subpixels)), store(edge_[6 + k], rounded(t.b[k] * subpixels));

    // Corner k in the order of set-up.
    const Ints first[] = {t.submitted[0] == 0, t.submitted[1] == 0, t.submitted[2] == 0};
    const Ints second[] = {t.submitted[0] == 1, t.submitted[1] == 1, t.submitted[2] == 1};
    const auto in_order = [&](std::size_t k, const auto& of0, const auto& of1, const auto& of2) {
      return pick(first[k], of0, pick(second[k], of1, of2));
    };
    {
      Wide<Real, lanes> weight[3];
      const auto of_part = [&](std::size_t part, Wide<Real, part_lanes>(&to)[3]) {
        const auto inverse = [&](std::size_t k) {
          return gather_doubles<part_lanes>(
              [&](int lane) { return &inverse_w[vertex(k, static_cast<int>(part) * part_lanes + lane)]; });
        };
        const std::array<Doubles, 3> weights = perspective_weights<Doubles>({inverse(0), inverse(1), inverse(2)});
        for (std::size_t k = 0; k < 3; ++k) to[k] = Parts<T>::narrowed(max(weights[k], Doubles(min_weight<Real>)));
      };
      Wide<Real, part_lanes> low[3], high[3];
      of_part(0, low);
      if constexpr (parts == 2) of_part(1, high);
      for (std::size_t k = 0; k < 3; ++k) weight[k] = together(low[k], high[k]);
      for (std::size_t k = 0; k < 3; ++k) store(row_[4 * k + 3], in_order(k, weight[0], weight[1], weight[2]));
    }

    // From the mesh, which is half as large as what the frame may have stored of it in the world.
    const ObjectTransform& matrices = geometry.transforms[packet.object];
    const auto ordered = [&](const std::vector<Float3>& from, std::array<Wide<float, lanes>, 3>(&to)[3]) {
      const auto of = [&](std::size_t k) {
        return gather_triples<lanes>([&](int lane) { return &from[vertex(k, lane)].x; });
      };
      const auto at0 = of(0), at1 = of(1), at2 = of(2);
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t c = 0; c < 3; ++c) to[k][c] = in_order(k, at0[c], at1[c], at2[c]);
    };
    std::array<Wide<float, lanes>, 3> position[3], normal[3];
    ordered(mesh.positions, position);
    ordered(mesh.normals, normal);
    set_rows<0>(matrices, position, normal);
    if constexpr (parts == 2) set_rows<1>(matrices, position, normal);
    if (object.two_sided == TwoSided::yes) [[unlikely]] // see shows_back()
      turn_normals(matrices.handedness < 0 ? places.area() < 0 : places.area() > 0);
    if (needs.uvs) [[unlikely]] {
      std::array<std::array<std::int32_t, lanes>, 3> submitted;
      for (std::size_t k = 0; k < 3; ++k) store_lanes(submitted[k].data(), t.submitted[k]);
      set_uvs(mesh, first_triangle, submitted, needs.repeats);
    }
  }

  /// Whether all triangles are tiny, with corners on the lattice: else what is here means nothing.
  bool fits() const { return fits_; }

  /// A row of AttributeSetup: of position and normal, and of texture coordinates where those are needed.
  Row row(int r) const {
    assert(r < uv_row + 2); // what else a mesh may have, tiles of tiny triangles have not: TinyFragments::collect
    const Stored* const at = &row_[4 * static_cast<std::size_t>(r)];
    return {loaded(at[0]), loaded(at[1]), loaded(at[2]), loaded(at[3])};
  }
  template <Derivatives derivatives>
  EdgeValues<T> edges() const {
    const auto three = [this](std::size_t at) -> std::array<T, 3> {
      return {loaded(edge_[at]), loaded(edge_[at + 1]), loaded(edge_[at + 2])};
    };
    EdgeValues<T> edges;
    edges.value = three(0);
    if constexpr (derivatives == Derivatives::yes) edges.right = three(3), edges.down = three(6);
    return edges;
  }

  /// Lanes differ in that: without_uv() says which have none.
  static constexpr bool may_have_texture_coordinates() { return true; }

  /// Of all lanes.
  std::uint32_t object() const { return packet_.object; }

  /// The triangles' own normals, of any length; 0 where a triangle has none.
  Vec3<T> own_normals(const FrameContext& context) const {
    return face_normals<T>(context, [this](int lane) { return packet_.number[lane]; });
  }

private:
  using Ints = VectorOf<std::int32_t, lanes>;
  using Reals = Wide<Real, lanes>;
  static constexpr int part_lanes = Parts<T>::lanes, parts = Parts<T>::count;
  using Doubles = typename Parts<T>::Double;
  struct alignas(lanes * sizeof(Real)) Stored {
    std::array<Real, lanes> number;
  };
  static T loaded(const Stored& from) { return T(load_lanes<Reals>(from.number.data()).v); }
  static void store(Stored& to, const Reals& x) { store_lanes(to.number.data(), x); }
  template <int part>
  static void store(Stored& to, const Doubles& x) {
    store_lanes(&to.number[part * part_lanes], Parts<T>::narrowed(x));
  }
  static Reals rounded(const Ints& x) { return __builtin_convertvector(x, VectorOf<Real, lanes>); }
  static Reals together(const Wide<Real, part_lanes>& low, const Wide<Real, part_lanes>& high) {
    if constexpr (parts == 1) return low;
    else return joined(low, high);
  }
  // x where m is true, else y.
  template <class F>
  static Wide<F, lanes> pick(const Ints& m, const Wide<F, lanes>& x, const Wide<F, lanes>& y) {
    if constexpr (sizeof(F) == sizeof(std::int32_t)) return VectorOf<F, lanes>(m ? x.v : y.v);
    else return VectorOf<F, lanes>(__builtin_convertvector(m, VectorOf<std::int64_t, lanes>) ? x.v : y.v);
  }
  // Part of a register of floats, in double.
  template <int part>
  static Doubles widened(const Wide<float, lanes>& x) {
    return [&]<int... I>(std::integer_sequence<int, I...>) {
      return Doubles(__builtin_convertvector(__builtin_shufflevector(x.v, x.v, (part * part_lanes + I)...),
                                             VectorOf<double, part_lanes>));
    }
    (std::make_integer_sequence<int, part_lanes>{});
  }

  // Rows of position and normal. Corners are in the order of set-up; differences are taken in double before they are
  // rounded.
  template <int part>
  [[gnu::always_inline]] void set_rows(const ObjectTransform& matrices,
                                       const std::array<Wide<float, lanes>, 3> (&position)[3],
                                       const std::array<Wide<float, lanes>, 3> (&normal)[3]) {
    const auto in_double = [](const std::array<Wide<float, lanes>, 3>& x) {
      return Vec3<Doubles>(widened<part>(x[0]), widened<part>(x[1]), widened<part>(x[2]));
    };
    const auto store_row = [&](std::size_t r, const Doubles& c0, const Doubles& c1, const Doubles& c2) {
      store<part>(row_[4 * r], c0), store<part>(row_[4 * r + 1], c1 - c0), store<part>(row_[4 * r + 2], c2 - c0);
    };
    const auto world = [&](std::size_t k) {
      return world_position(matrices.world_from_object, in_double(position[k]));
    };
    const Vec3<Doubles> p0 = world(0), p1 = world(1), p2 = world(2);
    store_row(0, p0.x, p1.x, p2.x), store_row(1, p0.y, p1.y, p2.y), store_row(2, p0.z, p1.z, p2.z);

    const auto turn = [&](std::size_t k) { return world_normal(matrices.world_from_normal, in_double(normal[k])); };
    Vec3<Doubles> n0 = turn(0), n1 = turn(1), n2 = turn(2);
    const auto size = [](const Vec3<Doubles>& n) { return max(abs(n.x), max(abs(n.y), abs(n.z))); };
    const Doubles s0 = size(n0), s1 = size(n1), s2 = size(n2);
    const auto ordinary =
        (min(s0, min(s1, s2)) >= Doubles(1 / ordinary_normal)) & (max(s0, max(s1, s2)) <= Doubles(ordinary_normal));
    if (any(!ordinary)) [[unlikely]] {
      const Doubles scale = normal_scales(s0, s1, s2);
      n0 = n0 * scale, n1 = n1 * scale, n2 = n2 * scale;
    }
    store_row(3, n0.x, n1.x, n2.x), store_row(4, n0.y, n1.y, n2.y), store_row(5, n0.z, n1.z, n2.z);
  }

  [[gnu::noinline]] static Doubles normal_scales(Doubles s0, Doubles s1, Doubles s2) {
    Doubles scale;
    for (int lane = 0; lane < part_lanes; ++lane) scale.set(lane, normal_scale({s0[lane], s1[lane], s2[lane]}));
    return scale;
  }

  // Where they are, normals and their differences change their sign, which rounds nothing.
  [[gnu::noinline]] void turn_normals(const Ints& turned) {
    const Reals sign = rounded(turned * 2 + 1);
    for (std::size_t r = normal_row; r < normal_row + 3; ++r)
      for (std::size_t k = 0; k < 3; ++k) {
        Stored& stored = row_[4 * r + k];
        store(stored, load_lanes<Reals>(stored.number.data()) * sign);
      }
  }

  // Out of line: what has no textures is not to pay for it.
  [[gnu::noinline]] void set_uvs(const Mesh& mesh, std::uint32_t first_triangle,
                                 const std::array<std::array<std::int32_t, lanes>, 3>& submitted, Repeats repeats) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const auto& triangle = mesh.triangles[packet_.number[lane] - first_triangle];
      const auto corner = [&](std::size_t k) { return static_cast<std::uint8_t>(submitted[k][lane]); };
      for (std::size_t c = 0; c < 2; ++c) {
        const AttributeUv<Real> uv =
            attribute_uv<Real>(mesh, triangle, {corner(0), corner(1), corner(2)}, static_cast<int>(c), repeats);
        for (std::size_t k = 0; k < 3; ++k) row_[4 * (uv_row + c) + k].number[lane] = uv.value[k];
        row_[4 * (min_uv_row + c) + 3].number[lane] = uv.least;
        row_[4 * (max_uv_row + c) + 3].number[lane] = uv.greatest;
      }
    }
  }

  const TinyPacket<T>& packet_;
  bool fits_;
  std::array<Stored, 9> edge_;               // values; changes by a pixel to the right, and down, where needed
  std::array<Stored, 4 * (uv_row + 2)> row_; // by rows
};

template <Derivatives derivatives, class T>
EdgeValues<T> edge_values(const VertexData<T>& data) {
  return data.template edges<derivatives>();
}

} // namespace refraster
