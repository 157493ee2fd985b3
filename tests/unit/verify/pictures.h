#pragma once
// Pictures, and what goes wrong with them as a whole.

#include <refraster/image.h>

#include "verify/transformations/transformations.h"

#include <functional>
#include <string>
#include <vector>

namespace refraster::test {

/// 8-bit levels as floats.
using Picture = Image<float>;

struct NamedPicture {
  std::string name;
  Picture picture;
};

/// A picture of 96 x 64 pixels with edges, gradients, colours, black and white, alike to none of its mirror images.
Picture drawn_picture();

/// The images of some scenes of the gallery, small.
std::vector<NamedPicture> gallery_pictures();

/// One known transformation done to a picture, as a program does it that rounds to 8 bits.
struct Mistake {
  Transformation which;
  std::function<Picture(const Picture&)> make;
  double factor = 1;
  int x = 0, y = 0;
};

/// All of those that leave the size and need no alpha.
std::vector<Mistake> known_mistakes();

/// What else may happen to an image: none of it is a known transformation.
struct OtherChange {
  std::string name;
  std::function<Picture(const Picture&)> make;
};
std::vector<OtherChange> other_changes();

/// Each value mapped, rounded to a level and cut off at 0 and 255.
Picture mapped(const Picture& picture, const std::function<double(double)>& map);

/// As JPEG does it to luma and, at full resolution, to chroma: the cosine transform of 8 x 8 pixels, divided by a step
/// that grows with frequency, rounded, and back. step: of the lowest frequency, in levels.
Picture compressed(const Picture& picture, double step);

/// A share of the pixels is made something else: noise of a fixed seed.
Picture with_wrong_pixels(Picture picture, std::size_t count);

inline StoredImage stored(const Picture& picture) {
  return {picture, 255, StoredPrecision::integers(255)};
}

} // namespace refraster::test
