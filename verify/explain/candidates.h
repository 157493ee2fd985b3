#pragma once
// Which triangles cover a sample, whether they are drawn or not; and which ones pass by.

#include "raster/frame_context.h"
#include "raster/visibility/visibility.h"
#include "verify/explain/pixel_story.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace refraster {

/// A candidate and its triangle's number in the frame.
struct NumberedCandidate {
  std::uint32_t number = 0;
  CoveringTriangle candidate;
};

/// All triangles of the scene that cover (x, y), in subpixels, from the nearest to the farthest; of equal depths the
/// first submitted stands first. `seen`: the number of the one that the frame shows there. Those with a corner that is
/// not finite cover nothing. Takes time in proportion to all triangles.
std::vector<NumberedCandidate> candidates_at(const FrameContext& context, std::int32_t x, std::int32_t y,
                                             std::optional<std::uint32_t> seen);

/// The triangles whose outlines are nearest to the centre of pixel (px, py), at most one an object and `most` in all,
/// nearest first: of those that are drawn somewhere near the image, as far as they lie between the depth planes.
std::vector<NearMiss> near_misses(const FrameContext& context, int px, int py, std::size_t most);

} // namespace refraster
