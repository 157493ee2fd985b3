#pragma once
// What a tile sees, as runs of neighbouring pixels: the work list of shading.

#include "raster/surface.h"
#include "raster/visibility.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// Neighbouring pixels of one row that see one triangle with the same number of samples. Each pixel of a run is one
/// fragment: it is shaded once.
struct FragmentRun {
  std::int32_t place = 0;           // of the triangle, in the tile's list; then of its surface, in TileSurfaces
  std::uint32_t first_fragment = 0; // the run's fragments have consecutive numbers
  std::uint8_t x = 0, y = 0;        // leftmost pixel, counted from the tile's corner
  std::uint8_t length = 1;          // pixels
  std::uint8_t samples = 1;         // of each pixel that see the triangle
};

/// The tile's fragments in row order, and within a pixel in the order of its samples. With more than one sample a pixel
/// every run is one pixel long.
void list_runs(const TileVisibility& visibility, const Crop& tile, int samples, std::vector<FragmentRun>& runs);

/// The visible triangles of a tile, set up for shading once each, and the tile's runs gathered by object, whose
/// fragments share a material, and then by triangle. So most packets of fragments lie in one triangle, and only the
/// last packet of a material may have lanes to spare.
template <class Real>
class TileSurfaces {
public:
  struct Group {
    std::uint32_t object = 0;
    std::size_t begin_run = 0, end_run = 0; // in sorted()
    std::uint32_t fragments = 0;
  };

  /// Numbers the fragments of `runs` in the order of shading. Returns how many there are.
  std::uint32_t collect(const Scene& scene, const Geometry& geometry, const Bins& bins,
                        std::span<const std::uint32_t> triangles, std::span<FragmentRun> runs);

  std::span<const Group> groups() const { return groups_; }
  std::span<const FragmentRun> sorted() const { return sorted_; } // `place` is the surface's
  const SurfaceTriangle<Real>& surface(std::int32_t place) const { return surfaces_[static_cast<std::size_t>(place)]; }

private:
  std::size_t group_of(std::uint32_t object);

  std::vector<SurfaceTriangle<Real>> surfaces_;
  std::vector<std::int32_t> surface_of_; // for each place in the tile's list; -1: not visible
  std::vector<std::uint32_t> group_of_surface_, runs_of_surface_;
  std::vector<std::uint32_t> next_; // per surface: where its next run goes in sorted_
  std::vector<Group> groups_;
  std::vector<FragmentRun> sorted_;
};

extern template class TileSurfaces<double>;
extern template class TileSurfaces<float>;

/// As many fragments as T has lanes, of one material.
template <class T>
struct Packet {
  static constexpr int lanes = NumberTraits<T>::lanes;
  using Real = RealOf<T>;
  std::array<const SurfaceTriangle<Real>*, lanes> triangle;
  std::array<std::int32_t, lanes> x, y; // pixel centres, subpixels of the window
  int count = 0;                        // lanes in use; the others repeat the last one
};

/// Calls body(packet, number of its first fragment) for all fragments of a group, in order. Formulas are total, so that
/// lanes beyond packet.count may be computed.
template <class T, class Body>
void for_each_packet(const TileSurfaces<RealOf<T>>& surfaces, const typename TileSurfaces<RealOf<T>>::Group& group,
                     const Crop& tile, Body&& body) {
  constexpr int lanes = NumberTraits<T>::lanes;
  Packet<T> packet;
  std::uint32_t first = 0;
  const std::span<const FragmentRun> runs = surfaces.sorted().subspan(group.begin_run, group.end_run - group.begin_run);
  for (const FragmentRun& run : runs) {
    const SurfaceTriangle<RealOf<T>>* const triangle = &surfaces.surface(run.place);
    const std::int32_t left = (tile.x + run.x) * subpixels + subpixels / 2;
    const std::int32_t y = (tile.y + run.y) * subpixels + subpixels / 2;
    for (int done = 0; done < run.length;) {
      if (packet.count == 0) first = run.first_fragment + static_cast<std::uint32_t>(done);
      const int here = std::min(run.length - done, lanes - packet.count);
      for (int i = 0; i < here; ++i) {
        const auto lane = static_cast<std::size_t>(packet.count + i);
        packet.triangle[lane] = triangle;
        packet.x[lane] = left + (done + i) * subpixels;
        packet.y[lane] = y;
      }
      done += here;
      packet.count += here;
      if (packet.count == lanes) {
        body(packet, first);
        packet.count = 0;
      }
    }
  }
  if (packet.count == 0) return;
  const auto last = static_cast<std::size_t>(packet.count - 1);
  for (std::size_t lane = last + 1; lane < static_cast<std::size_t>(lanes); ++lane) {
    packet.triangle[lane] = packet.triangle[last];
    packet.x[lane] = packet.x[last];
    packet.y[lane] = packet.y[last];
  }
  body(packet, first);
}

} // namespace refraster
