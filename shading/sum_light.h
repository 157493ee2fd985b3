#pragma once
// From a surface to its radiance: the ambient term, then light by light, for many fragments of one material.

#include <refraster/material.h>

#include "math/constants.h"
#include "shading/light.h"
#include "shading/light_spans.h"
#include "shading/packet_batch.h"
#include "shading/staged_lighting.h"

#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <variant>

namespace refraster::inline REFRASTER_KIT {

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

/// Radiance toward the eye, into batch.sum: the ambient term, light of its own, then light by light, summed in this
/// order; finite. Uses up textures and maps of the batch.
template <Maps has_maps = Maps::no, class T, class Function>
void sum_light(const LightSpans& lights, const Function& function, PacketBatch<T>& batch, UndefinedCounts& counts) {
  Function copy = function; // nothing that is written below can be part of it
  if constexpr (NumberTraits<T>::largest < std::numeric_limits<double>::max())
    Function::fields(copy, [](auto&&, auto& value, auto&&...) {
      if constexpr (requires { value = within_range<T>(value); }) value = within_range<T>(value);
    });
  const Function& here = copy;
  batch.template for_each<has_maps>(counts, [&](std::size_t p, const Fragment<T>& at, const auto&) {
    batch.sum[p] = ambient(here, at);
    if constexpr (has_maps == Maps::yes) batch.sum[p] += at.maps->emission;
  });
  const auto lighting = [&] {
    if constexpr (LitInStages<Function, T>)
      return StagedLighting<Function, T>(here, batch, std::integral_constant<Maps, has_maps>{}, counts);
    else return nullptr;
  }();
  ShadowRows rows(batch.visibility);
  const auto add = [&](const auto& of_one_type) {
    for (const auto& light : of_one_type) {
      const LightShadow shadow = rows.of(light);
      const auto prepared = evenly_attenuated<T>(within_range<T>(prepared_light(light)));
      if constexpr (LitInStages<Function, T>) {
        lighting.add(prepared, shadow);
      } else {
        batch.template for_each<has_maps>(counts, [&](std::size_t p, const Fragment<T>& at, const auto&) {
          Incident<T> incident = arriving(prepared, at);
          if (takes_light<T>(shadow)) [[unlikely]]
            incident.radiance = times_visibility(incident.radiance, shadow, batch.fragment_of(p));
          batch.sum[p] += reflected(here, at, incident);
        });
      }
    }
  };
  std::apply([&](const auto&... list) { (add(list), ...); }, lights);
  batch.template for_each<Maps::no>(counts, [&](std::size_t p, const Fragment<T>&, const UndefinedTally<T>& tally) {
    batch.sum[p] = finite(batch.sum[p], tally);
  });
}

/// The same for lanes: one piece of code, without a call.
template <Maps has_maps = Maps::no, class T, class Function>
[[gnu::flatten, gnu::noinline]] void add_light(const LightSpans& lights, const Function& function,
                                               PacketBatch<T>& batch, UndefinedCounts& counts) {
  sum_light<has_maps>(lights, function, batch, counts);
}

/// Calls visit(maps, function) with a material's fragment function and, as a constant, whether its fragments have maps.
void with_maps(const Material& material, auto&& visit) {
  std::visit(
      [&]<class Function>(const Function& function) {
        if constexpr (std::is_base_of_v<PhongParameters, Function> || std::is_same_v<Function, Microfacet>)
          if (material.has_fragment_maps()) return visit(std::integral_constant<Maps, Maps::yes>{}, function);
        visit(std::integral_constant<Maps, Maps::no>{}, function);
      },
      material.fragment_function);
}

/// The colour a surface would be called by: what it reflects of white light from the front. For a function with `kd`,
/// kd times the texture; for one with `base_color`, that times the texture; for others f at normal incidence and
/// exitance, times pi: for a Lambertian surface, its reflectance.
template <class T, class Function>
Rgb<T> albedo(const Function& function, const Rgb<T>& texture) {
  if constexpr (requires { as<T>(function.kd); }) {
    return as<T>(function.kd) * texture;
  } else if constexpr (requires { as<T>(function.base_color); }) {
    return as<T>(function.base_color) * texture;
  } else {
    const Vec3<T> up(T(0), T(0), T(1));
    const Fragment<T> at{up, up, up, Rgb<T>(T(1)), nullptr};
    return reflected(function, at, Incident<T>{up, Rgb<T>(constant<T>(constants::pi))});
  }
}

} // namespace refraster::inline REFRASTER_KIT
