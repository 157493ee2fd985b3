#pragma once
// A scene as its file has it: what depends on the image is not placed yet.

#include <refraster/files.h>

#include "io/scene/material_texture.h"
#include "io/scene/scene_edits.h"
#include "raster/vertex/scene_view.h"

#include <map>
#include <string>
#include <vector>

namespace refraster {

/// Where a texture is from, and what its file's numbers were taken as.
struct TextureFile {
  std::string path; // canonical
  TextureReading reading = {};
};
using TextureFiles = std::map<const Texture*, TextureFile>;

/// What was read.
struct SceneSource {
  Scene scene; // with what the view says still to be placed
  SceneView view;
  TextureFiles textures; // those of the scene

  /// For an image of this size.
  Scene placed(int width, int height) && {
    place(scene, view, width, height);
    return std::move(scene);
  }
};

/// As read_scene of <refraster/files.h>, with changes to the text before it is read.
SceneSource read_scene_source(const std::string& path, const SceneOptions& options,
                              const std::vector<SceneEdit>& edits = {});

} // namespace refraster
