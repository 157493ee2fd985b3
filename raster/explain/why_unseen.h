#pragma once
// Why a scene shows no surface, in words.

#include <refraster/render.h>

#include <string>

namespace refraster {

/// Why no object covers a pixel of the region, for a note: "all 3 objects lie beyond the far plane, 100; the nearest is
/// 570 away". For a scene and a region of an image of width x height of which no surface is seen; of another one it
/// says what it finds all the same. Objects are judged one by one, by clipping in double: as exact as words need. Takes
/// time in proportion to the triangles, and no memory to speak of.
std::string why_unseen(const Scene& scene, int width, int height, const PixelRect& region);

} // namespace refraster
