#pragma once
// Wavefront OBJ.

#include <refraster/scene.h>

#include "io/file/notes.h"
#include "io/mesh/mesh_normals.h"

#include <string>

namespace refraster {

struct ObjOptions {
  MeshNormals normals = {};
  NoteList* notes = nullptr; // where remarks on the file go; nowhere if null
};

/// Reads all faces of an OBJ file as one mesh, triangles in the order of the file.
///   v, vt, vn   each coordinate is rounded once, to float. A face without vt at all its corners has none
///   f           3 or more corners, also concave; indices from 1, or negative: counted back from the last one given.
///               A polygon with n corners becomes n - 2 triangles of the same winding; a convex one the fan of its
///               first corner. Refused if many thousand corners fold so that cutting takes more than seconds
///   s           corners without vn get the mean normal, weighted by angle, of those faces around the vertex that have
///               no vn there either and belong together: those in the same smoothing group. Faces before the first `s`
///               and after `s off` are flat. In a file without any `s` they are those that share an edge there and
///               enclose at most crease_degrees_of_files, and the faces that so belong to one of these
///   others      say nothing about the shape, or are not read: see obj_notes.h
/// Two corners of a face in one place, named twice or not told apart by floats, count as one. A sum of normals that
/// rounding may have left of nothing is 0: so is the vertex's normal, and that of a face without area.
/// Vertices are one for each different (v, vt, vn), numbered as they appear, those with a vt first. At most 2 GiB.
/// What is unusual but has one meaning is read, and noted; so is what is left out.
/// Throws InputError with all faults, each with its line.
Mesh read_obj(const std::string& path, const ObjOptions& options = {});

/// The same for the text of such a file; `path` only names it in messages.
Mesh mesh_of_obj(const std::string& path, std::string text, const ObjOptions& options = {});

/// Writes a mesh so that read_obj gives it back: the same triangles, and each coordinate bit for bit; but for texture
/// coordinates of triangles of which not all corners have some.
/// Throws OutputError.
void write_obj(const std::string& path, const Mesh& mesh);

} // namespace refraster
