#pragma once
// Every number and table format in which a measured table can be read.

#include "math/rungs.h"
#include "shading/merl_lookup.h"
#include "tests/shading/directions.h"

#include <string_view>
#include <vector>

namespace refraster::ladder {

/// Values or seconds for many pairs of directions, in the lanes of one number.
struct Reader {
  std::string_view rung, format; // of the number, and of the table
  std::size_t bytes;             // of the table's copy
  bool own_logarithms;           // no other reader of this rung reads the copy of logarithms
  std::vector<Rgb<double>> (*read)(const MerlTable& table, MerlLookup lookup, const std::vector<SurfacePair>& pairs);
  /// Of processor time for all pairs, from directions to f: the least of several passes.
  double (*seconds)(const MerlTable& table, MerlLookup lookup, const std::vector<SurfacePair>& pairs);
};

/// Each rung with its own format, and float with halves.
std::vector<Reader> readers();

} // namespace refraster::ladder
