#pragma once
// The fragments of a tile of which most triangles are seen by a pixel or two: the work list of shading without records.

#include "raster/shade/fragments.h"
#include "raster/shade/shade.h"
#include "raster/shade/tiny/vertex_data.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace refraster {

/// The tile's fragments by runs of triangles of an object that share a material, and within those as they come, so that
/// nothing is sorted where there is one such run: nearly always.
class TinyFragments {
public:
  struct Group {
    std::uint32_t object = 0;
    const Material* material = nullptr;
    VertexNeeds needs;
    std::uint32_t first_fragment = 0, fragments = 0;
  };

  /// Numbers the fragments of `runs` in the order of shading, and returns how many there are; or does nothing, and has
  /// none, where records of triangles are worth what they cost, or hold what VertexData does not.
  std::uint32_t collect(const FrameContext& context, const VisibleTile& visible, std::span<FragmentRun> runs);

  std::uint32_t fragments() const { return fragments_; }
  std::span<const Group> groups() const { return groups_; }

  /// Calls body(packet, number of its first fragment) for all fragments of a group, in order.
  template <class T, class Body>
  void for_each_packet(const FrameContext& context, const Group& group, const PixelRect& tile, Body&& body) const;

private:
  void find_groups(const FrameContext& context, std::span<const std::uint32_t> triangles);
  void put_in_order(const VisibleTile& visible, std::span<const FragmentRun> runs);
  void ask_for(const FrameContext& context, const Group& group, std::uint32_t first, std::uint32_t count) const;
  void sort(std::span<const std::uint32_t> triangles, std::span<FragmentRun> runs);
  void merge_groups();

  std::uint32_t fragments_ = 0;
  int samples_ = 1; // of a pixel
  std::vector<Group> groups_;
  std::vector<std::int32_t> end_slot_; // of each group: the first of the tile's triangles that is not of it
  std::vector<std::uint32_t> next_;    // of each group: where its next fragment goes
  // Of each fragment, and perhaps of more from a tile before: the triangle's number in the frame; x + 256 y, pixels
  // from the tile's corner.
  std::vector<std::uint32_t> triangle_, place_;
};

template <class T, class Body>
void TinyFragments::for_each_packet(const FrameContext& context, const Group& group, const PixelRect& tile,
                                    Body&& body) const {
  using Ints = typename TinyPacket<T>::Ints;
  constexpr std::uint32_t lanes = NumberTraits<T>::lanes;
  TinyPacket<T> packet;
  packet.object = group.object;
  const auto put = [&](const Ints& place, std::uint32_t first, std::uint32_t count) {
    packet.x = (tile.x + (place & 255)) * subpixels + subpixels / 2;
    packet.y = (tile.y + (place >> 8)) * subpixels + subpixels / 2;
    packet.count = static_cast<int>(count);
    body(std::as_const(packet), first);
  };
  const std::uint32_t end = group.first_fragment + group.fragments;
  std::uint32_t first = group.first_fragment;
  for (; first + lanes <= end; first += lanes) {
    ask_for(context, group, first, lanes);
    packet.number = &triangle_[first];
    put(load_lanes<Ints>(&place_[first]), first, lanes);
  }
  if (first == end) return;
  std::array<std::uint32_t, lanes> number, place; // what follows is of another group
  for (std::uint32_t lane = 0; lane < lanes; ++lane) {
    const std::uint32_t fragment = std::min(first + lane, end - 1);
    number[lane] = triangle_[fragment], place[lane] = place_[fragment];
  }
  packet.number = number.data();
  put(load_lanes<Ints>(place.data()), first, end - first);
}

} // namespace refraster
