#pragma once
// Wavefront OBJ: read_obj and write_obj of <refraster/files.h>.

#include <refraster/files.h>

#include "io/mesh/obj_text.h"

#include <cstddef>
#include <string>

namespace refraster {

/// read_obj for the text of such a file; `path` only names it in messages. `chunk_bytes`: see ObjWork.
Mesh mesh_of_obj(const std::string& path, std::string text, const ObjOptions& options = {},
                 std::size_t chunk_bytes = 0);

} // namespace refraster
