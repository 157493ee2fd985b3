#pragma once
// From what a tile sees to its pixels, in the number of a precision.

#include "raster/frame_context.h"
#include "raster/shade/fragments.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace refraster {

/// What is known of a tile once visibility is decided.
struct VisibleTile {
  PixelRect tile;
  std::span<const std::uint32_t> triangles;
  const TileVisibility& visibility;
};

/// What a thread counts and times, tile after tile.
struct TileMeasures {
  FrameCounts& counts;
  TileSeconds& seconds;
};

/// Shades tiles one after the other. Holds scratch memory: one for each thread.
class TileShading {
public:
  virtual ~TileShading() = default;
  /// Shades each fragment of the tile once, resolves the samples, and writes the tile's pixels to the images that
  /// `frame` holds; adds to `measures`. Values are finite.
  virtual void shade(const FrameContext& context, const VisibleTile& visible, Frame& frame,
                     const TileMeasures& measures) = 0;
};

/// For a precision. Throws std::invalid_argument for what is none.
std::unique_ptr<TileShading> make_tile_shading(Precision precision);

// Each defined in a file of its own, raster/shade/precisions/<name>.cpp: a full instantiation of everything above the
// number.
std::unique_ptr<TileShading> make_double_shading();
std::unique_ptr<TileShading> make_float_shading();
std::unique_ptr<TileShading> make_fast_shading();
std::unique_ptr<TileShading> make_exact_shading();

/// A single frame by tile shading of one's own, of which `make_shading` makes one for each thread; options.precision is
/// not read.
using MakeShading = std::function<std::unique_ptr<TileShading>()>;
void render_with(const Scene& scene, const RenderOptions& options, const MakeShading& make_shading, Frame& frame);

/// Writes the tile's part of the images of all AOVs that are asked for, in one pass over its surfaces. Computed in
/// double whatever the precision: of the first of each pixel's `runs`. `shaded` is what shading has set up for these
/// runs, if that is double and no pixel has more than one run; else null.
void write_aovs(const FrameContext& context, const VisibleTile& visible, std::span<const FragmentRun> runs,
                const TileAttributes<double>* shaded, std::span<Image<float>> images);

} // namespace refraster
