#pragma once
// The shading of a tile in one number: included by raster/shade/precisions/*.cpp and, for other numbers, by
// raster/render_in.h. For a number without lanes raster/shade/sample_data.h must be included too.

#include "raster/resolve/resolve.h"
#include "raster/shade/fragments.h"
#include "raster/shade/packet_surfaces.h"
#include "raster/shade/shade.h"
#include "raster/shade/shadow/tile_shadows.h"
#include "raster/shade/tiny/tiny_surface.h"
#include "raster/shade/user_shading.h"
#include "raster/stopwatch.h"
#include "shading/fragment_functions.h"

#include <functional>
#include <utility>
#include <variant>

namespace refraster {

template <class T>
struct EdgeArithmetic;
template <Number T>
class SampleData;

/// What is asked for of a number without lanes, beside the frame's images.
template <class T>
struct SampleRequest {
  // Called for each pixel of the full image that shows a surface, with its colour as it is in T: from several threads.
  std::function<void(int x, int y, const Rgb<T>& radiance)> take = {};
  std::function<bool(int x, int y)> wanted =
      {}; // which pixels are shaded, the others show the background; all if empty. From several threads too
  std::function<void()> enter = {}; // called on the thread of each tile before it is shaded: DeviceArithmetic::use
  // Where the sample is, counted from the pixel's centre in subpixels: a range, if T has ranges.
  typename EdgeArithmetic<T>::Value dx{0}, dy{0};
};
struct NoRequest {};

/// A full register of fragments at a time; or, for a number without lanes, one by one through the same formulas.
template <class T>
class TileShadingOf final : public TileShading {
  static constexpr bool has_lanes = NumberTraits<T>::has_lanes;
  template <class U>
  struct RequestOf {
    using type = SampleRequest<U>;
  };
  template <class U>
    requires(NumberTraits<U>::has_lanes)
  struct RequestOf<U> {
    using type = NoRequest;
  };

public:
  using Request = typename RequestOf<T>::type;
  explicit TileShadingOf(Request request = {}) : request_(std::move(request)) {}

  void shade(const FrameContext& context, const VisibleTile& visible, Frame& frame,
             const TileMeasures& measures) override {
    FrameCounts& counts = measures.counts;
    Stopwatch stopwatch;
    if constexpr (!has_lanes)
      if (request_.enter) request_.enter();
    list_runs(visible.visibility, visible.tile, context.options.samples, runs_);
    if constexpr (!has_lanes) keep_wanted(visible.tile);
    const std::uint32_t fragments = collect(context, visible);
    measures.seconds.attribute_setup += stopwatch.lap();
    colours_.resize(fragments);
    if (context.shadows) [[unlikely]]
      shadows_.decide(context, visible, runs_, fragments);
    const auto shade_groups = [&](const auto& groups) {
      for (const auto& group : groups) {
        const Material& material = *group.material;
        const auto shade = [&]<Maps maps>(std::integral_constant<Maps, maps>, const auto& function) {
          shade_group<maps>(context, visible.tile, material, function, group, counts.undefined);
        };
        if (material.user_function) shade(std::integral_constant<Maps, Maps::no>{}, *material.user_function);
        else with_maps(material, shade);
        counts.lane_slots += (group.fragments + lanes - 1) / lanes * lanes;
      }
    };
    if constexpr (has_lanes) shade_groups(tiny_.groups());
    shade_groups(setups_.groups());
    counts.fragments += fragments;
    measures.seconds.shading += stopwatch.lap();
    resolver_.resolve(context, visible.tile, runs_, colours_, frame, counts);
    if constexpr (!has_lanes)
      if (request_.take && !cancelled(context)) resolver_.for_each_pixel(visible.tile, request_.take);
    write_aovs(context, visible, runs_, setups_for_aovs(context), frame.aovs);
    measures.seconds.resolve += stopwatch.lap();
  }

private:
  using Real = RealOf<T>;
  using Group = typename TileAttributes<Real>::Group;
  static constexpr std::uint32_t lanes = NumberTraits<T>::lanes;

  // The fragments of runs_, numbered: with records of their triangles, or without. Returns how many there are.
  std::uint32_t collect(const FrameContext& context, const VisibleTile& visible) {
    if constexpr (has_lanes)
      if (const std::uint32_t fragments = tiny_.collect(context, visible, runs_)) {
        setups_.clear();
        return fragments;
      }
    return setups_.collect(context, visible.triangles, runs_);
  }

  template <Maps maps, class SomeFunction, class SomeGroup>
  void shade_group(const FrameContext& context, const PixelRect& tile, const Material& material,
                   const SomeFunction& function, const SomeGroup& group, UndefinedCounts& undefined) {
    const auto shade_batch = [&] {
      const Scene& scene = context.scene;
      if (context.shadows) [[unlikely]]
        batch_.visibility = shadows_.from(batch_.first_fragment);
      if constexpr (std::is_same_v<SomeFunction, UserFunction>)
        user_shading_.sum_light(scene, function, batch_, undefined);
      else if constexpr (has_lanes) add_light<maps>(light_spans(scene), function, batch_, undefined);
      else refraster::sum_light<maps>(light_spans(scene), function, batch_, undefined);
      for (int i = 0; i < batch_.packets; ++i)
        colours_.store(batch_.first_fragment + static_cast<std::uint32_t>(i) * lanes,
                       batch_.sum[static_cast<std::size_t>(i)]);
      batch_.packets = 0;
    };
    // surface_of(tally, surface) interpolates what `in_use` says is there, maps_of(tally) what else is read there.
    const auto add = [&](std::uint32_t first, const MaskOf<T>& in_use, const auto& surface_of, const auto& maps_of) {
      if (batch_.packets == 0) batch_.first_fragment = first;
      const auto at = static_cast<std::size_t>(batch_.packets++);
      batch_.in_use[at] = in_use;
      const UndefinedTally<T> tally(undefined, batch_.in_use[at]);
      surface_of(tally, batch_.surface[at]);
      if constexpr (maps == Maps::yes) batch_.maps[at] = maps_of(tally);
      if (batch_.packets == batch_.capacity) shade_batch();
    };
    batch_.packets = 0; // of a frame that an exception ended
    if constexpr (std::same_as<SomeGroup, TinyFragments::Group>) {
      tiny_.for_each_packet<T>(context, group, tile, [&](const TinyPacket<T>& packet, std::uint32_t first) {
        add(
            first, first_lanes<Real, NumberTraits<T>::lanes>(packet.count),
            [&](const auto& tally, auto& surface) {
              tiny_surface(context, material, group.needs, packet, tally, surface);
            },
            [&](const auto& tally) { return tiny_maps(context, material, group.needs, packet, tally); });
      });
    } else if constexpr (has_lanes) {
      for_each_packet_list(setups_, group, tile, packets_, [&](const PacketList<T>& packets, std::uint32_t first) {
        batch_.first_fragment = first;
        make_surfaces<maps>(context, material, packets, undefined, batch_);
        shade_batch();
      });
    } else {
      for_each_sample(context, group, tile, [&](const SampleData<T>& data, std::uint32_t number) {
        add(
            number, T(0) <= T(0),
            [&](const auto& tally, auto& surface) { packet_surface(context, material, data, tally, surface); },
            [&](const auto& tally) { return fragment_maps(material, data, tally); });
      });
    }
    if (batch_.packets > 0) shade_batch();
  }

  /// Calls body(data, number) for each fragment of a group, in order: at pixel centres, as far off as was asked for. A
  /// tile may take seconds in 60 digits: it ends early where the frame is given up.
  template <class Body>
  void for_each_sample(const FrameContext& context, const Group& group, const PixelRect& tile, const Body& body) const {
    for (std::size_t i = group.begin_run; i < group.end_run; ++i) {
      const FragmentRun& run = setups_.sorted()[i];
      SampleData<T> data(context, setups_.setups()[run.slot].number);
      for (int k = 0; k < run.length; ++k) {
        if (cancelled(context)) return;
        data.move_to((tile.x + run.x + k) * subpixels + subpixels / 2, (tile.y + run.y) * subpixels + subpixels / 2,
                     request_.dx, request_.dy);
        body(data, run.first_fragment + static_cast<std::uint32_t>(k));
      }
    }
  }

  const TileAttributes<double>* setups_for_aovs(const FrameContext& context) const {
    if constexpr (std::same_as<Real, double>)
      return context.options.samples == 1 && tiny_.fragments() == 0 ? &setups_ : nullptr;
    else return nullptr;
  }

  static bool cancelled(const FrameContext& context) {
    return context.options.cancel && context.options.cancel->load(std::memory_order_relaxed);
  }

  /// Cuts runs down to the pixels that are wanted.
  void keep_wanted(const PixelRect& tile) {
    if (!request_.wanted) return;
    std::vector<FragmentRun> kept;
    for (const FragmentRun& run : runs_)
      for (int k = 0; k < run.length; ++k)
        if (request_.wanted(tile.x + run.x + k, tile.y + run.y))
          kept.push_back({run.slot, 0, static_cast<std::uint8_t>(run.x + k), run.y, 1, run.samples});
    runs_ = std::move(kept);
  }

  [[no_unique_address]] Request request_;
  std::vector<FragmentRun> runs_;
  TileAttributes<Real> setups_;
  PacketList<T> packets_;
  TinyFragments tiny_; // of a tile that has any, all
  PacketBatch<T> batch_;
  TileShadows shadows_;
  UserShading<T> user_shading_;
  FragmentColours<T> colours_;
  TileResolver<T> resolver_;
};

} // namespace refraster
