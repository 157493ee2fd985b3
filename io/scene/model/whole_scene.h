#pragma once
// A scene written out, to go on from: `refraster scene`.

#include <refraster/files.h>

#include "io/scene/scene_edits.h"

#include <string>
#include <vector>

namespace refraster {

/// The text of a scene file.
struct WholeScene {
  std::string text;
  bool names_outside = false; // whether it names files that lie outside its folder
};

/// The scene of a file or of a model, for a file in `folder`: with these changes, every material of an OBJ file as a
/// block of its own under its name, and paths relative to that folder; all else as the file has it. Materials whose
/// names are no UTF-8, which JSON cannot hold, stay those of the file. Rendering it gives the same image. Throws
/// InputError as read_scene does.
WholeScene whole_scene(const std::string& path, const SceneOptions& options, const std::vector<SceneEdit>& edits,
                       const std::string& folder);

} // namespace refraster
