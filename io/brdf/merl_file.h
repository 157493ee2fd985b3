#pragma once
// The MERL database's `.binary` files: read_merl and write_merl of <refraster/files.h>.

#include <refraster/material.h>

#include <cstdint>
#include <string_view>

namespace refraster {

/// Size of every file: 3 int32 dimensions (90, 90, 180), then planes of red, green and blue doubles, little-endian.
inline constexpr std::uint64_t merl_file_bytes = 12 + std::uint64_t{3 * 8} * MerlTable::samples;

/// A channel's f in 1/sr is the stored value times its scale.
inline constexpr double merl_scale[3] = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};

/// The material's name if the file is one of the 100 of the database's version 2.0; else empty.
std::string_view merl_material_name(std::string_view sha256);

} // namespace refraster
