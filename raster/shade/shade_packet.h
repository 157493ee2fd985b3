#pragma once
// From interpolation to what shading starts from: a packet in lanes, or a single fragment in any Number.

#include "raster/shade/interpolate.h"
#include "shading/normal_map.h"
#include "shading/sum_light.h"
#include "shading/texture.h"

#include <algorithm>

namespace refraster {

/// The interpolated normal; where that is 0, the triangle's own; where that is 0 too, 0. Of any length.
template <class Data, class T = typename Data::Number>
Vec3<T> normal_of_any_length(const FrameContext& context, const Data& data, const Vec3<T>& interpolated,
                             const UndefinedTally<T>& tally) {
  const auto is_zero = [](const Vec3<T>& n) { return max(abs(n.x), max(abs(n.y), abs(n.z))) <= T(0); };
  const MaskOf<T> zero = is_zero(interpolated);
  if (!any(zero)) [[likely]]
    return interpolated;
  tally.note(Undefined::zero_normal, zero);
  const Vec3<T> own = data.own_normals(context);
  tally.note(Undefined::no_normal, zero & is_zero(own));
  return select<T>(zero, own, interpolated);
}
/// The same at unit length; where it is 0, 0.
template <class Data, class T = typename Data::Number>
Vec3<T> shading_normal(const FrameContext& context, const Data& data, const Vec3<T>& interpolated,
                       const UndefinedTally<T>& tally) {
  return normalize(normal_of_any_length(context, data, interpolated, tally));
}

/// Reads a texture as it is to be shown.
struct SampleTexture {
  template <class T>
  Rgb<T> operator()(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& right, const Vec2<T>& down) const {
    return sample(*map.texture, map.filter, uv, right, down);
  }
};
/// The same, wherever it is placed. Out of line: few packets ask for it.
struct SamplePlaced {
  template <class T>
  [[gnu::noinline]] Rgb<T> operator()(const TextureMap& map, const Vec2<T>& uv, const Vec2<T>& right,
                                      const Vec2<T>& down) const {
    return sample(map, uv, right, down);
  }
};

/// The colour of a texture that the material has; white where the triangle has no texture coordinates. Those are looked
/// for only where some are not finite, which those are not. read(map, uv, right, down) reads it, at a point and with
/// what that changes by for a pixel to the right and down, 0 unless the filter asks.
template <class Data, class Read = SampleTexture, class T = typename Data::Number>
Rgb<T> texture_colour(const TextureMap& map, const Data& data, const PacketBarycentrics<T>& at,
                      const UndefinedTally<T>& tally, const Read& read = {}) {
  const auto uv = [&](int c) { return interpolated_uv(data, c, at); };
  const Vec2<T> point(uv(0), uv(1));
  const auto finite = [](const T& x) { return abs(x) <= largest_number<T>(); };
  const MaskOf<T> bad = !(finite(point.x) & finite(point.y));
  Vec2<T> right(T(0)), down(T(0));
  if (map.filter == TextureFilter::trilinear) {
    const auto component = [&](int row, const Barycentric<T>& by) {
      const T change = changed(data.row(row), by);
      if constexpr (NumberTraits<T>::decides) return change;
      else return change + data.difference_error(row);
    };
    const auto change = [&](const Barycentric<T>& by) {
      return Vec2<T>(component(uv_row, by), component(uv_row + 1, by));
    };
    right = change(at.right);
    down = change(at.down);
    if constexpr (!NumberTraits<T>::decides) data.turn(right, down);
  }
  const Rgb<T> colour = read(map, point, right, down);
  if (!any(bad)) [[likely]]
    return colour;
  const MaskOf<T> none = without_uv(data);
  tally.note(Undefined::bad_uv, bad & !none);
  return select<T>(none, Rgb<T>(T(1)), colour);
}

/// What a trilinear filter reads wants to know how coordinates change.
inline bool needs_derivatives(const TextureMap& map) {
  return map.texture && map.filter == TextureFilter::trilinear;
}

/// The vertices' colour at the pixel's centre; white where the mesh has none. Out of line: few packets ask for it.
/// Beyond the triangle's edge, where the centre of a pixel lies of which only other samples are covered, it goes on as
/// it does inside, but not below 0.
template <class Data, class T = typename Data::Number>
[[gnu::noinline]] Rgb<T> vertex_colour(const FrameContext& context, const Data& data, const PacketBarycentrics<T>& at) {
  const Rgb<T> colour = attribute_value<&Mesh::colours>(context, data, at.at);
  return {max0(colour.x), max0(colour.y), max0(colour.z)};
}

/// The direction that the maps of a material say, in the frame of tangent, bitangent and normal; of a triangle without
/// texture coordinates that of the normal.
template <class Data, class T = typename Data::Number>
Vec3<T> map_direction(const Material& material, const Data& data, const PacketBarycentrics<T>& at,
                      const UndefinedTally<T>& tally) {
  const Vec3<T> unturned(T(0), T(0), T(1));
  if (!data.may_have_texture_coordinates()) return unturned;
  Vec3<T> m = unturned;
  if (material.normal_map.texture)
    m = map_normal(material, texture_colour(material.normal_map, data, at, tally, SamplePlaced{}));
  if (material.bump_map.texture) {
    const Rgb<T> rise = texture_colour(material.bump_map, data, at, tally, ReadSlopes{});
    const Double2 factors = slope_factors(material);
    m.x -= rise.x * as<T>(within_range<T>(factors.x)), m.y -= rise.y * as<T>(within_range<T>(factors.y));
  }
  return select<T>(without_uv(data), unturned, m);
}

/// n, unit, as the maps of a material turn it, whose mesh has tangents. Out of line: few packets ask for it.
/// Interpolates once more, as fragment_maps().
template <class Data, class T = typename Data::Number>
[[gnu::noinline]] Vec3<T> mapped_normal(const FrameContext& context, const Material& material, const Data& data,
                                        const Vec3<T>& n, const UndefinedTally<T>& tally) {
  const PacketBarycentrics<T> at = needs_derivatives(material.normal_map) || needs_derivatives(material.bump_map)
                                       ? barycentrics<Derivatives::yes>(data)
                                       : barycentrics<Derivatives::no>(data);
  MaskOf<T> usable;
  const Vec3<T> turned = turned_normal(n, attribute_value<&Mesh::tangents>(context, data, at.at),
                                       map_direction(material, data, at, tally), usable);
  tally.note(Undefined::zero_normal, !usable);
  return turned;
}

/// Whether maps turn normals of this material on this object's mesh.
inline bool turns_normals(const FrameContext& context, const Material& material, std::uint32_t object) {
  return context.uses.tangents && material.turns_normals() && !context.scene.objects[object].mesh->tangents.empty();
}

// What every fragment of a material starts from comes in three steps, so that each may be taken for many packets before
// the next: what one packet waits for, roots and quotients above all, another fills the time of.

/// The first step: what triangles bring. The normal is of any length, and the direction to the eye is not there yet.
template <class Data, class T = typename Data::Number>
void interpolate_surface(const FrameContext& context, const Material& material, const Data& data,
                         const UndefinedTally<T>& tally, PacketSurface<T>& surface) {
  const TextureMap& base = material.diffuse_map;
  const PacketBarycentrics<T> at =
      needs_derivatives(base) ? barycentrics<Derivatives::yes>(data) : barycentrics<Derivatives::no>(data);
  surface.position = attribute_value<&Mesh::positions>(context, data, at.at);
  surface.normal = normal_of_any_length(context, data, attribute_value<&Mesh::normals>(context, data, at.at), tally);
  const bool shows_texture = base.texture && data.may_have_texture_coordinates();
  if (!shows_texture) surface.texture = Rgb<T>(T(1));
  else if (!context.uses.placed_textures) [[likely]] surface.texture = texture_colour(base, data, at, tally);
  else surface.texture = texture_colour(base, data, at, tally, SamplePlaced{});
  if (context.uses.vertex_colours) [[unlikely]]
    surface.texture = surface.texture * vertex_colour(context, data, at);
}

/// The second step: the normal at unit length, and the direction to the eye.
template <class T>
void normalize_surface(const Vec3<T>& eye, const UndefinedTally<T>& tally, PacketSurface<T>& surface) {
  surface.normal = normalize(surface.normal);
  surface.to_eye = normalize(eye - surface.position);
  tally.note(Undefined::eye_at_surface, dot(surface.to_eye, surface.to_eye) <= T(0));
}

/// The third step, for a material and an object of which turns_normals() is true.
template <class Data, class T = typename Data::Number>
void map_surface(const FrameContext& context, const Material& material, const Data& data,
                 const UndefinedTally<T>& tally, PacketSurface<T>& surface) {
  surface.normal = mapped_normal(context, material, data, surface.normal, tally);
}

/// All three for one packet.
template <class Data, class T = typename Data::Number>
void packet_surface(const FrameContext& context, const Material& material, const Data& data,
                    const UndefinedTally<T>& tally, PacketSurface<T>& surface) {
  interpolate_surface(context, material, data, tally, surface);
  normalize_surface(as<T>(context.scene.camera.position), tally, surface);
  if (turns_normals(context, material, data.object())) [[unlikely]]
    map_surface(context, material, data, tally, surface);
}

/// What further textures of a material say of the same fragments: of one with has_fragment_maps(). Of coordinates that
/// are not finite each texture counts. Out of line: few materials have them. Interpolates once more, by the same
/// operations: to a bounds number, whose symbols are those of the first time, these are the same numbers.
template <class Data, class T = typename Data::Number, class Read = SamplePlaced>
[[gnu::noinline]] FragmentMaps<T> fragment_maps(const Material& material, const Data& data,
                                                const UndefinedTally<T>& tally, const Read& read = {}) {
  const bool derivatives = std::any_of(texture_slots.begin(), texture_slots.end(), [&](const TextureSlot& slot) {
    return slot.use == SlotUse::colours && slot.map != &Material::diffuse_map && needs_derivatives(material.*slot.map);
  });
  const PacketBarycentrics<T> at =
      derivatives ? barycentrics<Derivatives::yes>(data) : barycentrics<Derivatives::no>(data);
  const auto colour = [&](const TextureMap& map) {
    return map.texture && data.may_have_texture_coordinates() ? texture_colour(map, data, at, tally, read)
                                                              : Rgb<T>(T(1));
  };
  Rgb<T> specular;
  if (material.microfacets()) specular = {T(1), colour(material.roughness_map).x, colour(material.metallic_map).x};
  else specular = colour(material.specular_map);
  return {specular, as<T>(within_range<T>(material.emissive)) * colour(material.emissive_map)};
}

} // namespace refraster
