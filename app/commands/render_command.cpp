// refraster render SCENE

#include <refraster/files.h>
#include <refraster/notes.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/commands/picture_run.h"
#include "app/diagnostics.h"
#include "app/interrupt.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/parts/image_parts.h"
#include "app/parts/picture_settings.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "io/json/run_report.h"
#include "io/parts/shard.h"
#include "io/scene/triangle_numbers.h"
#include "raster/explain/explain_dark.h"
#include "raster/stopwatch.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace refraster {
namespace {

struct RenderArguments : PictureRun {
  std::optional<PixelRect> crop;
  std::optional<Shard> shard;
  int tile_size = 64;

  /// The file that is written first: of a part its own.
  std::string first_output() const { return shard ? part_name(output, *shard) : output; }
  /// What is divided among shards.
  PixelRect whole() const { return crop.value_or(PixelRect{0, 0, size.width, size.height}); }
  /// What is rendered: of a shard its rows, of which there may be none.
  PixelRect part() const {
    PixelRect rect = whole();
    if (!shard) return rect;
    const RowRange rows = rows_of(*shard, rect.height);
    rect.y += rows.first, rect.height = rows.count;
    return rect;
  }
};

/// Once the size is known.
void check_crop(const RenderArguments& arguments) {
  const PixelRect part = arguments.whole();
  if (part.width > arguments.size.width - part.x || part.height > arguments.size.height - part.y)
    throw UsageError("--crop", "reaches out of the image of " + std::to_string(arguments.size.width) + "x" +
                                   std::to_string(arguments.size.height) + " pixels");
  check_frame_samples(part.width, arguments.part().height, arguments.samples);
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
  RenderOptions options = render_options(arguments, PictureFile::image);
  if (arguments.crop || arguments.shard) options.crop = arguments.part();
  options.tile_size = arguments.tile_size;
  return options;
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
std::vector<std::string> write_images(const Frame& frame, const RenderArguments& arguments, const Settings& settings) {
  const auto line = progress_line(arguments.diagnostics, "writing " + arguments.first_output());
  const RenderOptions options = options_from(arguments);
  if (!arguments.shard) return write_frame(arguments.files, arguments.output, options, frame);
  write_part(arguments.first_output(),
             {.scene = arguments.scene,
              .shard = *arguments.shard,
              .width = arguments.whole().width,
              .height = arguments.whole().height,
              .settings = settings,
              .images = {}},
             rows_of(arguments.files, arguments.output, options, frame));
  return {arguments.first_output()};
}

/// Of a part, by which those of one image are told from others; of a whole image nothing.
Settings settings_of(const RenderArguments& arguments, const SceneSource& source, const Scene& placed) {
  if (!arguments.shard) return {};
  Settings settings = picture_settings(arguments, source, {placed.camera});
  const PixelRect whole = arguments.whole();
  settings.emplace_back("crop", std::to_string(whole.x) + "," + std::to_string(whole.y) + "," +
                                    std::to_string(whole.width) + "," + std::to_string(whole.height));
  return settings;
}

ExitCode run(RenderArguments& arguments) {
  std::vector<std::string> outputs = {arguments.first_output(), arguments.report};
  if (!arguments.shard)
    for (const std::string& path : aov_paths(arguments.files, arguments.output)) outputs.push_back(path);
  check_different(outputs, {arguments.scene});
  for (const std::string& path : outputs)
    if (!path.empty()) check_writable(path);
  prepare_cache(arguments.reading.mesh_cache);

  const Stopwatch reading;
  std::vector<std::string> notes;
  SceneSource source = read_source(arguments, PictureFile::image, &notes);
  check_crop(arguments);
  const Scene scene = SceneSource(source).placed(arguments.size.width, arguments.size.height);
  const Settings settings = settings_of(arguments, source, scene);
  source = {};
  const double read_seconds = reading.seconds();
  const std::vector<Aov> aovs = options_from(arguments).aovs;
  if (std::find(aovs.begin(), aovs.end(), Aov::triangle) != aovs.end())
    check_triangle_numbers(arguments.scene, scene, "--aov triangle");
  if (interrupted()) return ExitCode::interrupted;

  const Frame frame = arguments.part().height > 0 ? rendered(scene, arguments) : Frame();
  if (frame.cancelled || interrupted()) return ExitCode::interrupted;

  const Stopwatch writing;
  const std::vector<std::string> paths = write_images(frame, arguments, settings);
  const double write_seconds = writing.seconds();
  if (!arguments.shard) explain(scene, frame, arguments, notes); // a band may well be dark
  if (!arguments.report.empty()) {
    write_text(arguments.report, report_json({.scene = arguments.scene,
                                              .outputs = paths,
                                              .width = arguments.size.width,
                                              .height = arguments.size.height,
                                              .crop = options_from(arguments).crop,
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
  return {.name = "render",
          .meaning = "Make the image of a scene",
          .groups = {{"Scene", scene_options(a)},
                     {"Image",
                      joined({{file_option("-o,--output", "FILE", a.output,
                                           "image to write: " + output_forms() +
                                               "; by default the scene's name with .png, in the current directory"),
                               size_option(a.asked),
                               value_option("--crop", "X,Y,W,H",
                                            "make only this part of the image, with the same pixels", set_crop)},
                              shading_options(a)})},
                     file_options(a),
                     {"More images", aov_options(a.files)},
                     scene_change_options(a.changes),
                     {"Run", joined({{shard_option(a.shard, "make a band of rows, and write it with its AOVs to "
                                                            "FILE.part-I-of-N: `refraster assemble` joins the parts"),
                                      threads_option(a),
                                      number_choice_option("--tile-size", a.tile_size, {8, 16, 32, 64, 128},
                                                           "pixels along a side of the tiles that threads work on"),
                                      memory_option(a.max_memory),
                                      file_option("--report", "FILE", a.report,
                                                  "write a report of the run as JSON; - is standard output")},
                                     diagnostic_options(a)})}},
          .finish = [arguments]() -> Action {
            if (arguments->output.empty()) arguments->output = stem(arguments->scene) + ".png";
            check_together(*arguments);
            return [arguments] {
              set_limits(*arguments);
              return run(*arguments);
            };
          }};
}

} // namespace refraster
