#pragma once
// Pairs of directions from a table of numbers.

#include "io/csv/number_table.h"

#include "brdf/angles.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

/// The columns that name a pair of directions, one of:
///     theta_in theta_out dphi                  degrees: InOutAngles, thetas in [0, 90]
///     theta_h theta_d phi_d                    degrees: HalfDifferenceAngles, thetas in [0, 90]
///     in_x in_y in_z out_x out_y out_z         vectors of any length over a surface with normal (0, 0, 1)
/// Where a table has several of them, the first of these counts.
/// Throws InputError with all faults: no such columns, an angle out of range, a vector without a direction.
std::vector<DirectionPair> pairs_of(const NumberTable& table);

/// The columns r g b, reflectance in 1/sr, as indices. Throws InputError if one is missing.
std::array<std::size_t, 3> rgb_columns(const NumberTable& table);

/// Three angles or six coordinates with commas between them; nothing if it is something else.
std::optional<DirectionPair> in_out_from(std::string_view text);
std::optional<DirectionPair> half_difference_from(std::string_view text);
std::optional<DirectionPair> directions_from(std::string_view text);

} // namespace refraster
