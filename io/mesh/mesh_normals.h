#pragma once
// The key "normals" of an object: MeshNormals of <refraster/files.h>.

#include <refraster/files.h>

#include <string>

namespace refraster {

/// Of a file with neither vn nor s. The exterior angle of no regular prism, which is 360 / n degrees: 51.4 for 7 sides,
/// 45 for 8. At such an angle rounding would say which edges are sharp.
inline constexpr double crease_degrees_of_files = 50;

/// "file", "smooth", "flat", "crease-30": different for different ones, and good in the name of a file.
std::string name_of(const MeshNormals& normals);

/// Of all options that make another mesh of the same file: "smooth", "crease-30.srgb".
std::string name_of(const ObjOptions& options);

} // namespace refraster
