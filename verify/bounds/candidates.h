#pragma once
// Which triangles a device may show in a pixel, in whichever way it is right.

#include "raster/samples.h"
#include "verify/bounds/device_triangle.h"

#include <cstdint>
#include <span>
#include <vector>

namespace refraster {

/// A triangle that may be seen.
struct Candidate {
  std::uint32_t number = 0; // in the frame
  bool certain = false;     // it covers the sample, and lies between the depth planes
  std::uint8_t ambiguous_edges = 0;
  bool may_be_cut_out = false; // where its opacity may be on either side of the threshold
  ValueRange depth;
};

/// Of one sample of a pixel.
struct VisibleSet {
  std::vector<Candidate> candidates; // in the order of their numbers
  bool background = true;            // whether that may be seen
};

/// A pixel of the frame.
struct PixelPlace {
  int x = 0, y = 0;
};

/// For each of these pixels, what its sample may show. Pixels are in any order, each once. Takes the frame's threads.
///
/// A triangle is a candidate if it may cover the sample and nothing that certainly does lies certainly nearer. Where
/// triangles of a mesh meet at edges that a sample may be on either side of, and look the same way, one of them covers
/// it, though none certainly does: so that a crack is not explained. OpenGL 4.6, section 14.6.1: of two polygons that
/// share an edge exactly one has the fragments on it. Of triangles with the same corners the first drawn is seen. What
/// is certainly cut out is no candidate; where opacity may be on either side of the threshold, a triangle may be
/// missing as well.
std::vector<VisibleSet> find_candidates(const DeviceFrame& frame, const std::vector<PixelPlace>& pixels,
                                        SamplePosition sample);

/// The same of these triangles alone, whose numbers rise: by the thread that calls.
std::vector<VisibleSet> find_candidates_among(const DeviceFrame& frame, const std::vector<PixelPlace>& pixels,
                                              SamplePosition sample, std::span<const std::uint32_t> triangles);

} // namespace refraster
