#pragma once
// A picture that is written from the window, and how it is made again.

#include <refraster/scene.h>

#include "app/commands/picture_run.h"
#include "app/turntable/frame_names.h"
#include "io/scene/scene_edits.h"

#include <string>
#include <vector>

namespace refraster {

/// What is written of one picture, beside each other.
struct SnapshotFiles {
  std::string image, camera, script; // "hello-001.png", "hello-001.camera.json", "hello-001.sh"
};

/// Those with the first number of which none of the three is there.
SnapshotFiles unused_files(const FrameNames& names);

/// An object as "camera" of a scene file, which reads back as the same camera.
std::string camera_json(const Camera& camera);

/// The words of the command that makes the picture of a run whose scene is changed by `edits`, as in the settings of
/// the window, and seen by `camera`: `refraster render …`. Of the run, its size, samples, curve, precision and AOVs
/// count. `program`: as a shell finds it.
std::vector<std::string> render_words(const std::string& program, const PictureRun& run,
                                      const std::vector<SceneEdit>& edits, const Camera& camera);

/// As it is typed into a shell.
std::string shell_line(const std::vector<std::string>& words);

/// A script for sh that runs them in `folder`; the last word is the image, for which another name may be given to the
/// script.
std::string shell_script(const std::vector<std::string>& words, const std::string& folder);

} // namespace refraster
