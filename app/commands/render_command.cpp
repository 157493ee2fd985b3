// refraster render SCENE

#include <refraster/files.h>
#include <refraster/notes.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/commands/write_frame.h"
#include "app/diagnostics.h"
#include "app/interrupt.h"
#include "app/memory_limit.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/run_report.h"
#include "app/usage_error.h"
#include "io/scene/scene_source.h"
#include "raster/explain/explain_dark.h"
#include "raster/stopwatch.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace refraster {
namespace {

struct RenderArguments {
  std::string scene, output, report;
  PictureArguments asked; // what of the next three does not follow from the scene
  Size size;
  std::optional<PixelRect> crop;
  std::string precision = "double";
  int samples = 1, threads = 0, tile_size = 64;
  Transfer transfer = Transfer::linear;
  FrameFiles files;
  SceneOptions reading;
  SceneChanges changes;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

/// Once the size is known.
void check_crop(const RenderArguments& arguments) {
  const PixelRect part = arguments.crop.value_or(PixelRect{0, 0, arguments.size.width, arguments.size.height});
  if (part.width > arguments.size.width - part.x || part.height > arguments.size.height - part.y)
    throw UsageError("--crop", "reaches out of the image of " + std::to_string(arguments.size.width) + "x" +
                                   std::to_string(arguments.size.height) + " pixels");
  check_frame_samples(part.width, part.height, arguments.samples);
}

/// What one option alone does not show.
void check_together(RenderArguments& arguments) {
  if (arguments.asked.size) {
    arguments.size = *arguments.asked.size, arguments.samples = arguments.asked.samples.value_or(1);
    check_crop(arguments);
  }
  check_output(arguments.files, arguments.output, arguments.asked.transfer.value_or(Transfer::linear),
               arguments.diagnostics);
}

RenderOptions options_from(const RenderArguments& arguments) {
  RenderOptions options;
  options.width = arguments.size.width;
  options.height = arguments.size.height;
  options.crop = arguments.crop;
  options.precision = value_named<Precision>(arguments.precision).value();
  options.samples = arguments.samples;
  options.threads = arguments.threads;
  options.tile_size = arguments.tile_size;
  ask_for_output(arguments.files, arguments.output, options);
  options.transfer = arguments.transfer;
  options.cancel = &interrupted();
  options.memory = arguments.reading.memory;
  return options;
}

/// The image that the scene says where no option does.
void complete(RenderArguments& arguments, const Picture& of_scene) {
  const Picture picture = arguments.asked.over(of_scene);
  arguments.size = {picture.width, picture.height}, arguments.samples = picture.samples;
  arguments.transfer = writes_radiance(arguments.files, arguments.output) ? Transfer::linear : picture.transfer;
  check_crop(arguments);
}

/// The scene, placed for the image; the notes on its files are printed, and put into `said`.
Scene scene_of(RenderArguments& arguments, std::vector<std::string>& said) {
  NoteList notes;
  auto line = progress_line(arguments.diagnostics, "reading " + arguments.scene);
  SceneOptions reading = arguments.reading;
  reading.notes = &notes;
  SceneSource source = read_scene_source(arguments.scene, reading, arguments.changes.edits());
  complete(arguments, source.view.picture);
  Scene scene = std::move(source).placed(arguments.size.width, arguments.size.height);
  line.reset(); // before anything is printed
  print_file_notes(notes, arguments.diagnostics);
  for (const Note& note : notes.notes()) said.push_back(note.text());
  return scene;
}

/// A note on an image that shows nothing, printed and put into `said`.
void explain(const Scene& scene, const Frame& frame, const RenderArguments& arguments, std::vector<std::string>& said) {
  const std::string note =
      explain_dark_image(scene, options_from(arguments), {frame.rgb8, frame.radiance}, frame.counts.shaded);
  if (note.empty()) return;
  print_note(note, arguments.diagnostics);
  said.push_back(note);
}

Frame rendered(const Scene& scene, const RenderArguments& arguments) {
  const auto line = progress_line(arguments.diagnostics, "rendering");
  RenderOptions options = options_from(arguments);
  if (line) options.progress = [&line](double fraction) { line->show(fraction); };
  return render(scene, options);
}

/// Writes what was asked for and gives the paths.
std::vector<std::string> write_images(const Frame& frame, const RenderArguments& arguments) {
  const auto line = progress_line(arguments.diagnostics, "writing " + arguments.output);
  return write_frame(arguments.files, arguments.output, options_from(arguments), frame);
}

ExitCode run(RenderArguments& arguments) {
  std::vector<std::string> outputs = {arguments.output, arguments.report};
  for (const std::string& path : aov_paths(arguments.files, arguments.output)) outputs.push_back(path);
  check_different(outputs, {arguments.scene});
  for (const std::string& path : outputs)
    if (!path.empty()) check_writable(path);
  prepare_cache(arguments.reading.mesh_cache);

  const Stopwatch reading;
  std::vector<std::string> notes;
  const Scene scene = scene_of(arguments, notes);
  const double read_seconds = reading.seconds();
  const std::vector<Aov> aovs = options_from(arguments).aovs;
  if (std::find(aovs.begin(), aovs.end(), Aov::triangle) != aovs.end())
    check_triangle_numbers(arguments.scene, scene, "--aov triangle");
  if (interrupted()) return ExitCode::interrupted;

  const Frame frame = rendered(scene, arguments);
  if (frame.cancelled || interrupted()) return ExitCode::interrupted;

  const Stopwatch writing;
  const std::vector<std::string> paths = write_images(frame, arguments);
  const double write_seconds = writing.seconds();
  explain(scene, frame, arguments, notes);
  if (!arguments.report.empty()) {
    write_text(arguments.report, report_json({.scene = arguments.scene,
                                              .outputs = paths,
                                              .width = arguments.size.width,
                                              .height = arguments.size.height,
                                              .crop = arguments.crop,
                                              .precision = arguments.precision,
                                              .samples = arguments.samples,
                                              .tile_size = arguments.tile_size,
                                              .threads = frame.threads,
                                              .read_seconds = read_seconds,
                                              .write_seconds = write_seconds,
                                              .seconds = frame.seconds,
                                              .counts = frame.counts,
                                              .notes = notes}));
  }
  if (arguments.report == standard_output) return ExitCode::ok; // which then holds the report and nothing else
  for (const std::string& path : paths) std::cout << path << "\n";
  return ExitCode::ok;
}

} // namespace

Command render_command() {
  const auto arguments = std::make_shared<RenderArguments>();
  RenderArguments& a = *arguments;
  const auto set_crop = [&a](const std::string& text) -> std::optional<ValueFault> {
    a.crop = crop_from(text);
    if (!a.crop) return ValueFault{"x,y,width,height in pixels from the top left"};
    return std::nullopt;
  };
  return {
      .name = "render",
      .meaning = "Make the image of a scene",
      .groups =
          {{"Scene",
            {scene_argument(a.scene), outside_option(a.reading.outside), exposure_option(a.reading.exposure_stops),
             cache_option(a.reading.mesh_cache)}},
           {"Image",
            {file_option("-o,--output", "FILE", a.output,
                         "image to write: " + output_forms() +
                             "; by default the scene's name with .png, in the current directory"),
             size_option(a.asked),
             value_option("--crop", "X,Y,W,H", "make only this part of the image, with the same pixels", set_crop),
             choice_option("--precision", a.precision, precision_names(),
                           "number type of shading; `refraster list precisions`"),
             samples_option(a.asked, "samples a pixel, at the standard positions; shaded once a triangle"),
             srgb_option(a.asked, "apply the sRGB curve (not to floats)"), linear_option(a.asked)}},
           {"Files", {bits_option(a.files), quality_option(a.files), transparent_option(a.files)}},
           {"More images", aov_options(a.files)},
           scene_change_options(a.changes),
           {"Run",
            {number_option("--threads", a.threads, Range{0, double(limit::threads.value)},
                           "threads; 0: as many as this machine has"),
             number_choice_option("--tile-size", a.tile_size, {8, 16, 32, 64, 128},
                                  "pixels along a side of the tiles that threads work on"),
             memory_option(a.max_memory),
             file_option("--report", "FILE", a.report, "write a report of the run as JSON; - is standard output"),
             strict_option(a.diagnostics), quiet_option(a.diagnostics)}}},
      .finish = [arguments]() -> Action {
        if (arguments->output.empty()) arguments->output = stem(arguments->scene) + ".png";
        check_together(*arguments);
        return [arguments] {
          arguments->reading.memory = set_memory_limit(arguments->max_memory, arguments->threads);
          return run(*arguments);
        };
      }};
}

} // namespace refraster
