#pragma once
// What a tile sees, as runs of neighbouring pixels: the work list of shading.

#include "raster/shade/attribute_setup.h"
#include "raster/visibility/visibility.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace refraster {

/// Neighbouring pixels of one row that see one triangle with the same number of samples. Each pixel of a run is one
/// fragment: it is shaded once.
struct FragmentRun {
  std::int32_t slot = 0; // of the triangle, in the tile's list; then of its attribute set-up, in TileAttributes
  std::uint32_t first_fragment = 0; // the run's fragments have consecutive numbers
  std::uint8_t x = 0, y = 0;        // leftmost pixel, counted from the tile's corner
  std::uint8_t length = 1;          // pixels
  std::uint8_t samples = 1;         // of each pixel that see the triangle
};

/// The tile's fragments in row order, and within a pixel in the order of its samples. With more than one sample a pixel
/// every run is one pixel long.
void list_runs(const TileVisibility& visibility, const PixelRect& tile, int samples, std::vector<FragmentRun>& runs);

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

/// Whether a packet's fragments lie in one triangle: its data are then broadcast to all lanes, else read for each.
enum class Triangles { one, many };

/// As many fragments as T has lanes, of one material.
template <class T>
struct Packet {
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  using Ints = VectorOf<std::int32_t, lanes>;

  const AttributeSetup<Real>* setups = nullptr; // the tile's
  Ints setup{};                                 // which of them each lane sees
  Ints x{}, y{};                                // pixel centres, subpixels of the window
  int count = 0;                                // lanes in use; the others repeat the last one
  Triangles triangles = Triangles::one;
  EdgeKind edges = EdgeKind::wrapped; // the greatest of all lanes

  const AttributeSetup<Real>& triangle(int lane) const { return setups[setup[lane]]; }

  /// Puts `pixels` neighbours, x_first and on, into the lanes from `count` on. The lanes after them repeat the last.
  void append(std::int32_t slot, std::int32_t x_first, std::int32_t y_all, int pixels) {
    const EdgeKind kind = setups[slot].kind();
    if (count == 0) triangles = Triangles::one, edges = kind;
    else {
      if (setup[count - 1] != slot) triangles = Triangles::many;
      edges = std::max(edges, kind);
    }
    const Ints after = lane_numbers() - count; // 0 in the first new lane
    const Ints clamped = after < pixels - 1 ? after : pixels - 1 - Ints{};
    setup = after < 0 ? setup : slot - Ints{};
    x = after < 0 ? x : x_first + clamped * subpixels;
    y = after < 0 ? y : y_all - Ints{};
    count += pixels;
  }

private:
  static Ints lane_numbers() {
    return [&]<int... I>(std::integer_sequence<int, I...>) {
      return Ints{I...};
    }
    (std::make_integer_sequence<int, lanes>{});
  }
};

/// Calls body(packet, number of its first fragment) for all fragments of a group, in order. Formulas are total, so that
/// lanes beyond packet.count may be computed.
template <class T, class Body>
void for_each_packet(const TileAttributes<RealOf<T>>& setups, const typename TileAttributes<RealOf<T>>::Group& group,
                     const PixelRect& tile, Body&& body) {
  constexpr int lanes = NumberTraits<T>::lanes;
  Packet<T> packet;
  packet.setups = setups.setups();
  std::uint32_t first = 0;
  const std::span<const FragmentRun> runs = setups.sorted().subspan(group.begin_run, group.end_run - group.begin_run);
  for (const FragmentRun& run : runs) {
    const std::int32_t left = (tile.x + run.x) * subpixels + subpixels / 2;
    const std::int32_t y = (tile.y + run.y) * subpixels + subpixels / 2;
    for (int done = 0; done < run.length;) {
      if (packet.count == 0) first = run.first_fragment + static_cast<std::uint32_t>(done);
      const int here = std::min(run.length - done, lanes - packet.count);
      packet.append(run.slot, left + done * subpixels, y, here);
      done += here;
      if (packet.count == lanes) {
        body(std::as_const(packet), first);
        packet.count = 0;
      }
    }
  }
  if (packet.count > 0) body(std::as_const(packet), first);
}

} // namespace refraster
