#pragma once
// What a triangle's corners bring to interpolation, before it is rounded to any precision.

#include "math/vec.h"
#include "raster/shade/attribute_setup.h"
#include "raster/vertex/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace refraster {

/// Values of edge functions are 0 or lie between 1 and 2^52: from this weight on no product of the two is subnormal, so
/// that scaling by a power of two, as in a packet that holds a projective triangle, changes no digit. A corner that is
/// farther yet counts as this far: where the nearest one has a part, it is none to speak of; and on the edge opposite
/// the nearest one, where that has none, something must be left.
template <class Real>
inline constexpr double min_weight = sizeof(Real) == 4 ? 0x1p-70 : 0x1p-900;

/// Normals count by their direction only. A power of two, common to the corners, keeps differences of huge ones in the
/// range of a float precision, and tiny ones above its end; normals of ordinary size stay as they are: with a greatest
/// component from 1 / ordinary_normal to ordinary_normal. `size`: the greatest components of the three.
inline constexpr double ordinary_normal = 1 << 20;
[[gnu::always_inline]] inline double normal_scale(const std::array<double, 3>& size) {
  const auto is_ordinary = [](double s) { return s >= 1 / ordinary_normal && s <= ordinary_normal; };
  if (is_ordinary(size[0]) && is_ordinary(size[1]) && is_ordinary(size[2])) return 1;
  return min(reciprocal_binade(size[0]), min(reciprocal_binade(size[1]), reciprocal_binade(size[2])));
}
[[gnu::always_inline]] inline double normal_scale(const WorldVertex& v0, const WorldVertex& v1, const WorldVertex& v2) {
  const auto size = [](const Double3& n) { return max(abs(n.x), max(abs(n.y), abs(n.z))); };
  return normal_scale({size(v0.normal), size(v1.normal), size(v2.normal)});
}

/// What a corner brings of an attribute, in world space. `vertex`: in the mesh.
template <class Value>
std::array<double, static_cast<std::size_t>(Value::length())>
corner_value(const Mesh& mesh, const ObjectTransform& transform, const VertexAttribute<Value>& attribute,
             std::uint32_t vertex) {
  std::array<double, static_cast<std::size_t>(Value::length())> result;
  const std::vector<Value>& values = mesh.*attribute.values;
  const Value value = vertex < values.size() ? values[vertex] : Value(attribute.otherwise);
  for (std::size_t c = 0; c < result.size(); ++c) result[c] = static_cast<double>(value[static_cast<glm::length_t>(c)]);
  if constexpr (Value::length() >= 3) {
    Double3 xyz(result[0], result[1], result[2]);
    if (attribute.transformed == Transformed::as_position) xyz = Double3(transform.world_from_object * Double4(xyz, 1));
    if (attribute.transformed == Transformed::as_normal) xyz = transform.world_from_normal * xyz;
    if (attribute.transformed == Transformed::as_tangent) xyz = normalize(Double3x3(transform.world_from_object) * xyz);
    for (std::size_t c = 0; c < 3; ++c) result[c] = xyz[static_cast<glm::length_t>(c)];
  }
  if constexpr (Value::length() == 4)
    if (attribute.transformed == Transformed::as_tangent) result[3] *= transform.handedness;
  return result;
}

/// Calls body(first row, values of the three corners) with each attribute that the mesh has beyond texture coordinates.
void for_each_further_attribute(const Mesh& mesh, const ObjectTransform& transform,
                                const std::array<std::uint32_t, 3>& vertices, auto&& body) {
  for_each_attribute_row([&](const auto& attribute, int row) {
    if (row <= uv_row || (mesh.*attribute.values).empty()) return;
    const auto value = [&](std::size_t k) { return corner_value(mesh, transform, attribute, vertices[k]); };
    body(row, std::array{value(0), value(1), value(2)});
  });
}

/// Whether whole repeats of texture coordinates are taken off before they are interpolated: not where a texture of the
/// triangle's is not at each of them the same.
enum class Repeats { taken_off, kept };
inline Repeats repeats_of(const FrameContext& context, std::uint32_t object, std::uint32_t triangle) {
  if (!context.uses.placed_textures) return Repeats::taken_off;
  const Material& material = material_of(context.scene.objects[object], triangle);
  return any_texture(material, [](const TextureMap& map) { return map.is_placed(); }) ? Repeats::kept
                                                                                      : Repeats::taken_off;
}

/// Component c of the corners' texture coordinates, without whole repeats.
struct UvComponent {
  std::array<double, 3> value;
  double whole = 0;
};
inline UvComponent uv_component(const Mesh& mesh, const std::array<std::uint32_t, 3>& vertices, int c,
                                Repeats repeats) {
  UvComponent uv;
  for (std::size_t k = 0; k < 3; ++k) uv.value[k] = static_cast<double>(mesh.uvs[vertices[k]][c]);
  const double least = std::min({uv.value[0], uv.value[1], uv.value[2]});
  uv.whole = abs(least) < 1e300 ? std::floor(least) : 0; // only a finite uv has whole repeats
  // Exact: uv is a float and the difference of two doubles this close to it. Small negative ones stay as they are.
  if ((least > -1 && least < 1) || repeats == Repeats::kept) uv.whole = 0;
  for (double& value : uv.value) value -= uv.whole;
  return uv;
}

/// The same as interpolation takes it: the value at the anchor and the differences to the other two, taken in double
/// before they are rounded; the least and the greatest of the three. Without texture coordinates the anchor's is NaN, so
/// that every one that is interpolated is, and the least is 1 and the greatest 0, so that it is known for what it is.
template <class Real>
struct AttributeUv {
  std::array<Real, 3> value{std::numeric_limits<Real>::quiet_NaN(), Real(0), Real(0)};
  Real least = 1, greatest = 0;
};
/// `triangle`: its vertices in the mesh, as submitted; `corner`: which of them stands at each place.
template <class Real>
[[gnu::always_inline]] inline AttributeUv<Real> attribute_uv(const Mesh& mesh,
                                                             const std::array<std::uint32_t, 3>& triangle,
                                                             const std::array<std::uint8_t, 3>& corner, int c,
                                                             Repeats repeats) {
  if (!has_uvs(mesh, triangle)) return {};
  const auto uv = uv_component(mesh, {triangle[corner[0]], triangle[corner[1]], triangle[corner[2]]}, c, repeats).value;
  return {{static_cast<Real>(uv[0]), static_cast<Real>(uv[1] - uv[0]), static_cast<Real>(uv[2] - uv[0])},
          static_cast<Real>(std::min({uv[0], uv[1], uv[2]})),
          static_cast<Real>(std::max({uv[0], uv[1], uv[2]}))};
}

} // namespace refraster
