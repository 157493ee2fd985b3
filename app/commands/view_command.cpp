// refraster view SCENE

#include "app/arguments.h"
#include "app/command.h"
#include "app/commands/picture_run.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/turntable/frame_names.h"
#include "app/usage_error.h"
#include "app/view/keys.h"
#include "app/view/viewer.h"

#include <memory>

namespace refraster {
namespace {

void check_together(PictureRun& run) {
  if (run.output.empty()) run.output = stem(run.scene) + "-###.png";
  const std::optional<FrameNames> names = FrameNames::of(run.output);
  if (!names)
    throw UsageError("--output", "\"" + run.output + "\"", "one place for the number of a picture, as in out/###.png");
  check_output(run.files, names->name(0), run.asked.transfer.value_or(Transfer::linear), run.diagnostics);
}

std::vector<std::string> notes() {
  std::vector<std::string> notes = {
      "While the camera moves, the picture is in float, and as fine as 30 frames a second allow; as soon as it stands "
      "still, it is the image that `refraster render` makes. Files that change are read again. docs/view.md says more.",
      "Exit code 5: no display, no SDL2 on this machine, or a program that was built without a window.",
      "Keys and the mouse:"};
  for (const KeyLine& line : key_lines()) notes.push_back(key_note(line));
  return notes;
}

} // namespace

Command view_command() {
  const auto run = std::make_shared<PictureRun>();
  PictureRun& r = *run;
  return {.name = "view",
          .meaning = "Look around in a scene, in a window",
          .groups = {{"Scene", scene_options(r)},
                     {"Window",
                      joined({{size_option(r.asked, "pixels of the window; less where the display has no room")},
                              shading_options(r),
                              {file_option("-o,--output", "FILE", r.output,
                                           "pictures that the key P writes, with # for the digits of their numbers: " +
                                               output_forms() +
                                               "; by default the scene's name with -###.png, in the current "
                                               "directory. Names that are there are left out")}})},
                     scene_change_options(r.changes),
                     {"Run", joined({{threads_option(r), memory_option(r.max_memory)}, diagnostic_options(r)})}},
          .notes = notes(),
          .finish = [run]() -> Action {
            check_together(*run);
            return [run] {
              set_limits(*run);
              return view(*run);
            };
          }};
}

} // namespace refraster
