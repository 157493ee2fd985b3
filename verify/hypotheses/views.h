#pragma once
// From where each pixel is taken, right and wrong: a camera, the size of the window, and a place in it.

#include <refraster/render.h>

#include "verify/hypotheses/steps.h"
#include "verify/hypotheses/window_geometry.h"

#include <vector>

namespace refraster::hypotheses {

/// A pixel's colour is the mean of what is seen at its taps.
struct Tap {
  WindowPoint seen;                  // where coverage is decided
  double shaded_x = 0, shaded_y = 0; // subpixels: where the triangle is shaded
};

/// How a view differs from the right one: in the projection, or in the places alone.
struct Projection {
  Camera camera;
  int width = 0, height = 0;

  bool operator==(const Projection& other) const;
};

struct ImageShift {
  int x = 0, y = 0; // the image is so many pixels to the right and down
};

/// What an image is: its size and how many samples a pixel has.
struct ImageKind {
  int width = 0, height = 0, samples = 1;
};

Projection projection_of(View view, const Scene& scene, const ImageKind& image);

/// In the window of that projection.
std::vector<Tap> taps_of(View view, const Scene& scene, const ImageKind& image, const ImageShift& shift, int x, int y);

} // namespace refraster::hypotheses
