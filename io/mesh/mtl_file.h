#pragma once
// Material libraries: .mtl files, which describe the materials that an OBJ file names.

#include <refraster/mesh.h>
#include <refraster/notes.h>

#include <string>
#include <vector>

namespace refraster {

/// The materials of a library, in the order of the file, each name once: the first that has it. Nothing in such a file
/// is a fault: what cannot be read is noted, each kind once, and left out. `file` names it in notes and materials.
std::vector<MeshMaterial> parse_mtl(const std::string& file, std::string text, NoteList& notes);

/// The same from disk. Throws InputError for a file that cannot be read, or is larger than limit::mtl_bytes.
std::vector<MeshMaterial> read_mtl(const std::string& path, NoteList& notes);

} // namespace refraster
