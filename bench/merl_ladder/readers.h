#pragma once
// Every number and table format in which a measured table can be read.

#include "math/precisions.h"
#include "shading/merl_lookup.h"
#include "tests/support/shading/directions.h"

#include <string_view>
#include <vector>

namespace refraster::ladder {

/// A copy of the table.
struct Format {
  std::string_view name;
  std::size_t bytes;
};

/// Values or seconds for many pairs of directions, in the lanes of one number.
struct Reader {
  std::string_view precision;
  Format values, logarithms;
  bool is_the_precisions; // what a frame of the precision reads; else only the values are in another format
  std::vector<Rgb<double>> (*read)(const MerlTable& table, MerlLookup lookup, const std::vector<SurfacePair>& pairs);
  /// Of processor time for all pairs, from directions to f: the least of several passes.
  double (*seconds)(const MerlTable& table, MerlLookup lookup, const std::vector<SurfacePair>& pairs);
};

/// Each precision with its own format, and float with halves.
std::vector<Reader> readers();

} // namespace refraster::ladder
