#include "raster/shade/attribute_setup.h"

#include "math/elementary/double_double.h"
#include "math/lanes/rows.h"
#include "raster/shade/attribute_setup_lanes.h"
#include "raster/shade/corner_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace refraster {

namespace {

// A million triangles come through here: what follows is inlined into one piece of code.

// Position and normal, six numbers one after the other, as four and two lanes.
static_assert(sizeof(WorldVertex) == 6 * sizeof(double) && offsetof(WorldVertex, normal) == 3 * sizeof(double));
struct Corner {
  Wide<double, 4> first; // position, normal.x
  Wide<double, 2> last;  // normal.y, normal.z

  explicit Corner(const WorldVertex& v)
      : first(rows::load<double, 4>(&v.position.x)), last(rows::load<double, 2>(&v.normal.y)) {}
  Corner(const Wide<double, 4>& first_lanes, const Wide<double, 2>& last_lanes)
      : first(first_lanes), last(last_lanes) {}
  friend Corner operator-(const Corner& a, const Corner& b) { return {a.first - b.first, a.last - b.last}; }
};

template <class Real, int N>
Wide<Real, N> narrowed(const Wide<double, N>& x) {
  return __builtin_convertvector(x.v, VectorOf<Real, N>);
}

// Rows 0 to 5: the corners' positions and normals, differences taken in double before they are rounded.
template <class Real>
[[gnu::always_inline]] inline void set_rows(const std::array<const WorldVertex*, 3>& world,
                                            const std::array<double, 3>& weight, AttributeSetup<Real>& t) {
  Corner c0(*world[0]), c1(*world[1]), c2(*world[2]);
  const double scale = normal_scale(*world[0], *world[1], *world[2]);
  if (scale != 1) [[unlikely]] {
    Wide<double, 4> first(1.0);
    first.set(3, scale);
    for (Corner* c : {&c0, &c1, &c2}) c->first *= first, c->last *= Wide<double, 2>(scale);
  }
  const Corner d1 = c1 - c0, d2 = c2 - c0;
  Wide<Real, 4> fourth(Real(0));
  for (int k = 0; k < 3; ++k) fourth.set(k, static_cast<Real>(weight[static_cast<std::size_t>(k)]));
  const auto first =
      transposed<Real, 4>({narrowed<Real>(c0.first), narrowed<Real>(d1.first), narrowed<Real>(d2.first), fourth});
  for (std::size_t r = 0; r < 4; ++r) std::memcpy(t.row[r].data(), &first[r].v, sizeof first[r].v);
  const auto f0 = narrowed<Real>(c0.last), f1 = narrowed<Real>(d1.last), f2 = narrowed<Real>(d2.last);
  t.row[4] = {f0[0], f1[0], f2[0], Real(0)};
  t.row[5] = {f0[1], f1[1], f2[1], Real(0)};
}

/// Out of line: a frame without placed textures does not come here.
[[gnu::noinline]] Repeats placed_repeats(const FrameContext& context, std::uint32_t object, std::uint32_t triangle) {
  return repeats_of(context, object, triangle);
}

// Everything but the edge functions. weight: of the corners, in their order.
template <class Real>
[[gnu::always_inline]] inline void set_attributes(const FrameContext& context, const Vertices& vertices,
                                                  const TriangleRef& ref, const auto& vertex,
                                                  const std::array<std::uint8_t, 3>& corner,
                                                  const std::array<double, 3>& weight, AttributeSetup<Real>& t) {
  const auto world = [&](std::size_t k) { return &vertices.world[vertex[corner[k]]]; };
  set_rows<Real>({world(0), world(1), world(2)}, weight, t);

  const Mesh& mesh = *context.scene.objects[ref.object].mesh;
  const auto& indices = mesh.triangles[ref.triangle];
  const Repeats repeats =
      context.uses.placed_textures ? placed_repeats(context, ref.object, ref.triangle) : Repeats::taken_off;
  for (int c = 0; c < 2; ++c) {
    const AttributeUv<Real> uv = attribute_uv<Real>(mesh, indices, corner, c, repeats);
    t.row[static_cast<std::size_t>(uv_row + c)] = {uv.value[0], uv.value[1], uv.value[2], uv.least};
    t.row[static_cast<std::size_t>(max_uv_row + c)][3] = uv.greatest;
  }
  static_assert(attribute_rows == uv_row + 2 + 3 + 4, "a frame is to know whether there is another attribute");
  if (context.uses.vertex_colours || context.uses.tangents) [[unlikely]]
    for_each_further_attribute(mesh, context.geometry.transforms[ref.object],
                               {indices[corner[0]], indices[corner[1]], indices[corner[2]]},
                               [&](int row, const auto& value) {
                                 for (std::size_t c = 0; c < value[0].size(); ++c)
                                   t.row[static_cast<std::size_t>(row) + c] = {
                                       static_cast<Real>(value[0][c]), static_cast<Real>(value[1][c] - value[0][c]),
                                       static_cast<Real>(value[2][c] - value[0][c]), Real(0)};
                               });
}

LargeEdges large_edges(const Vertices& vertices, const auto& vertex, const std::array<std::uint8_t, 3>& corner) {
  std::array<WindowVertex, 3> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = vertices.window[vertex[corner[k]]];
  return {set_up_snapped(v).value().edge}; // in order already: corners keep their places
}

/// After all others are set up: frames without two-sided objects do not come here.
template <class Real>
[[gnu::noinline]] void turn_normals(const FrameContext& context, std::span<const VisibleTriangle> triangles,
                                    std::span<AttributeSetup<Real>> setups) {
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (is_turned(context, triangles[i].ref, triangles[i].number))
      for_each_turned_row(*context.scene.objects[triangles[i].ref.object].mesh, [&](std::size_t r) {
        for (std::size_t column = 0; column < 3; ++column) { // the fourth is another's
          Real& value = setups[i].row[r][column];
          value = -value;
        }
      });
}

// vertices_of(i): the three of triangles[i] in `vertices`.
template <class Real>
[[gnu::always_inline]] inline void set_up_from(const Vertices& vertices, auto&& vertices_of,
                                               const FrameContext& context, std::span<const VisibleTriangle> triangles,
                                               std::span<AttributeSetup<Real>> setups, UncommonEdges& uncommon) {
  using Row = Native<double>;
  constexpr int lanes = NumberTraits<Row>::lanes;
  constexpr std::size_t ahead = 32; // vertices come from far: asked for long before they are needed
  const std::size_t count = triangles.size();
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t here = std::min(count - begin, std::size_t{lanes});
    for (std::size_t i = begin + ahead; i < std::min(begin + ahead + lanes, count); ++i)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t vertex = vertices_of(i)[k];
        __builtin_prefetch(&vertices.world[vertex]);
        __builtin_prefetch(&vertices.window.placed[vertex]);
        __builtin_prefetch(&vertices.window.inverse_w[vertex]);
      }
    const auto vertex = [&](int lane, std::size_t k) {
      return vertices_of(begin + std::min(static_cast<std::size_t>(lane), here - 1))[k];
    };
    std::array<CornerLanes<lanes>, 3> placed;
    std::array<Row, 3> inverse_w;
    for (std::size_t k = 0; k < 3; ++k) {
      placed[k] = gather_corners<lanes>(
          [&](int lane) -> const PlacedVertex& { return vertices.window.placed[vertex(lane, k)]; });
      std::array<double, lanes> of;
      for (int lane = 0; lane < lanes; ++lane)
        of[static_cast<std::size_t>(lane)] = vertices.window.inverse_w[vertex(lane, k)];
      inverse_w[k] = load_lanes<Row>(of.data());
    }
    const AttributeSetupLanes<lanes> set_up = attribute_setup_lanes<lanes>(placed, inverse_w);
    std::array<std::array<double, lanes>, 3> weights;
    for (std::size_t k = 0; k < 3; ++k) {
      const Row least(min_weight<Real>);
      weights[k] = listed(max(set_up.corner[k].weight, least));
    }

    for (std::size_t i = 0; i < here; ++i) {
      const auto lane = static_cast<int>(i);
      const TriangleRef& ref = triangles[begin + i].ref;
      const std::uint32_t number = triangles[begin + i].number;
      const auto& corners = vertices_of(begin + i);
      AttributeSetup<Real>& t = setups[begin + i];
      t.object = ref.object;
      t.number = number;
      t.large = nullptr, t.projective = nullptr;
      const auto state = [&](std::size_t k) { return vertices.window.placed[corners[k]].outcode(); };
      if ((state(0) | state(1) | state(2)) & outcode::unsnapped) [[unlikely]] {
        const ProjectiveTriangle& projective = context.bins.projective_triangle(number);
        t.projective = &uncommon.projective.emplace_back(projective);
        set_attributes<Real>(context, vertices, ref, corners, projective.corner, {1, 1, 1},
                             t); // its edge functions bring their weights
        continue;
      }
      const auto corner_at = [&](std::size_t k) { return static_cast<std::uint8_t>(set_up.corner[k].submitted[lane]); };
      const std::array<std::uint8_t, 3> corner{corner_at(0), corner_at(1), corner_at(2)};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto& edge = set_up.corner[k];
        t.edge[k] = {edge.a[lane], edge.b[lane], edge.c[lane]};
      }
      if (!set_up.wraps[lane]) t.large = &uncommon.large.emplace_back(large_edges(vertices, corners, corner));
      set_attributes<Real>(context, vertices, ref, corners, corner, {weights[0][i], weights[1][i], weights[2][i]}, t);
    }
  }
}

/// The same of a frame that does not store all vertices: those of these triangles are made or copied first.
template <class Real>
[[gnu::noinline]] void set_up_on_demand(const FrameContext& context, std::span<const VisibleTriangle> triangles,
                                        std::span<AttributeSetup<Real>> setups, UncommonEdges& uncommon) {
  std::vector<TriangleRef> refs;
  refs.reserve(triangles.size());
  for (const VisibleTriangle& triangle : triangles) refs.push_back(triangle.ref);
  Vertices vertices;
  gather_vertices(context.geometry, refs, vertices);
  const auto gathered = [](std::size_t i) {
    const auto first = static_cast<std::uint32_t>(3 * i);
    return std::array{first, first + 1, first + 2};
  };
  set_up_from<Real>(vertices, gathered, context, triangles, setups, uncommon);
}

} // namespace

bool shows_back(const FrameContext& context, const TriangleRef& ref, std::uint32_t number) {
  const std::array<WindowVertex, 3> v = window_corners(context.geometry, ref);
  bool from_behind = false;
  if ((v[0].outcode | v[1].outcode | v[2].outcode) & outcode::unsnapped) {
    from_behind = context.bins.projective_triangle(number).facing == Facing::back;
  } else {
    const auto from_first = [&](std::size_t k) {
      return std::array<std::int64_t, 2>{v[k].x - v[0].x, v[k].y - v[0].y}; // below 2^26
    };
    const auto a = from_first(1), b = from_first(2);
    from_behind = a[0] * b[1] - b[0] * a[1] > 0; // clockwise in the image, with y down
  }
  return from_behind != is_mirrored(context.scene.objects[ref.object]);
}

bool is_turned(const FrameContext& context, const TriangleRef& ref, std::uint32_t number) {
  return context.scene.objects[ref.object].two_sided == TwoSided::yes && shows_back(context, ref, number);
}

template <class Real>
void set_up_attributes(const FrameContext& context, std::span<const VisibleTriangle> triangles,
                       std::span<AttributeSetup<Real>> setups, UncommonEdges& uncommon) {
  if (context.geometry.all_stored() && context.geometry.world_stored) [[likely]] {
    const auto in_geometry = [&](std::size_t i) -> const auto& {
      return triangles[i].ref.vertex;
    };
    set_up_from<Real>(context.geometry, in_geometry, context, triangles, setups, uncommon);
  } else {
    set_up_on_demand<Real>(context, triangles, setups, uncommon);
  }
  if (context.uses.two_sided) [[unlikely]]
    turn_normals(context, triangles, setups);
}

template void set_up_attributes(const FrameContext&, std::span<const VisibleTriangle>,
                                std::span<AttributeSetup<double>>, UncommonEdges&);
template void set_up_attributes(const FrameContext&, std::span<const VisibleTriangle>, std::span<AttributeSetup<float>>,
                                UncommonEdges&);

std::array<double, 2> whole_repeats(const FrameContext& context, std::uint32_t number) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const Mesh& mesh = *context.scene.objects[ref.object].mesh;
  const auto& vertices = mesh.triangles[ref.triangle];
  if (!has_uvs(mesh, vertices)) return {};
  const Repeats repeats = repeats_of(context, ref.object, ref.triangle);
  return {uv_component(mesh, vertices, 0, repeats).whole, uv_component(mesh, vertices, 1, repeats).whole};
}

Double3 face_normal(const FrameContext& context, std::uint32_t number) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const Mesh& mesh = *context.scene.objects[ref.object].mesh;
  const auto corner = [&](std::size_t k) { return Double3(mesh.positions[mesh.triangles[ref.triangle][k]]); };
  // Of a needle the edges are nearly parallel: differences and products are carried to twice the precision, so that
  // what their difference leaves is good. Each edge is brought near unit length first: nothing overflows or vanishes.
  const Double3 p0 = corner(0), p1 = corner(1), p2 = corner(2);
  const double scale1 = reciprocal_binade(p1 - p0), scale2 = reciprocal_binade(p2 - p0);
  const auto edge = [&](const Double3& p, int c, double scale) {
    const DoubleDouble<double> difference = two_sum(p[c], -p0[c]);
    return DoubleDouble<double>{difference.hi * scale, difference.lo * scale};
  };
  const auto minor = [&](int i, int j) {
    const DoubleDouble<double> a = two_product(edge(p1, i, scale1), edge(p2, j, scale2));
    const DoubleDouble<double> b = two_product(edge(p1, j, scale1), edge(p2, i, scale2));
    const DoubleDouble<double> difference = two_sum(a.hi, -b.hi);
    return difference.hi + (difference.lo + (a.lo - b.lo));
  };
  const Double3 normal =
      context.geometry.transforms[ref.object].world_from_normal * Double3(minor(1, 2), minor(2, 0), minor(0, 1));
  return context.uses.two_sided && is_turned(context, ref, number) ? -normal : normal;
}

} // namespace refraster
