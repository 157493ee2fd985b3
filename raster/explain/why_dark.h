#pragma once
// Why the surfaces in an image are black, or nearly so, in words.

#include <refraster/render.h>

#include <string>

namespace refraster {

/// Why surfaces that are seen are dark, for a note: "no light reaches what is seen: all 3 lights are behind it". Judged
/// by a frame with the AOVs object, position and normal, in this order, and the scene that it shows: which light has
/// n.l > 0 at a pixel, and how much of it arrives. `white_is_dark`: radiance up to which a surface counts as dark, also
/// a white one: what arrives is weak if it is no more. Of very many pixels and lights, evenly spread pixels are looked
/// at. Empty where no pixel of the frame shows a surface.
std::string why_dark(const Scene& scene, const Frame& frame, double white_is_dark);

} // namespace refraster
