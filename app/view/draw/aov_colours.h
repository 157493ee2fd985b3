#pragma once
// Values as colours, to look at.

#include <refraster/frame.h>

#include <cstdint>
#include <string>

namespace refraster {

/// An image of 8 bits, and what its colours mean, in a line.
struct AovPicture {
  Image<std::uint8_t> rgb8;
  std::string legend; // "depth: 0.91 black to 0.998 white"
};

/// Of the values of one AOV; `objects` are those of Aov::object, of the same size. Black where there is no surface.
/// Whole numbers each have a colour of their own; unit vectors, fractions and colours are shown as such; else the least
/// of what is to be seen is black, and the greatest white.
AovPicture aov_picture(Aov aov, const Image<float>& values, const Image<float>& objects);

/// Lines into an image, where a pixel sees another triangle than the one to its right or below it. `objects` and
/// `triangles` are the AOVs of these names, of the same size.
void draw_edges(Image<std::uint8_t>& rgb8, const Image<float>& objects, const Image<float>& triangles);

} // namespace refraster
