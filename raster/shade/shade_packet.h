#pragma once
// Fragments of one material, a packet in lanes or a single one in any Number: interpolate, light, sum.

#include "raster/shade/interpolate.h"
#include "shading/fragment_functions.h"
#include "shading/light.h"
#include "shading/texture.h"

#include <array>
#include <limits>

namespace refraster {

/// What the fragment stage knows of a packet before any light is considered.
template <class T>
struct PacketSurface {
  Vec3<T> position, normal, to_eye; // normal and to_eye unit, or 0
  Rgb<T> texture;
};

/// The interpolated normal at unit length; where that is 0, the triangle's own; where that is 0 too, 0.
template <class Data, class T = typename Data::Number>
Vec3<T> shading_normal(const FrameContext& context, const Data& data, const Vec3<T>& interpolated,
                       const UndefinedTally<T>& tally) {
  const auto is_zero = [](const Vec3<T>& n) { return max(abs(n.x), max(abs(n.y), abs(n.z))) <= T(0); };
  const MaskOf<T> zero = is_zero(interpolated);
  if (!any(zero)) return normalize(interpolated);
  tally.note(Undefined::zero_normal, zero);
  const Vec3<T> own = data.own_normals(context);
  tally.note(Undefined::no_normal, zero & is_zero(own));
  return normalize(select<T>(zero, own, interpolated));
}

/// The texture's colour; white where the triangle has no texture coordinates. Those are looked for only where some are
/// not finite, which those are not.
template <class Data, class T = typename Data::Number>
Rgb<T> texture_colour(const Material& material, const Data& data, const PacketBarycentrics<T>& at,
                      const UndefinedTally<T>& tally) {
  const auto uv = [&](int c) { return interpolated_uv(data, c, at); };
  const Vec2<T> point(uv(0), uv(1));
  const auto finite = [](const T& x) { return abs(x) <= largest_number<T>(); };
  const MaskOf<T> bad = !(finite(point.x) & finite(point.y));
  Vec2<T> right(T(0)), down(T(0));
  if (material.texture_filter == TextureFilter::trilinear) {
    const auto change = [&](const Barycentric<T>& by) {
      const int first = static_cast<int>(Attribute::uv);
      return Vec2<T>(changed(data.row(first), by), changed(data.row(first + 1), by));
    };
    right = change(at.right);
    down = change(at.down);
  }
  const Rgb<T> colour = sample(*material.texture, material.texture_filter, point, right, down);
  if (!any(bad)) [[likely]]
    return colour;
  const MaskOf<T> none = without_uv(data);
  tally.note(Undefined::bad_uv, bad & !none);
  return select<T>(none, Rgb<T>(T(1)), colour);
}

template <class Data, class T = typename Data::Number>
PacketSurface<T> packet_surface(const FrameContext& context, const Material& material, const Data& data,
                                const UndefinedTally<T>& tally) {
  const bool derivatives = material.texture && material.texture_filter == TextureFilter::trilinear;
  const PacketBarycentrics<T> at =
      derivatives ? barycentrics<Derivatives::yes>(data) : barycentrics<Derivatives::no>(data);
  PacketSurface<T> surface;
  surface.position = interpolated3(data, Attribute::position, at.at);
  surface.normal = shading_normal(context, data, interpolated3(data, Attribute::normal, at.at), tally);
  surface.to_eye = normalize(as<T>(context.scene.camera.position) - surface.position);
  tally.note(Undefined::eye_at_surface, dot(surface.to_eye, surface.to_eye) <= T(0));
  const bool shows_texture = material.texture && data.may_have_texture_coordinates();
  surface.texture = shows_texture ? texture_colour(material, data, at, tally) : Rgb<T>(T(1));
  return surface;
}

/// x where it is finite; the largest finite number of its sign for an infinity; 0 for NaN.
template <class T>
T finite(const T& x, const UndefinedTally<T>& tally) {
  const T most = largest_number<T>();
  tally.note(Undefined::not_finite, !(abs(x) <= most));
  const T kept = min(max(x, -most), most);
  return select((x > T(0)) | (x <= T(0)), kept, T(0));
}

template <class T>
Rgb<T> finite(const Rgb<T>& rgb, const UndefinedTally<T>& tally) {
  const T sum = abs(rgb.x) + abs(rgb.y) + abs(rgb.z);
  if (!any(!(sum <= largest_number<T>()))) return rgb; // nearly always
  return {finite(rgb.x, tally), finite(rgb.y, tally), finite(rgb.z, tally)};
}

/// Packets of one material that go through shading together, light by light. What a formula computes for one packet
/// waits for itself, step by step; the next packet's does not wait for it, and fills the gaps. And what is the same for
/// all packets is prepared once.
template <class T>
struct PacketBatch {
  static constexpr int capacity = 16; // what lies in here stays in the first-level cache
  int packets = 0;
  std::uint32_t first_fragment = 0;
  std::array<PacketSurface<T>, capacity> surface;
  std::array<Rgb<T>, capacity> sum;
  std::array<MaskOf<T>, capacity> in_use; // lanes that hold a fragment

  template <class Body>
  void for_each(UndefinedCounts& counts, Body&& body) {
    for (int i = 0; i < packets; ++i) {
      const auto p = static_cast<std::size_t>(i);
      const PacketSurface<T>& s = surface[p];
      const UndefinedTally<T> tally(counts, in_use[p]);
      body(sum[p], Fragment<T>{s.position, s.normal, s.to_eye, s.texture, &tally}, tally);
    }
  }
};

/// Radiance toward the eye, into batch.sum: the ambient term, then point lights and direction lights, summed in the
/// order of the scene.
template <class T, class SomeFunction>
void sum_light(const Scene& scene, const SomeFunction& function, PacketBatch<T>& batch, UndefinedCounts& counts) {
  SomeFunction copy = function; // nothing that is written below can be part of it
  if constexpr (NumberTraits<T>::largest < std::numeric_limits<double>::max())
    SomeFunction::fields(copy, [](auto&&, auto& value, auto&&...) {
      if constexpr (requires { value = within_range<T>(value); }) value = within_range<T>(value);
    });
  const SomeFunction& here = copy;
  batch.for_each(counts, [&](Rgb<T>& sum, const Fragment<T>& at, const auto&) { sum = here.ambient(at); });
  const auto add = [&](const auto& lights) {
    for (const auto& light : lights) {
      const auto prepared = within_range<T>(prepared_light(light));
      batch.for_each(counts,
                     [&](Rgb<T>& sum, const Fragment<T>& at, const auto&) { sum += here(at, arriving(prepared, at)); });
    }
  };
  add(scene.point_lights);
  add(scene.direction_lights);
  batch.for_each(counts,
                 [](Rgb<T>& sum, const Fragment<T>&, const UndefinedTally<T>& tally) { sum = finite(sum, tally); });
}

/// The same for lanes: one piece of code, without a call.
template <class T, class SomeFunction>
[[gnu::flatten, gnu::noinline]] void add_light(const Scene& scene, const SomeFunction& function, PacketBatch<T>& batch,
                                               UndefinedCounts& counts) {
  sum_light(scene, function, batch, counts);
}

} // namespace refraster
