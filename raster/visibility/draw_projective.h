#pragma once
// Triangles with a corner behind the eye or far outside the image, drawn into a tile.

#include "raster/samples.h"
#include "raster/visibility/depth_tile.h"
#include "raster/visibility/setup.h"

#include <span>

namespace refraster {

/// A register of samples at a time, with the bits of ProjectivePiece::covers and ProjectivePiece::depth.
void draw_projective(const ProjectiveTriangle& triangle, std::int32_t slot, const PixelRect& tile,
                     std::span<const SamplePosition> samples, DepthTile& depths);

} // namespace refraster
