#pragma once
// From a surface to its radiance: the ambient term, then light by light, for many fragments of one material.

#include <refraster/material.h>

#include "math/constants.h"
#include "shading/light.h"
#include "shading/light_spans.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <variant>

namespace refraster::inline REFRASTER_KIT {

/// What is known of a fragment, or one a lane, before any light is considered.
template <class T>
struct PacketSurface {
  Vec3<T> position, normal, to_eye; // normal and to_eye unit, or 0
  Rgb<T> texture;
};

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

/// Whether fragments have FragmentMaps. Known to the compiler, so that those without pay for nothing.
enum class Maps { no, yes };

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
  std::array<MaskOf<T>, capacity> in_use;     // lanes that hold a fragment
  std::array<FragmentMaps<T>, capacity> maps; // set, and read, only with Maps::yes

  template <Maps has_maps, class Body>
  void for_each(UndefinedCounts& counts, Body&& body) {
    for (int i = 0; i < packets; ++i) {
      const auto p = static_cast<std::size_t>(i);
      const PacketSurface<T>& s = surface[p];
      const UndefinedTally<T> tally(counts, in_use[p]);
      const FragmentMaps<T>* const further = has_maps == Maps::yes ? &maps[p] : nullptr;
      body(sum[p], Fragment<T>{s.position, s.normal, s.to_eye, s.texture, &tally, further}, tally);
    }
  }
};

/// Radiance toward the eye, into batch.sum: the ambient term, light of its own, then light by light, summed in this
/// order; finite.
template <Maps has_maps = Maps::no, class T, class Function>
void sum_light(const LightSpans& lights, const Function& function, PacketBatch<T>& batch, UndefinedCounts& counts) {
  Function copy = function; // nothing that is written below can be part of it
  if constexpr (NumberTraits<T>::largest < std::numeric_limits<double>::max())
    Function::fields(copy, [](auto&&, auto& value, auto&&...) {
      if constexpr (requires { value = within_range<T>(value); }) value = within_range<T>(value);
    });
  const Function& here = copy;
  batch.template for_each<has_maps>(counts, [&](Rgb<T>& sum, const Fragment<T>& at, const auto&) {
    sum = ambient(here, at);
    if constexpr (has_maps == Maps::yes) sum += at.maps->emission;
  });
  const auto add = [&](const auto& of_one_type) {
    for (const auto& light : of_one_type) {
      const auto prepared = within_range<T>(prepared_light(light));
      batch.template for_each<has_maps>(counts, [&](Rgb<T>& sum, const Fragment<T>& at, const auto&) {
        sum += reflected(here, at, arriving(prepared, at));
      });
    }
  };
  std::apply([&](const auto&... list) { (add(list), ...); }, lights);
  batch.template for_each<Maps::no>(
      counts, [](Rgb<T>& sum, const Fragment<T>&, const UndefinedTally<T>& tally) { sum = finite(sum, tally); });
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
        if constexpr (std::is_base_of_v<PhongParameters, Function>)
          if (material.has_fragment_maps()) return visit(std::integral_constant<Maps, Maps::yes>{}, function);
        visit(std::integral_constant<Maps, Maps::no>{}, function);
      },
      material.fragment_function);
}

/// The colour a surface would be called by: what it reflects of white light from the front. For a function with `kd`,
/// kd times the texture; for others f at normal incidence and exitance, times pi: for a Lambertian surface, its
/// reflectance.
template <class T, class Function>
Rgb<T> albedo(const Function& function, const Rgb<T>& texture) {
  if constexpr (requires { as<T>(function.kd); }) {
    return as<T>(function.kd) * texture;
  } else {
    const Vec3<T> up(T(0), T(0), T(1));
    const Fragment<T> at{up, up, up, Rgb<T>(T(1)), nullptr};
    return reflected(function, at, Incident<T>{up, Rgb<T>(constant<T>(constants::pi))});
  }
}

} // namespace refraster::inline REFRASTER_KIT
