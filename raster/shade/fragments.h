#pragma once
// The fragments of a tile, gathered by triangle and packed into registers.

#include "raster/shade/attribute_setup.h"
#include "raster/shade/fragment_runs.h"
#include "raster/shade/packets.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace refraster {

/// The visible triangles of a tile, set up for shading once each in submission order, and the tile's runs gathered by
/// triangle, and so by runs of triangles of an object that share a material. So most packets of fragments lie in one
/// triangle, and only the last packet of a material may have lanes to spare.
template <class Real>
class TileAttributes {
public:
  struct Group {
    std::uint32_t object = 0;
    const Material* material = nullptr;
    std::size_t begin_run = 0, end_run = 0; // in sorted()
    std::uint32_t fragments = 0;
  };

  /// Numbers the fragments of `runs` in the order of shading. Returns how many there are.
  std::uint32_t collect(const FrameContext& context, std::span<const std::uint32_t> triangles,
                        std::span<FragmentRun> runs);

  /// No fragments.
  void clear() { groups_.clear(); }

  std::span<const Group> groups() const { return groups_; }
  std::span<const FragmentRun> sorted() const { return sorted_; } // `slot` is the attribute set-up's
  const AttributeSetup<Real>* setups() const { return setups_.data(); }

private:
  void set_up(const FrameContext& context, std::span<const std::uint32_t> triangles);
  std::uint32_t sort(std::span<FragmentRun> runs);

  std::vector<AttributeSetup<Real>> setups_;
  UncommonEdges uncommon_edges_;
  struct Seen {
    std::uint32_t runs = 0, fragments = 0;
  };
  std::vector<VisibleTriangle> visible_;
  std::vector<Seen> seen_;             // of each slot in the tile's list
  std::vector<std::int32_t> setup_of_; // of each slot that is seen
  std::vector<std::uint32_t> next_;    // per attribute set-up: where its next run goes in sorted_
  std::vector<Group> groups_;
  std::vector<FragmentRun> sorted_;
};

extern template class TileAttributes<double>;
extern template class TileAttributes<float>;

/// Calls body(packets, number of their first fragment) for all fragments of a group, in order: as many packets at a
/// time as `packets` holds, which is empty before and after. Formulas are total, so that lanes beyond packet.count may
/// be computed.
template <class T, class Body>
void for_each_packet_list(const TileAttributes<RealOf<T>>& setups,
                          const typename TileAttributes<RealOf<T>>::Group& group, const PixelRect& tile,
                          PacketList<T>& packets, Body&& body) {
  const auto& list = std::as_const(packets);
  const std::span<const FragmentRun> runs = setups.sorted().subspan(group.begin_run, group.end_run - group.begin_run);
  if (runs.empty()) return;
  std::uint32_t first = runs.front().first_fragment;
  const auto finish = [&] {
    body(list, first);
    first += static_cast<std::uint32_t>(packets.fragments());
    packets.clear();
  };
  packets.clear(); // of a frame that an exception ended
  for (const FragmentRun& run : runs) {
    const std::int32_t left = (tile.x + run.x) * subpixels + subpixels / 2;
    const std::int32_t y = (tile.y + run.y) * subpixels + subpixels / 2;
    for (int done = 0; done < run.length;) {
      const int here = std::min(run.length - done, packets.room());
      packets.add(setups.setups()[run.slot], left + done * subpixels, y, here);
      done += here;
      if (packets.room() == 0) finish();
    }
  }
  if (packets.fragments() > 0) finish();
}

/// Calls body(packet, number of its first fragment) for all fragments of a group, in order.
template <class T, class Body>
void for_each_packet(const TileAttributes<RealOf<T>>& setups, const typename TileAttributes<RealOf<T>>::Group& group,
                     const PixelRect& tile, Body&& body) {
  PacketList<T> packets;
  for_each_packet_list(setups, group, tile, packets, [&](const PacketList<T>& list, std::uint32_t first) {
    for (int i = 0; i < list.packets(); ++i)
      body(list.packet(i), first + static_cast<std::uint32_t>(i * NumberTraits<T>::lanes));
  });
}

} // namespace refraster
