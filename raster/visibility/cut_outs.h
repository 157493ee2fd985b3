#pragma once
// Which pixels of a triangle its material cuts out. Visibility asks; what an opacity is, shading knows.

#include "raster/visibility/depth_tile.h"

#include <cstdint>
#include <memory>

namespace refraster {

struct FrameContext; // raster/frame_context.h

/// Asked triangle by triangle, by one thread.
class CutOuts {
public:
  virtual ~CutOuts() = default;

  /// Another tile, perhaps of another frame: what is known of triangles is forgotten.
  virtual void enter(const FrameContext& context) = 0;

  /// Whether parts of this triangle of the frame may be cut out; what follows is asked of it.
  virtual bool has_cut_outs(std::uint32_t triangle) = 0;

  /// Where the triangle is there, in the pixels (x, y), (x + 1, y) … of the image, `pixels` of them, at most as many as
  /// a register has lanes; other lanes mean nothing. Decided at pixel centres: for all samples of a pixel at once.
  virtual MaskOf<DepthTile::Row> is_there(int x, int y, int pixels) = 0;
};

/// Defined by raster/shade/opacity.cpp.
std::unique_ptr<CutOuts> make_cut_outs();

} // namespace refraster
