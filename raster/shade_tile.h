#pragma once
// The tile shader of one rung, as a template over its number: included by raster/rungs/*.cpp only.

#include "raster/resolve.h"
#include "raster/shade.h"
#include "raster/shade_packet.h"

#include <algorithm>
#include <array>
#include <variant>

namespace refraster {

/// The visible triangles of a tile, set up for shading once each, and the tile's fragments by material.
template <class Real>
class TileSurfaces {
public:
  struct Group {
    std::uint32_t object;                 // fragments of one object share a material
    std::vector<std::uint32_t> fragments; // indices into the tile's fragments, in order
  };

  void collect(const FrameContext& context, const VisibleTile& visible, std::span<const TileFragment> fragments) {
    surfaces_.clear();
    group_of_.clear();
    surface_of_.assign(visible.triangles.size(), -1);
    for (Group& group : groups_) group.fragments.clear();
    used_ = 0;
    for (std::uint32_t i = 0; i < fragments.size(); ++i) {
      const auto place = static_cast<std::size_t>(fragments[i].place);
      if (surface_of_[place] < 0) {
        surface_of_[place] = static_cast<std::int32_t>(surfaces_.size());
        surfaces_.push_back(
            surface_triangle<Real>(context.scene, context.geometry, context.bins, visible.triangles[place]));
        group_of_.push_back(group(surfaces_.back().object));
      }
      groups_[group_of_[static_cast<std::size_t>(surface_of_[place])]].fragments.push_back(i);
    }
  }

  std::span<const Group> groups() const { return {groups_.data(), used_}; }
  const SurfaceTriangle<Real>& of(const TileFragment& fragment) const {
    return surfaces_[static_cast<std::size_t>(surface_of_[static_cast<std::size_t>(fragment.place)])];
  }

private:
  std::size_t group(std::uint32_t object) {
    for (std::size_t g = 0; g < used_; ++g)
      if (groups_[g].object == object) return g;
    if (used_ == groups_.size()) groups_.emplace_back();
    groups_[used_].object = object;
    return used_++;
  }

  std::vector<SurfaceTriangle<Real>> surfaces_;
  std::vector<std::int32_t> surface_of_; // for each place in the tile's list; -1: not visible
  std::vector<std::size_t> group_of_;    // for each surface
  std::vector<Group> groups_;
  std::size_t used_ = 0;
};

/// Calls body(packet, indices of its fragments) for fragments of one group, as many at a time as T has lanes. Lanes
/// left over repeat the last fragment: formulas are total, so computing them is safe.
template <class T, class Body>
void for_each_packet(const TileSurfaces<RealOf<T>>& surfaces, const Crop& tile, std::span<const TileFragment> fragments,
                     std::span<const std::uint32_t> group, Body&& body) {
  constexpr std::size_t lanes = NumberTraits<T>::lanes;
  for (std::size_t begin = 0; begin < group.size(); begin += lanes) {
    const std::size_t count = std::min(lanes, group.size() - begin);
    Packet<T, SurfaceTriangle<RealOf<T>>> packet;
    packet.count = static_cast<int>(count);
    packet.one_triangle = true;
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const TileFragment& fragment = fragments[group[begin + std::min(lane, count - 1)]];
      packet.triangle[lane] = &surfaces.of(fragment);
      packet.x[lane] = (tile.x + fragment.x) * subpixels + subpixels / 2;
      packet.y[lane] = (tile.y + fragment.y) * subpixels + subpixels / 2;
      packet.one_triangle &= packet.triangle[lane] == packet.triangle[0];
    }
    body(packet, group.subspan(begin, count));
  }
}

template <class T>
class TileShaderOf final : public TileShader {
public:
  void shade(const FrameContext& context, const VisibleTile& visible, Frame& frame, FrameCounts& counts) override {
    list_fragments(visible.visibility, visible.tile, context.options.samples, fragments_);
    surfaces_.collect(context, visible, fragments_);
    for (std::vector<Real>& channel : colour_) channel.resize(fragments_.size());
    for (const auto& group : surfaces_.groups()) {
      const Material& material = context.scene.objects[group.object].material;
      std::visit(
          [&](const auto& model) { shade_group(context, visible.tile, material, model, group.fragments, counts); },
          material.model);
    }
    resolve_tile<Real>(context, visible, fragments_, colour_, frame, counts);
    for (std::size_t i = 0; i < context.options.aovs.size(); ++i)
      write_aov(context, visible, fragments_, context.options.aovs[i], frame.aovs[i]);
  }

private:
  using Real = RealOf<T>;
  static constexpr int lanes = NumberTraits<T>::lanes;

  template <class Model>
  void shade_group(const FrameContext& context, const Crop& tile, const Material& material, const Model& model,
                   std::span<const std::uint32_t> group, FrameCounts& counts) {
    for_each_packet<T>(
        surfaces_, tile, fragments_, group, [&](const auto& packet, std::span<const std::uint32_t> indices) {
          const UndefinedTally<T> tally(counts.undefined, first_lanes<Real, lanes>(packet.count));
          const PacketSurface<T> surface = packet_surface(context.scene, context.geometry, material, packet, tally);
          const Fragment<T> at{surface.position, surface.normal, surface.to_eye, surface.texture, &tally};
          const Rgb<T> rgb = radiance(context.scene, model, at, tally);
          for (std::size_t lane = 0; lane < indices.size(); ++lane)
            for (int c = 0; c < 3; ++c)
              colour_[static_cast<std::size_t>(c)][indices[lane]] = rgb[c][static_cast<int>(lane)];
          counts.lane_slots += static_cast<std::uint64_t>(lanes);
        });
  }

  std::vector<TileFragment> fragments_;
  TileSurfaces<Real> surfaces_;
  std::array<std::vector<Real>, 3> colour_; // a plane a channel, one entry a fragment
};

} // namespace refraster
