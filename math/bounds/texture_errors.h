#pragma once
// What a device may do otherwise when it reads a texture.

#include "math/kit_namespace.h"

namespace refraster::inline REFRASTER_KIT {

/// How far what a device reads may be from what the formulas of shading/texture.h say. Places are in texels, colours in
/// units of the texture's full scale, levels of detail in levels.
struct TextureErrors {
  double place = 0;                          // where a filter reads: the last bit of its weights
  double nearest = 0;                        // where a single texel is read
  double filter = 0;                         // what a filter makes of the texels
  double mip = 0;                            // a texel of a smaller level, as it is stored
  double detail_below = 0, detail_above = 0; // the level of detail, below and above that of the formula
};

} // namespace refraster::inline REFRASTER_KIT
