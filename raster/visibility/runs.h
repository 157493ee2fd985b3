#pragma once
// The triangles of a frame in runs, each of which one thread bins.

#include "raster/vertex/transform.h"

#include <cstdint>
#include <vector>

namespace refraster {

/// Consecutive triangles [begin, end) of the frame, of one object.
struct RunPart {
  std::uint32_t object, begin, end;
};

/// The triangles of the frame in runs of about the same number, in their order, a few for each thread; none of objects
/// outside the view. What is on demand is in one run as a whole, since its vertices are transformed for the run alone.
std::vector<std::vector<RunPart>> runs_of(const Geometry& geometry, int threads);

} // namespace refraster
