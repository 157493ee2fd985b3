#pragma once
// Options that change a scene before it is read: from where it is seen, and any value of its file.

#include "app/options/option.h"
#include "io/scene/scene_edits.h"

#include <string>
#include <vector>

namespace refraster {

/// What was asked for.
struct SceneChanges {
  std::vector<SceneEdit> view;   // --camera
  std::vector<SceneEdit> values; // of other options that have a name for what they change
  std::vector<SceneEdit> set;    // --set, in the order given

  /// All of them, in an order in which each has its effect: a camera with a fit first, --set last.
  std::vector<SceneEdit> edits() const;
};

/// The names of the library's fragment functions.
std::vector<std::string> fragment_function_names();
/// What --fragment-function changes.
SceneEdit fragment_function_edit(const std::string& name);

/// --camera, --look-at, --fov, --up, --background, --fragment-function, --set: for every command that reads scenes.
OptionGroup scene_change_options(SceneChanges& changes);

} // namespace refraster
