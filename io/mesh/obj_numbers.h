#pragma once
// Coordinates of an OBJ file as text.

#include "io/file/number_text.h"
#include "math/vec.h"

#include <cmath>
#include <string_view>

namespace refraster {

/// What printf makes of a number that is none: nan, -nan(ind), inf; in older C libraries of Windows -1.#IND, 1.#QNAN,
/// 1.#INF, with digits to fill the width.
bool is_not_finite(std::string_view word);

/// read_number, for which these are not_finite.
NumberText read_coordinate(std::string_view word, float& value);

/// Whether rounding to float may move a vertex by a thousandth of the mesh's size: it moves a coordinate by 2^-24 of it
/// at most, and the vertex before is no farther away than that size, if both are of the mesh. Few vertices of other
/// meshes lie that close to each other.
bool rounding_may_matter(const Float3& point, const Float3& before);

/// Whether all coordinates are finite.
template <glm::length_t N>
bool is_finite(const glm::vec<N, float, glm::defaultp>& a) {
  bool all = true;
  for (glm::length_t c = 0; c < N; ++c) all = all && std::isfinite(a[c]);
  return all;
}

} // namespace refraster
