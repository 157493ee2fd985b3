#pragma once
// Which pixels of an image are not explained: by the bounds of tests/support/gl/colour_bound.h.

#include "verify/hypotheses/rank.h"

#include <cstdint>

namespace refraster {

/// How the image that is judged was stored.
enum class StoredAs { floats, rgb8 };

/// The image's values as they are read back from a file of that kind.
Image<float> stored(const Image<float>& radiance, StoredAs as);

/// What a right image of a scene is: made once, for any number of images that are judged by it.
class PixelJudge {
public:
  PixelJudge(const Scene& scene, int width, int height);

  /// What is asked of hypotheses about `actual`, which was drawn by llvmpipe as it is shipped. Pixels on edges, where a
  /// device may show either of two triangles, are left out; of the others some thousand of each kind are taken at
  /// random.
  hypotheses::RankRequest request(const Image<float>& actual, StoredAs as, std::uint64_t seed) const;

private:
  const Scene& scene_;
  int width_, height_;
  std::vector<hypotheses::JudgedPixel> right_; // without `actual`; none on edges; half widths without quantisation
};

} // namespace refraster
