#pragma once
// A frame's stages before its tiles are drawn.

#include "raster/visibility/bin.h"

namespace refraster {

/// The vertices and lists that a frame of `input` is drawn from.
struct BinnedGeometry {
  Geometry geometry;
  Bins bins;
  FrameCounts counts;

  explicit BinnedGeometry(const FrameInput& input) {
    lay_out(input, geometry);
    transform_stored(input, geometry);
    bin_triangles(input, geometry, bins, counts);
  }
};

} // namespace refraster
