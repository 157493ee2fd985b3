#pragma once
// From a packet of fragments of tiny triangles to what shading starts from.

#include "raster/shade/shade_packet.h"
#include "raster/shade/tiny/tiny_fragments.h"
#include "raster/shade/tiny/vertex_data.h"

#include <array>

namespace refraster {

/// Calls body(data) with the packet's triangles by records after all: where VertexData cannot say what they are. Out of
/// line: few packets ask for it.
template <class T, class Body>
[[gnu::noinline]] void with_records(const FrameContext& context, const TinyPacket<T>& tiny, const Body& body) {
  constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  std::array<VisibleTriangle, lanes> triangles;
  TriangleFinder finder(context.scene, context.geometry);
  for (std::size_t lane = 0; lane < lanes; ++lane) triangles[lane] = {finder.at(tiny.number[lane]), tiny.number[lane]};
  std::array<AttributeSetup<Real>, lanes> setups;
  UncommonEdges uncommon;
  set_up_attributes<Real>(context, triangles, setups, uncommon);
  PacketList<T> packets;
  for (int lane = 0; lane < tiny.count; ++lane)
    packets.add(setups[static_cast<std::size_t>(lane)], tiny.x[lane], tiny.y[lane], 1);
  body(PacketData<T, Triangles::many>(packets.packet(0)));
}

/// packet_surface() of the packet. Everything that it needs is inlined here: no call in between.
template <class T>
[[gnu::flatten, gnu::noinline]] void tiny_surface(const FrameContext& context, const Material& material,
                                                  const VertexNeeds& needs, const TinyPacket<T>& packet,
                                                  const UndefinedTally<T>& tally, PacketSurface<T>& surface) {
  const VertexData<T> data(context, packet, needs);
  const auto of = [&](const auto& some_data) { packet_surface(context, material, some_data, tally, surface); };
  if (!data.fits()) [[unlikely]]
    with_records(context, packet, of);
  else of(data);
}

/// fragment_maps() of the packet, whose vertices are read once more.
template <class T>
[[gnu::noinline]] FragmentMaps<T> tiny_maps(const FrameContext& context, const Material& material,
                                            const VertexNeeds& needs, const TinyPacket<T>& packet,
                                            const UndefinedTally<T>& tally) {
  FragmentMaps<T> maps;
  const VertexData<T> data(context, packet, needs);
  const auto of = [&](const auto& some_data) { maps = fragment_maps(material, some_data, tally); };
  if (!data.fits()) [[unlikely]]
    with_records(context, packet, of);
  else of(data);
  return maps;
}

} // namespace refraster
