#pragma once
// The story of one pixel.

#include <refraster/image.h>

#include "verify/explain/pixel_story.h"
#include "verify/images/stored_precision.h"

#include <optional>
#include <string>

namespace refraster {

/// Which pixel, of which image.
struct ExplainRequest {
  int x = 0, y = 0;                     // within the image, from the top left
  int width = 1280, height = 720;       // of the image
  int samples = 1;                      // a pixel: 1, 2, 4, 8 or 16
  Transfer transfer = Transfer::linear; // of 8-bit levels, the actual image's too
  MemoryBudget memory = {};             // asked for the vertices
};

/// What another renderer has at the pixel.
struct ActualPixel {
  std::string path;
  Double3 stored{0}; // grey three times
  double full_scale = 255;
  StoredPrecision precision;
};

/// Tells it from the product's own formulas. The sum is that of render(), bit for bit, in every precision. Throws as
/// render() does. Takes a frame's time for the vertices, and none to speak of for the pixel.
PixelStory explain_pixel(const Scene& scene, const ExplainRequest& request,
                         const std::optional<ActualPixel>& actual = {});

} // namespace refraster
