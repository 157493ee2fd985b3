#pragma once
// `refraster view`, once its arguments are known.

#include "app/command.h"
#include "app/commands/picture_run.h"

namespace refraster {

/// Opens a window on the scene of a run, and comes back when it is closed. The run's output is the pattern of names for
/// pictures, as FrameNames has it. Without a display, says so on standard error: ExitCode::no_opengl. Throws InputError
/// for a scene that cannot be read at the start; later faults are shown in the window.
ExitCode view(const PictureRun& run);

} // namespace refraster
