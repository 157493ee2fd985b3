#pragma once
// What a frame costs ordinarily: a sum over what it is made of.

#include "bench/cliffs/families.h"

namespace refraster::cliffs {

/// Of how much of each a frame consists.
struct Load {
  double pixels = 0;    // of the image or crop, times samples
  double covered = 0;   // pixels times samples times layers of surfaces
  double fragments = 0; // times lights
  double triangles = 0;
  double vertices = 0;
};

/// `counts`: of that frame.
Load load_of(const Work& work, const FrameCounts& counts);

/// Nanoseconds for each.
struct OrdinaryCost {
  double pixel = 0;    // of an image in which nothing is seen
  double covered = 0;  // of a large triangle, hidden or not
  double fragment = 0; // Blinn-Phong, one point light, interpolation included
  double triangle = 0; // of a closed grid of triangles the size of a pixel, its share of vertices included
  double vertex = 0;   // of one that no triangle has
};

/// Of this machine, in this precision: medians, on one thread.
OrdinaryCost measured_costs(Precision precision);

/// What the frame would take, in milliseconds.
double ordinary_ms(const OrdinaryCost& cost, const Load& load);

/// How long a frame of it takes on one thread: the middle of several, after one that is not counted.
struct Timing {
  double lower_ms = 0, median_ms = 0, upper_ms = 0; // quartiles
  FrameCounts counts;
};

/// Frames of both in turn.
struct TwoTimings {
  Timing first, second;
};
TwoTimings timings_of(const Work& first, const Work& second, double seconds);

} // namespace refraster::cliffs
