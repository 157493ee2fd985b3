#pragma once
// The colours of an OBJ file's vertices.

#include <refraster/files.h>

#include "io/mesh/obj_text.h"
#include "io/mesh/triple_index.h"

#include <span>
#include <string>

namespace refraster {

/// Of each vertex of a mesh, (v, vt, vn), the colour of its v, linear; empty where the file has none, or they are
/// ignored. What is taken for something else than it says goes to `notes`. See read_obj.
std::vector<Float3> vertex_colours(const std::string& path, const ObjText& obj,
                                   std::span<const TripleIndex::Triple> vertices, VertexColours taken_as,
                                   NoteList& notes);

} // namespace refraster
