#include "raster/shade/shadow/tile_shadows.h"

#include "raster/shade/shadow/fragment_point.h"

#include <optional>

namespace refraster {

void TileShadows::decide(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs,
                         std::uint32_t fragments) {
  constexpr std::size_t read_beyond = 64; // lanes of the widest packet
  const SceneShadows& shadows = *context.shadows;
  const std::span<const LightPlace> lights = shadows.lights();
  stride_ = fragments;
  visible_.resize(lights.size() * stride_ + read_beyond);
  std::optional<FragmentPoints> points; // of the last run's triangle
  std::int32_t slot = nothing;
  std::uint32_t number = 0;
  for (const FragmentRun& run : runs) {
    if (run.slot != slot) {
      slot = run.slot, number = visible.triangles[static_cast<std::size_t>(slot)];
      points.emplace(context, number);
    }
    const std::int32_t x = (visible.tile.x + run.x) * subpixels + subpixels / 2;
    const std::int32_t y = (visible.tile.y + run.y) * subpixels + subpixels / 2;
    for (std::int32_t i = 0; i < run.length; ++i) {
      const SurfacePoint point = points->at(x + i * subpixels, y);
      const std::size_t fragment = run.first_fragment + static_cast<std::uint32_t>(i);
      for (std::size_t light = 0; light < lights.size(); ++light)
        visible_[light * stride_ + fragment] = shadows.sees(point, number, lights[light]);
    }
  }
}

std::vector<std::uint8_t> lights_seen(const FrameContext& context, std::uint32_t number, std::int32_t x,
                                      std::int32_t y) {
  std::vector<std::uint8_t> seen;
  if (!context.shadows) return seen;
  const SurfacePoint point = FragmentPoints(context, number).at(x, y);
  for (const LightPlace& light : context.shadows->lights()) seen.push_back(context.shadows->sees(point, number, light));
  return seen;
}

} // namespace refraster
