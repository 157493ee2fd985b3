#pragma once
// The tile shader of one rung, as a template over its number: included by raster/rungs/*.cpp only.

#include "raster/fragments.h"
#include "raster/resolve.h"
#include "raster/shade.h"
#include "raster/shade_packet.h"

#include <chrono>
#include <utility>
#include <variant>

namespace refraster {

template <class T>
class TileShaderOf final : public TileShader {
public:
  void shade(const FrameContext& context, const VisibleTile& visible, Frame& frame,
             const TileMeasures& measures) override {
    FrameCounts& counts = measures.counts;
    auto now = std::chrono::steady_clock::now();
    const auto lap = [&now](double& sum) {
      const auto before = std::exchange(now, std::chrono::steady_clock::now());
      sum += std::chrono::duration<double>(now - before).count();
    };
    list_runs(visible.visibility, visible.tile, context.options.samples, runs_);
    const std::uint32_t fragments =
        surfaces_.collect(context.scene, context.geometry, context.bins, visible.triangles, runs_);
    lap(measures.seconds.surfaces);
    colours_.resize(fragments);
    for (const auto& group : surfaces_.groups()) {
      const Material& material = context.scene.objects[group.object].material;
      std::visit(
          [&](const auto& model) { shade_group(context, visible.tile, material, model, group, counts.undefined); },
          material.model);
      counts.lane_slots += (group.fragments + lanes - 1) / lanes * lanes;
    }
    counts.fragments += fragments;
    lap(measures.seconds.shading);
    resolver_.resolve(context, visible.tile, runs_, colours_, frame, counts);
    for (std::size_t i = 0; i < context.options.aovs.size(); ++i)
      write_aov(context, visible, runs_, context.options.aovs[i], frame.aovs[i]);
    lap(measures.seconds.resolve);
  }

private:
  using Real = RealOf<T>;
  using Group = typename TileSurfaces<Real>::Group;
  static constexpr std::uint32_t lanes = NumberTraits<T>::lanes;

  template <class Model>
  void shade_group(const FrameContext& context, const Crop& tile, const Material& material, const Model& model,
                   const Group& group, UndefinedCounts& undefined) {
    batch_.packets = 0; // of a frame that an exception ended
    const auto shade_batch = [&] {
      add_light(context.scene, model, batch_, undefined);
      for (int i = 0; i < batch_.packets; ++i)
        colours_.store(batch_.first_fragment + static_cast<std::uint32_t>(i) * lanes,
                       batch_.sum[static_cast<std::size_t>(i)]);
      batch_.packets = 0;
    };
    for_each_packet<T>(surfaces_, group, tile, [&](const Packet<T>& packet, std::uint32_t first) {
      if (batch_.packets == 0) batch_.first_fragment = first;
      const auto at = static_cast<std::size_t>(batch_.packets++);
      batch_.in_use[at] = first_lanes<Real, NumberTraits<T>::lanes>(packet.count);
      const UndefinedTally<T> tally(undefined, batch_.in_use[at]);
      if (packet.triangles == Triangles::one)
        interpolate(context, material, PacketData<T, Triangles::one>(packet), tally, batch_.surface[at]);
      else interpolate(context, material, PacketData<T, Triangles::many>(packet), tally, batch_.surface[at]);
      if (batch_.packets == batch_.most) shade_batch();
    });
    if (batch_.packets > 0) shade_batch();
  }

  // Everything that a packet's surface needs is inlined here: no call, and no vector in memory, in between.
  template <Triangles triangles>
  [[gnu::flatten, gnu::noinline]] static void interpolate(const FrameContext& context, const Material& material,
                                                          const PacketData<T, triangles>& data,
                                                          const UndefinedTally<T>& tally, PacketSurface<T>& surface) {
    surface = packet_surface(context.scene, context.geometry, material, data, tally);
  }

  std::vector<FragmentRun> runs_;
  TileSurfaces<Real> surfaces_;
  PacketBatch<T> batch_;
  FragmentColours<T> colours_;
  TileResolver<T> resolver_;
};

} // namespace refraster
