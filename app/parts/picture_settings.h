#pragma once
// What decides the files of a picture, in words.

#include <refraster/scene.h>

#include "app/commands/picture_run.h"
#include "io/parts/settings.h"

#include <vector>

namespace refraster {

/// Of everything that decides what the files of a scene's pictures from these cameras hold, but their names'
/// extensions. To be asked once the scene is read. Throws InputError.
Settings picture_settings(const PictureRun& run, const SceneSource& source, const std::vector<Camera>& cameras);

/// The options of files back from that, as far as they are no extension's. Throws InputError, which names the file at
/// `path`, for what picture_settings() does not give.
void take_file_settings(const std::string& path, const Settings& settings, FrameFiles& files, Transfer& transfer);

} // namespace refraster
