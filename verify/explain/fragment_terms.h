#pragma once
// The terms of a fragment in any Number, by the product's own formulas: in lanes as a frame has them, of which the
// first is looked at; or in a number without lanes.

#include "raster/shade/sample_data.h"
#include "raster/shade/shade_packet.h"
#include "raster/shade/shadow/tile_shadows.h"
#include "raster/shade/user_shading.h"
#include "shading/fragment_functions.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace refraster {

/// What one light gives.
template <class T>
struct LightTerm {
  Rgb<T> reflected{T(0)};
  UndefinedCounts undefined;
};

/// Everything of a fragment that is summed.
template <class T>
struct FragmentTerms {
  PacketSurface<T> surface;
  std::optional<FragmentMaps<T>> maps; // of a material that has any
  Rgb<T> ambient{T(0)};
  std::vector<LightTerm<T>> lights; // in the order of light_lists
  Rgb<T> radiance{T(0)};
  UndefinedCounts undefined; // all
  /// lights_seen(): of each light with a shadow, how much; and as many as lanes more.
  std::vector<double> seen;

  /// To the light that a fragment function sums, whose row with a shadow is that.
  LightVisibility visibility(std::size_t row = 0) const { return {seen.empty() ? nullptr : seen.data() + row, 1}; }
};

/// The first lane of x, rounded to double.
template <class T>
double plain(const T& x) {
  if constexpr (NumberTraits<T>::has_lanes) return static_cast<double>(x[0]);
  else return static_cast<double>(x);
}
template <class T>
Double3 plain(const Vec3<T>& x) {
  return {plain(x.x), plain(x.y), plain(x.z)};
}

/// The lanes that hold the fragment: the first.
template <class T>
MaskOf<T> first_lane() {
  if constexpr (NumberTraits<T>::has_lanes) return first_lanes<RealOf<T>, NumberTraits<T>::lanes>(1);
  else return T(0) <= T(0);
}

/// Calls body(data) with what raster/shade/interpolate.h reads of a triangle at (x, y), in subpixels of the window.
template <class T, class Body>
auto with_sample(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y, Body&& body) {
  if constexpr (NumberTraits<T>::has_lanes) {
    const VisibleTriangle triangle{TriangleFinder(context.scene, context.geometry).at(number), number};
    AttributeSetup<RealOf<T>> setup;
    UncommonEdges uncommon;
    set_up_attributes<RealOf<T>>(context, std::span(&triangle, 1), std::span(&setup, 1), uncommon);
    PacketList<T> packets;
    packets.add(setup, x, y, 1);
    return body(PacketData<T, Triangles::one>(packets.packet(0)));
  } else {
    SampleData<T> data(context, number);
    data.move_to(x, y);
    return body(data);
  }
}

/// The scene with no light but, if there is one, number `index` of list number `list`: for a function that adds them up
/// by itself.
inline Scene with_one_light(const Scene& scene, std::size_t list, std::size_t index) {
  Scene result;
  std::size_t place = 0;
  std::apply(
      [&](auto... each) {
        (
            [&] {
              if (place++ == list && index < (scene.*each).size()) (result.*each).push_back((scene.*each)[index]);
            }(),
            ...);
      },
      light_lists);
  return result;
}

/// Calls visit(light, list, index) with every light, in the order of the sum.
void for_each_light(const Scene& scene, auto&& visit) {
  std::size_t list = 0;
  for_each_light_list(scene, [&](const auto& lights) {
    for (std::size_t i = 0; i < lights.size(); ++i) visit(lights[i], list, i);
    ++list;
  });
}

/// Sums a surface's light as sum_light() does, and writes down what it sums.
template <class T, class Function>
void sum_terms(const Scene& scene, const Function& function, FragmentTerms<T>& terms) {
  const auto at = [&](const UndefinedTally<T>& tally) {
    const PacketSurface<T>& s = terms.surface;
    return Fragment<T>{s.position, s.normal, s.to_eye, s.texture, &tally, terms.maps ? &*terms.maps : nullptr};
  };
  const UndefinedTally<T> tally(terms.undefined, first_lane<T>());
  terms.ambient = ambient(function, at(tally));
  terms.radiance = terms.ambient;
  if (terms.maps) terms.radiance += terms.maps->emission;
  ShadowRows rows(terms.visibility());
  for_each_light(scene, [&](const auto& light, std::size_t, std::size_t) {
    LightTerm<T> term;
    const UndefinedTally<T> own(term.undefined, first_lane<T>());
    const Fragment<T> fragment = at(own);
    Incident<T> incident = arriving(within_range<T>(prepared_light(light)), fragment);
    if (const LightShadow shadow = rows.of(light); takes_light<T>(shadow))
      incident.radiance = times_visibility(incident.radiance, shadow, 0);
    term.reflected = reflected(function, fragment, incident);
    terms.radiance += term.reflected;
    terms.undefined += term.undefined;
    terms.lights.push_back(std::move(term));
  });
  terms.radiance = finite(terms.radiance, tally);
}

/// The same of a function whose formula is not known here. It tells sums only: a light's term is what it makes the sum
/// larger by where it is the only one.
template <class T>
void sum_terms(const Scene& scene, const UserFunction& function, FragmentTerms<T>& terms) {
  UserShading<T> shading;
  const auto radiance = [&](const Scene& lit, std::size_t first_row, UndefinedCounts& undefined) {
    PacketBatch<T> batch;
    batch.packets = 1;
    batch.visibility = terms.visibility(first_row);
    batch.surface[0] = terms.surface;
    batch.in_use[0] = first_lane<T>();
    shading.sum_light(lit, function, batch, undefined);
    return batch.sum[0];
  };
  UndefinedCounts without_light;
  terms.ambient = radiance(with_one_light(scene, 0, static_cast<std::size_t>(-1)), 0, without_light);
  std::size_t row = 0;
  for_each_light(scene, [&](const auto& light, std::size_t list, std::size_t index) {
    LightTerm<T> term;
    term.reflected = radiance(with_one_light(scene, list, index), row, term.undefined) - terms.ambient;
    terms.lights.push_back(std::move(term));
    row += light.shadow != Shadow::none;
  });
  terms.radiance = radiance(scene, 0, terms.undefined);
}

/// Calls visit(function) with what shades a material: its block of parameters, or a UserFunction.
void with_function(const Material& material, auto&& visit) {
  if (material.user_function) visit(*material.user_function);
  else std::visit(visit, material.fragment_function);
}

/// The terms of triangle `number` of the frame, at (x, y) in subpixels.
template <class T>
FragmentTerms<T> fragment_terms(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y) {
  const TriangleRef ref = TriangleFinder(context.scene, context.geometry).at(number);
  const Material& material = material_of(context.scene.objects[ref.object], ref.triangle);
  FragmentTerms<T> terms;
  const UndefinedTally<T> tally(terms.undefined, first_lane<T>());
  with_sample<T>(context, number, x, y, [&](const auto& data) {
    packet_surface(context, material, data, tally, terms.surface);
    if (material.has_fragment_maps()) terms.maps = fragment_maps(material, data, tally);
  });
  if (context.shadows) {
    terms.seen = lights_seen(context, number, x, y);
    terms.seen.resize(terms.seen.size() + static_cast<std::size_t>(NumberTraits<T>::lanes));
  }
  with_function(material, [&](const auto& function) { sum_terms(context.scene, function, terms); });
  return terms;
}

} // namespace refraster
