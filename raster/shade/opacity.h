#pragma once
// How much of a surface is there. Opacity decides visibility: it is read once, in double, at the pixel's centre, and
// all precisions go by that.

#include "raster/shade/shade_packet.h"

namespace refraster {

/// The opacity of a material that has a map for it, in any Number: as any other texture is read, at the pixel's centre,
/// where the triangle's plane is if it does not reach so far. 1 where the triangle has no texture coordinates.
template <class Data, class T = typename Data::Number>
T opacity(const Material& material, const Data& data) {
  const TextureMap& map = material.opacity_map;
  if (!data.may_have_texture_coordinates()) return T(1);
  UndefinedCounts uncounted; // of fragments that may not be seen
  const UndefinedTally<T> tally(uncounted, T(0) <= T(0));
  const PacketBarycentrics<T> at =
      needs_derivatives(map) ? barycentrics<Derivatives::yes>(data) : barycentrics<Derivatives::no>(data);
  return texture_colour(map, data, at, tally, SamplePlaced{}).x;
}

/// The opacity by which pixel (x, y) of the image is decided, of a triangle of that number in the frame, if its
/// material has a map for it.
double opacity_at(const FrameContext& context, std::uint32_t number, int x, int y);

} // namespace refraster
