#pragma once
// Phong and Blinn-Phong for many fragments at once, light by light and stage by stage: the directions, the highlights,
// the sum.
//
// A packet's formula in one piece needs more registers than there are, and each of its steps waits for the one before.
// A stage is short: a processor has several packets of it in flight, and what a stage does not need lies in memory.

#include "shading/blinn_phong.h"
#include "shading/light.h"
#include "shading/packet_batch.h"
#include "shading/phong.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace refraster::inline REFRASTER_KIT {

/// What is lit in stages.
template <class Function, class T>
concept LitInStages = Lanes<T> && NumberTraits<T>::has_lanes &&
    (std::same_as<Function, Phong> || std::same_as<Function, BlinnPhong>);

/// What the stages know of a packet under one light.
template <class T>
struct StagedLight {
  static constexpr std::size_t capacity = PacketBatch<T>::capacity;
  std::array<T, capacity> n_l, cosine, q; // q: half_squared_gap
  std::array<T, capacity> highlight;
  std::array<Rgb<T>, capacity> radiance; // of lights that do not shine alike everywhere
};

/// The directions: n.l, and the angle of the highlight if there is one.
template <bool has_highlight, class T, class Function, class Light>
[[gnu::flatten, gnu::noinline]] void stage_directions(const Function& function, double sharp, const Light& light,
                                                      PacketBatch<T>& batch, UndefinedCounts& counts,
                                                      StagedLight<T>& stages) {
  batch.template for_each<Maps::no>(counts, [&](std::size_t p, const Fragment<T>& at, const auto&) {
    const Incident<T> incident = arriving(light, at);
    if constexpr (!shines_evenly<Light>) {
      Rgb<T>& radiance = stages.radiance[p]; // by components: GCC 12 copies a vector in pieces of a register
      radiance.x = incident.radiance.x, radiance.y = incident.radiance.y, radiance.z = incident.radiance.z;
    }
    with_lobe(function, at, incident.direction, [&](const T& n_l, const Vec3<T>& a, const Vec3<T>& b, const auto& gap) {
      stages.n_l[p] = n_l;
      if constexpr (has_highlight) {
        const T q = half_squared_gap(a, b, sharp, gap);
        stages.q[p] = q;
        stages.cosine[p] = cosine_of(a, b, q);
      }
    });
  });
}

/// Counts what is undefined of a glossiness of 0.
template <class T, class Function, class Light>
[[gnu::noinline]] void note_zero_exponents(const Function& function, const Light& light, PacketBatch<T>& batch,
                                           UndefinedCounts& counts) {
  batch.template for_each<Maps::no>(counts, [&](std::size_t, const Fragment<T>& at, const auto&) {
    Fragment<T> uncounted = at;
    uncounted.tally = nullptr;
    with_lobe(function, uncounted, arriving(light, uncounted).direction,
              [&](const T&, const Vec3<T>& a, const Vec3<T>& b, const auto&) { note_zero_to_the_zero(at, a, b); });
  });
}

/// The highlights of `packets` angles.
template <class T>
[[gnu::flatten, gnu::noinline]] void stage_highlights(const CosineExponent<RealOf<T>>& exponent, int packets,
                                                      StagedLight<T>& stages) {
  const auto count = static_cast<std::size_t>(packets);
  if (exponent.whole == 0) {
    for (std::size_t p = 0; p < count; ++p)
      stages.highlight[p] = any_cosine_power<T>(stages.cosine[p], stages.q[p], exponent.s);
    return;
  }
  // As many as fill the gaps between the steps of one, and as there are registers for, 32 of 64 bytes or else 16. Two
  // of float are four of double.
  constexpr std::size_t at_once = sizeof(RealOf<T>) == 4 ? 2 : native_vector_bytes == 64 ? 8 : 4;
  for (std::size_t p = count; p % at_once != 0; ++p) stages.cosine[p] = T(0), stages.q[p] = T(0);
  for (std::size_t first = 0; first < count; first += at_once) {
    T power[at_once], q[at_once];
    for (std::size_t i = 0; i < at_once; ++i) power[i] = stages.cosine[first + i], q[i] = stages.q[first + i];
    raise_cosines(power, q, exponent);
    for (std::size_t i = 0; i < at_once; ++i) stages.highlight[first + i] = power[i];
  }
}

/// The sum; with `has_shadow` of a light whose shadow takes_light(). Textures and maps of the batch are those that
/// StagedLighting has made.
template <bool has_highlight, bool has_shadow, class T, class Light>
[[gnu::flatten, gnu::noinline]] void stage_sum(SpecularGate gate, const Light& light, const LightShadow& shadow,
                                               PacketBatch<T>& batch, const StagedLight<T>& stages) {
  for (int i = 0; i < batch.packets; ++i) {
    const auto p = static_cast<std::size_t>(i);
    Rgb<T> radiance;
    if constexpr (shines_evenly<Light>) radiance = as<T>(light.radiance);
    else radiance = stages.radiance[p];
    if constexpr (has_shadow) radiance = times_visibility(radiance, shadow, batch.fragment_of(p));
    const T n_l = stages.n_l[p], highlight = has_highlight ? gated(gate, n_l, stages.highlight[p]) : T(0);
    batch.sum[p] += diffuse_and_highlight(batch.surface[p].texture, batch.maps[p].specular, n_l, highlight, radiance);
  }
}

/// Adds lights to the sums of a batch. What is the same for all of them is computed once, and put in its place: the
/// texture of each surface is then the colour of its diffuse part, maps.specular that of its highlight, 0 without a
/// normal.
template <class Function, class T>
class StagedLighting {
public:
  template <Maps has_maps>
  StagedLighting(const Function& function, PacketBatch<T>& batch, std::integral_constant<Maps, has_maps>,
                 UndefinedCounts& counts)
      : function_(function), batch_(batch), counts_(counts), exponent_(cosine_exponent<RealOf<T>>(function.glossiness)),
        sharp_(sharp_gap(function.glossiness, plain_glossiness<Function>)), has_highlight_(function.ks != Double3(0)) {
    batch.template for_each<has_maps>(counts, [&](std::size_t p, const Fragment<T>& at, const auto&) {
      const Rgb<T> diffuse = diffuse_colour(function, at), specular = specular_colour(function, at);
      for (int c = 0; c < 3; ++c) {
        batch.surface[p].texture[c] = diffuse[c];
        batch.maps[p].specular[c] = where_normal(at, specular[c]);
      }
    });
  }

  template <class Light>
  void add(const Light& light, const LightShadow& shadow) const {
    if (has_highlight_) add<true>(light, shadow);
    else add<false>(light, shadow);
  }

private:
  template <bool has_highlight, class Light>
  void add(const Light& light, const LightShadow& shadow) const {
    if (has_highlight && exponent_.s == 0) [[unlikely]]
      note_zero_exponents(function_, light, batch_, counts_);
    StagedLight<T> stages;
    stage_directions<has_highlight>(function_, sharp_, light, batch_, counts_, stages);
    if constexpr (has_highlight) stage_highlights(exponent_, batch_.packets, stages);
    if (takes_light<T>(shadow)) [[unlikely]]
      stage_sum<has_highlight, true>(function_.specular_gate, light, shadow, batch_, stages);
    else stage_sum<has_highlight, false>(function_.specular_gate, light, shadow, batch_, stages);
  }

  const Function& function_;
  PacketBatch<T>& batch_;
  UndefinedCounts& counts_;
  CosineExponent<RealOf<T>> exponent_;
  double sharp_;
  bool has_highlight_;
};

} // namespace refraster::inline REFRASTER_KIT
