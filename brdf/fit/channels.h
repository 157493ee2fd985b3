#pragma once
// A colour as reports have it.

#include <refraster/vector.h>

#include <vector>

namespace refraster {

/// Red, green, blue: an array in JSON.
inline std::vector<double> channels_of(const Rgb<double>& colour) {
  return {colour.x, colour.y, colour.z};
}

} // namespace refraster
