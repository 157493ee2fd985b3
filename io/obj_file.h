#pragma once
// Wavefront OBJ.

#include "raster/scene.h"

#include <cstdint>
#include <limits>
#include <string>

namespace refraster {

/// Reads all faces of an OBJ file as one mesh, triangles in the order of the file.
///   v, vt, vn   each coordinate is rounded once, to float. A missing vt is (0, 0)
///   f           3 or more corners, also concave; indices from 1, or negative: counted back from the last one given.
///               A polygon with n corners becomes n - 2 triangles of the same winding; a convex one the fan of its
///               first corner. Refused if many thousand corners fold so that cutting takes more than seconds
///   s           corners without vn get the mean normal, weighted by angle, of the faces around the vertex in the
///               same smoothing group that have no vn either. Faces after `s off` or `s 0` are flat. Where no `s` has
///               been given they are smooth, as most viewers show them
///   others      are skipped: o, g, usemtl … say nothing about the shape
/// Vertices are one for each different (v, vt, vn). At most 2 GiB.
/// Throws InputError with all faults, each with its line.
Mesh read_obj(const std::string& path);

/// The same for the text of such a file; `path` only names it in messages.
Mesh mesh_of_obj(const std::string& path, std::string text);

/// Writes a mesh so that read_obj gives it back: the same triangles, and each coordinate bit for bit.
/// Throws OutputError.
void write_obj(const std::string& path, const Mesh& mesh);

} // namespace refraster
