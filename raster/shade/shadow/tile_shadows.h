#pragma once
// How much the fragments of a tile see of lights with shadows.

#include "raster/shade/fragment_runs.h"
#include "raster/shade/shade.h"
#include "shading/light_spans.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// Tile after tile, by one thread. The same for every precision: of the number that shades, nothing is known here.
class TileShadows {
public:
  /// Of a frame with shadows. `runs` are numbered, `fragments` in all, and their slots are those of visible.triangles.
  void decide(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs,
              std::uint32_t fragments);

  /// From a fragment on; nothing is known of a frame without shadows.
  LightVisibility from(std::uint32_t fragment) const {
    return LightVisibility{visible_.data(), stride_}.from(fragment);
  }

private:
  std::vector<double> visible_;
  std::size_t stride_ = 0;
};

/// The same of one triangle at (x, y), in subpixels of the window: a number for each light with a shadow.
std::vector<double> lights_seen(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y);

} // namespace refraster
