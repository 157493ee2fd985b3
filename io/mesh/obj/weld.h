#pragma once
// Corners of faces become vertices and triangles of a mesh.

#include "io/mesh/obj_text.h"
#include "io/mesh/triple_index.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

struct WeldedFaces {
  std::vector<std::array<std::uint32_t, 3>> triangles; // of all faces, in the order of the file
  RawVector<TripleIndex::Triple>
      vertices; // (v, vt, vn), each once, in the order in which they appear, those with a vt first
};

/// Polygons are cut by triangulate; `steps_left` are its. Throws InputError for one that takes too long; `path` names
/// the file.
WeldedFaces weld(const std::string& path, const ObjText& obj, int threads, std::uint64_t& steps_left);

} // namespace refraster
