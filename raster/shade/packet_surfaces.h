#pragma once
// The surfaces of a list of packets: what their shading starts from.

#include "raster/shade/packets.h"
#include "raster/shade/shade_packet.h"

namespace refraster {

/// What the steps of raster/shade/shade_packet.h read and write.
template <class T>
struct PacketSurfaces {
  const FrameContext& context;
  const Material& material;
  const PacketList<T>& packets;
  PacketBatch<T>& batch;
  UndefinedCounts& undefined;

  /// Calls body(i, packet, tally) for packets [begin, end).
  template <class Body>
  void for_each(int begin, int end, const Body& body) const {
    for (int i = begin; i < end; ++i) {
      const auto at = static_cast<std::size_t>(i);
      body(at, packets.packet(i), UndefinedTally<T>(undefined, batch.in_use[at]));
    }
  }
};

// Everything that a packet needs is inlined here: no call, and no vector in memory, in between.
template <Triangles triangles, Edges edges, class T>
[[gnu::flatten, gnu::noinline]] void interpolate_packets(const PacketSurfaces<T>& all, int begin, int end) {
  all.for_each(begin, end, [&](std::size_t i, const Packet<T>& packet, const auto& tally) {
    interpolate_surface(all.context, all.material, PacketData<T, triangles, edges>(packet), tally,
                        all.batch.surface[i]);
  });
}

template <class T>
[[gnu::flatten, gnu::noinline]] void normalize_packets(const PacketSurfaces<T>& all) {
  const Vec3<T> eye = as<T>(all.context.scene.camera.position);
  all.for_each(0, all.batch.packets, [&](std::size_t i, const Packet<T>&, const auto& tally) {
    normalize_surface(eye, tally, all.batch.surface[i]);
  });
}

/// Fills `batch`, but for batch.sum and batch.first_fragment. The packets are of one object.
template <Maps maps, class T>
void make_surfaces(const FrameContext& context, const Material& material, const PacketList<T>& packets,
                   UndefinedCounts& undefined, PacketBatch<T>& batch) {
  static_assert(PacketList<T>::capacity == PacketBatch<T>::capacity);
  const PacketSurfaces<T> all{context, material, packets, batch, undefined};
  const int count = batch.packets = packets.packets();
  for (int i = 0; i < count; ++i)
    batch.in_use[static_cast<std::size_t>(i)] = first_lanes<RealOf<T>, NumberTraits<T>::lanes>(packets.packet(i).count);

  // By stretches of packets of which the same is known.
  for (int begin = 0, end = 0; begin < count; begin = end) {
    const Packet<T> first = packets.packet(begin);
    end = packets.stretch_end(begin);
    if (first.triangles == Triangles::many) interpolate_packets<Triangles::many, Edges::any>(all, begin, end);
    else if (first.edges == EdgeKind::wrapped) interpolate_packets<Triangles::one, Edges::wrapped>(all, begin, end);
    else interpolate_packets<Triangles::one, Edges::any>(all, begin, end);
  }
  normalize_packets(all);

  using Any = PacketData<T, Triangles::many>;
  if (turns_normals(context, material, packets.packet(0).triangle(0).object)) [[unlikely]]
    all.for_each(0, count, [&](std::size_t i, const Packet<T>& packet, const auto& tally) {
      map_surface(context, material, Any(packet), tally, batch.surface[i]);
    });
  if constexpr (maps == Maps::yes)
    all.for_each(0, count, [&](std::size_t i, const Packet<T>& packet, const auto& tally) {
      batch.maps[i] = fragment_maps(material, Any(packet), tally);
    });
}

} // namespace refraster
