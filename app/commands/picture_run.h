#pragma once
// What the commands that make pictures of a scene have in common: their arguments, and what these ask for.

#include <refraster/files.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/commands/write_frame.h"
#include "app/diagnostics.h"
#include "app/options/option.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "io/scene/scene_source.h"

#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

struct PictureRun {
  std::string scene, output, report;
  PictureArguments asked; // what of the next three does not follow from the scene
  Size size;
  int samples = 1;
  Transfer transfer = Transfer::linear;
  std::string precision = "double";
  int threads = 0;
  FrameFiles files;
  SceneOptions reading;
  SceneChanges changes;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

/// The argument SCENE, and how it is read.
std::vector<Option> scene_options(PictureRun& run);
/// --precision, --samples, --srgb, --linear.
std::vector<Option> shading_options(PictureRun& run);
/// --bits, --quality, --transparent.
OptionGroup file_options(PictureRun& run);
/// --threads.
Option threads_option(PictureRun& run);
/// --strict, --quiet.
std::vector<Option> diagnostic_options(PictureRun& run);

/// Whether the picture becomes an image, in a format of its own, or a frame of a film, of whole numbers.
enum class PictureFile { image, film };

/// Lets no more memory be taken than asked for, and has as many threads read as render. Before anything is read.
void set_limits(PictureRun& run);

/// The scene; the image that it says where no option does is put into `run`. The notes on its files are printed, and
/// added to `said` if it is not null.
SceneSource read_source(PictureRun& run, PictureFile file, std::vector<std::string>* said = nullptr);

/// What to render, once the size is known.
RenderOptions render_options(const PictureRun& run, PictureFile file);

} // namespace refraster
