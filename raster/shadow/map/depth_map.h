#pragma once
// The depth map of one light: what it sees nearest, texel by texel, and how a surface is compared with it.

#include "raster/buffer.h"
#include "raster/shadow/map/light_view.h"
#include "raster/vertex/transform.h"
#include "raster/visibility/bin.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace refraster {

/// One comparison of a filter.
struct MapTap {
  int column = 0, row = 0;
  double weight = 1;    // in the sum of those that are lit
  float stored = 1;     // window depth in the map
  bool outside = false; // of a direction light's map: lit
  bool lit = true;
};

/// The taps of one lookup; their weights add up to 1, but for rounding.
struct MapTaps {
  std::array<MapTap, 9> tap;
  int count = 0;
};

/// Where the first of the taps along one axis is, and by how much of a texel the place is beyond its centre: in [0, 1)
/// with ShadowFilter::two_by_two, 0 with the others.
struct MapCell {
  int first = 0;
  double fraction = 0;
};

/// Of a place of `at` texels from the border.
MapCell map_cell(ShadowFilter filter, double at, int size);

/// Memory of drawing, used again from map to map.
struct DepthMapScratch {
  Geometry geometry;
  Bins bins;
};

/// Window depths as GL_DEPTH_COMPONENT32F holds them: the nearest float to (z / w + 1) / 2, of which z / w is what the
/// rasterizer has in double; 1 where nothing is seen.
class DepthMap {
public:
  /// Draws every face. `casters`: casters_of() the scene of `frame`, whose threads, tiles and memory budget count.
  void draw(const FrameInput& frame, const Scene& casters, const LightView& view, DepthMapScratch& scratch);

  const LightView& view() const { return view_; }

  /// Of a texel: columns and rows are counted from the lower left corner, as OpenGL's are.
  float at(std::size_t face, int column, int row) const {
    const auto size = static_cast<std::size_t>(view_.map.size);
    return texels_[(face * size + static_cast<std::size_t>(row)) * size + static_cast<std::size_t>(column)];
  }

  /// How much of the light a surface sees: the weights of the lit taps, summed. Neither place nor normal need be
  /// finite.
  double visibility(const Double3& position, const Double3& normal) const;
  /// The same, written down.
  MapTaps taps(std::size_t face, const MapPlace<double>& place) const;
  /// The face that a position is looked up in.
  std::size_t face_of(const Double3& position) const {
    return view_.kind == LightPlace::Kind::point ? cube_face_of(position - view_.origin) : 0;
  }

  static std::uint64_t bytes(const LightView& view) {
    const auto size = static_cast<std::uint64_t>(view.map.size);
    return view.faces() * size * size * sizeof(float);
  }
  std::uint64_t bytes_held() const { return texels_.size() * sizeof(float); }

private:
  LightView view_;
  Buffer<float> texels_; // face after face, row after row
};

/// The sum of the lit taps' weights: of nine ninths, whole ones first, so that nine make 1.
double lit_fraction(const MapTaps& taps, ShadowFilter filter);

} // namespace refraster
