#pragma once
// From a visible triangle to what is interpolated over it: perspective-correct attributes at pixel centres, in the
// number of a precision. Here the precision begins.

#include "math/precisions.h"
#include "raster/shade/projective_edges.h"
#include "raster/visibility/bin.h"

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace refraster {

/// Calls visit(attribute, its first row) with each vertex attribute. Each component has a row in an AttributeSetup.
constexpr void for_each_attribute_row(auto&& visit) {
  int row = 0;
  for_each_vertex_attribute([&](const auto& attribute) {
    visit(attribute, row);
    row += attribute.components;
  });
}

/// The first row of an attribute.
template <class Value>
constexpr int first_row(std::vector<Value> Mesh::*list) {
  int found = -1;
  for_each_attribute_row([&](const auto& attribute, int row) {
    if constexpr (std::is_same_v<decltype(attribute.values), std::vector<Value> Mesh::*>)
      if (attribute.values == list) found = row;
  });
  return found;
}
inline constexpr int position_row = first_row(&Mesh::positions), normal_row = first_row(&Mesh::normals),
                     uv_row = first_row(&Mesh::uvs), tangent_row = first_row(&Mesh::tangents);
static_assert(position_row == 0 && normal_row == 3 && uv_row == 6); // the fourth column is divided among these
inline constexpr int attribute_rows =
    std::apply([](const auto&... each) { return (each.components + ...); }, vertex_attributes);

/// a, b, c of an edge function modulo 2^32.
struct alignas(16) WrappedEdge {
  std::int32_t a = 0, b = 0, c = 0, unused = 0;
};

/// Edge functions of a triangle too large for that: exact as well.
struct LargeEdges {
  std::array<SnappedEdge, 3> edge;
};

/// The edge functions of those of a tile's triangles that need more room. They stay where they are.
struct UncommonEdges {
  std::deque<LargeEdges> large;
  std::deque<ProjectiveEdges> projective;
};

/// How the values of a triangle's edge functions are computed. Packets of only the first kind are the fast ones.
enum class EdgeKind : std::uint8_t {
  wrapped,   // in 32-bit integers: nearly all
  large,     // in double, where they are exact as well
  projective // from the edge functions of a ProjectiveTriangle, and rounded
};

/// What shading needs of one visible triangle, attributes in this precision. Rows of four numbers, so that lanes
/// that see different triangles can read them a row at a time (math/lanes/rows.h).
///
/// An attribute is kept as its value at one corner and the differences to the other two: f = f0 + b1 (f1 - f0) +
/// b2 (f2 - f0). So a value that is the same at all three corners comes out unchanged, bit for bit, and nothing is
/// anchored at the framebuffer's origin, where a small far triangle would lose its digits.
template <class Real>
struct AttributeSetup {
  /// Leaves rows as they are in memory: of a tile with a thousand triangles each would be zeroed to be set at once.
  AttributeSetup() {} // NOLINT(modernize-use-equals-default): a defaulted one would be asked for zeros

  /// Only of the kind wrapped. Sums and products of 32-bit integers are right modulo 2^32, so that a value of less than
  /// 2^31 comes out exact, however large the terms.
  std::array<WrappedEdge, 3> edge;
  /// Row r: the component at the anchor, its differences to the other two corners; and one number more: in rows 0 to 2
  /// the weights of perspective_weights (1 if projective); in rows 6 and 7 the least, in rows 4 and 5 the
  /// greatest u and v of the three corners. Without texture coordinates the anchor's is NaN, so that every one that is
  /// interpolated is, and the least is 1 and the greatest 0, so that it is known for what it is. Rows of a further
  /// attribute are set, and read, only where the mesh has it.
  std::array<std::array<Real, 4>, attribute_rows> row;
  const LargeEdges* large = nullptr;
  const ProjectiveEdges* projective = nullptr;
  std::uint32_t object = 0;
  std::uint32_t number = 0; // in the frame

  EdgeKind kind() const { return projective ? EdgeKind::projective : large ? EdgeKind::large : EdgeKind::wrapped; }
};
inline constexpr int min_uv_row = 6, max_uv_row = 4; // of u; of v it is the next

/// A triangle that is seen, by its number in the frame and what that stands for.
struct VisibleTriangle {
  TriangleRef ref;
  std::uint32_t number = 0;
};

/// Whether a triangle is seen from the side away from its normals: the sign of its area in the window, which is exact,
/// times that of the model's determinant. The triangle has area in the window.
bool shows_back(const FrameContext& context, const TriangleRef& ref, std::uint32_t number);

/// Whether its normals are turned: it shows its back, and its object is two-sided.
bool is_turned(const FrameContext& context, const TriangleRef& ref, std::uint32_t number);

/// Calls body(row) with those of AttributeSetup that are negated where a triangle is turned: of normals and, where the
/// mesh has them, of tangents with their handedness, which make the normal of any map change its sign, and nothing
/// else.
void for_each_turned_row(const Mesh& mesh, auto&& body) {
  for (int r = normal_row; r < normal_row + 3; ++r) body(static_cast<std::size_t>(r));
  if (!mesh.tangents.empty())
    for (int r = tangent_row; r < tangent_row + 4; ++r) body(static_cast<std::size_t>(r));
}

/// Sets up setups[i] for triangles[i]. Of one that is turned, normals and their differences are negated, which rounds
/// nothing: what is interpolated is turned, bit for bit. What their edge functions need of `uncommon` is appended
/// there.
template <class Real>
void set_up_attributes(const FrameContext& context, std::span<const VisibleTriangle> triangles,
                       std::span<AttributeSetup<Real>> setups, UncommonEdges& uncommon);

extern template void set_up_attributes(const FrameContext&, std::span<const VisibleTriangle>,
                                       std::span<AttributeSetup<double>>, UncommonEdges&);
extern template void set_up_attributes(const FrameContext&, std::span<const VisibleTriangle>,
                                       std::span<AttributeSetup<float>>, UncommonEdges&);

/// Whole repeats that are taken off a triangle's texture coordinates before they are interpolated, so that their
/// fractions keep their digits. 0 for a triangle without texture coordinates.
std::array<double, 2> whole_repeats(const FrameContext& context, std::uint32_t number);

/// The triangle's own normal in world space, from its winding, turned where others are: for places where the mesh gives
/// none. May be 0.
Double3 face_normal(const FrameContext& context, std::uint32_t number);

} // namespace refraster
