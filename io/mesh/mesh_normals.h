#pragma once
// Where the normals of a mesh that is read from a file come from: the key "normals" of an object.

#include <refraster/fields.h>

#include <string>
#include <string_view>
#include <utility>

namespace refraster {

enum class NormalsFrom {
  file,   // what the file says: see read_obj
  smooth, // one normal a vertex: of all faces around it
  flat,   // each face its own
  crease  // of those faces around a vertex that meet at no more than an angle: see crease_degrees
};

/// The words; the crease is an object of JSON.
template <>
struct EnumNames<NormalsFrom> {
  static constexpr std::pair<NormalsFrom, std::string_view> names[] = {
      {NormalsFrom::file, "file"}, {NormalsFrom::smooth, "smooth"}, {NormalsFrom::flat, "flat"}};
};

/// Part of what makes two meshes of one file the same mesh. All but `file` compute every normal from the faces,
/// whatever vn and s say.
struct MeshNormals {
  NormalsFrom from = NormalsFrom::file;
  double crease_degrees = 0; // with NormalsFrom::crease only: 0 to 180
  bool operator==(const MeshNormals&) const = default;
};

/// Of a file with neither vn nor s. The exterior angle of no regular prism, which is 360 / n degrees: 51.4 for 7 sides,
/// 45 for 8. At such an angle rounding would say which edges are sharp.
inline constexpr double crease_degrees_of_files = 50;

/// "file", "smooth", "flat", "crease-30": different for different ones, and good in the name of a file.
std::string name_of(const MeshNormals& normals);

} // namespace refraster
