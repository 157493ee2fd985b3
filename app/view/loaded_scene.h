#pragma once
// A scene as the window has read it, and as it is seen.

#include "app/commands/picture_run.h"
#include "app/view/camera_motion.h"
#include "app/view/settings.h"
#include "io/scene/scene_source.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace refraster {

struct LoadedScene {
  PictureRun run;                      // with the samples and the curve of the scene
  std::optional<std::size_t> function; // one of fragment_function_names() for all objects; none: as the run says
  SceneSource source;
  Ball ball;
  std::vector<std::string> files; // that all of this depends on
};

/// Reads the scene of a run. Throws what read_source() throws; `files` are set then, too, as far as reading came. For
/// one thread at a time, as FileTrace is.
void load(const PictureRun& run, std::optional<std::size_t> function, LoadedScene& loaded);

/// For a picture of this size: from the scene's own camera, or from one that was moved, and with what the settings say
/// of its lights.
Scene seen(const LoadedScene& loaded, const std::optional<Camera>& moved, const ViewSettings& settings, Size size);

/// What has no up vector of the picture any more, but the scene's, so that it can be moved; as long as that is another
/// direction than that of the view.
Camera movable(const LoadedScene& loaded, const Camera& placed);
/// After a move: where the scene has no planes of its own, they follow.
void follow(const LoadedScene& loaded, Camera& moved);

/// Whether both scenes have the same camera, or are to be fitted in the same way.
bool same_own_camera(const LoadedScene& a, const LoadedScene& b);

MotionRates rates_of(const LoadedScene& loaded, Size size);

} // namespace refraster
