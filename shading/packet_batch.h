#pragma once
// Fragments of one material that are lit together.

#include "shading/fragment.h"
#include "shading/light_visibility.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace refraster::inline REFRASTER_KIT {

/// What is known of a fragment, or one a lane, before any light is considered.
template <class T>
struct PacketSurface {
  Vec3<T> position, normal, to_eye; // normal and to_eye unit, or 0
  Rgb<T> texture;
};

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
  std::array<FragmentMaps<T>, capacity> maps; // with Maps::yes; specular too while lit in stages
  LightVisibility visibility;                 // of its fragments, the first packet's first; of scenes with shadows

  /// Which of them a packet begins with.
  static std::size_t fragment_of(std::size_t packet) {
    return packet * static_cast<std::size_t>(NumberTraits<T>::lanes);
  }

  /// body(p, fragment, tally) for each packet p.
  template <Maps has_maps, class Body>
  void for_each(UndefinedCounts& counts, Body&& body) {
    for (int i = 0; i < packets; ++i) {
      const auto p = static_cast<std::size_t>(i);
      const PacketSurface<T>& s = surface[p];
      const UndefinedTally<T> tally(counts, in_use[p]);
      const FragmentMaps<T>* const further = has_maps == Maps::yes ? &maps[p] : nullptr;
      body(p, Fragment<T>{s.position, s.normal, s.to_eye, s.texture, &tally, further}, tally);
    }
  }
};

} // namespace refraster::inline REFRASTER_KIT
