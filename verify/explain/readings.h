#pragma once
// What a texture filter and a table lookup read, by running them on a number that remembers it.

#include "shading/merl_lookup.h"
#include "shading/texture.h"
#include "verify/explain/pixel_story.h"

#include <vector>

namespace refraster {

/// The texels that are read of a texture at uv, and their weights.
std::vector<Texel> texels_read(const TextureMap& map, const Double2& uv, const Double2& right, const Double2& down);

/// The samples that `lookup` reads at a point, and their weights in what it interpolates (f, or its logarithm).
std::vector<MerlTap> taps_read(const MerlTable& table, MerlLookup lookup, const MerlPoint<double>& at);

} // namespace refraster
