#include "raster/shade/shadow/tile_shadows.h"

#include "raster/shade/shadow/fragment_point.h"

#include <optional>

namespace refraster {
namespace {

/// What the two kinds of shadows are asked with, as far as a frame has them.
struct FragmentPlace {
  SurfacePoint exact{};
  InterpolatedPoint interpolated{};

  FragmentPlace(const SceneShadows& shadows, const FragmentPoints& points, std::int32_t x, std::int32_t y) {
    if (shadows.has_exact()) exact = points.at(x, y);
    if (shadows.has_maps()) interpolated = points.interpolated_at(x, y);
  }
  double visibility(const SceneShadows& shadows, std::uint32_t number, const ShadowedLight& light) const {
    if (light.kind == Shadow::map) return shadows.map(light).visibility(interpolated.position, interpolated.normal);
    return shadows.sees(exact, number, light.place) ? 1 : 0;
  }
};

} // namespace

void TileShadows::decide(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs,
                         std::uint32_t fragments) {
  constexpr std::size_t read_beyond = 64; // lanes of the widest packet
  const SceneShadows& shadows = *context.shadows;
  const std::span<const ShadowedLight> lights = shadows.lights();
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
      const std::size_t fragment = run.first_fragment + static_cast<std::uint32_t>(i);
      const FragmentPlace place(shadows, *points, x + i * subpixels, y);
      for (std::size_t light = 0; light < lights.size(); ++light)
        visible_[light * stride_ + fragment] = place.visibility(shadows, number, lights[light]);
    }
  }
}

std::vector<double> lights_seen(const FrameContext& context, std::uint32_t number, std::int32_t x, std::int32_t y) {
  std::vector<double> seen;
  if (!context.shadows) return seen;
  const SceneShadows& shadows = *context.shadows;
  const FragmentPlace place(shadows, FragmentPoints(context, number), x, y);
  for (const ShadowedLight& light : shadows.lights()) seen.push_back(place.visibility(shadows, number, light));
  return seen;
}

} // namespace refraster
