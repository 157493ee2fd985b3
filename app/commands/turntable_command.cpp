// refraster turntable SCENE

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
#include "app/parts/picture_settings.h"
#include "app/progress_line.h"
#include "app/turntable/film.h"
#include "app/turntable/frame_digests.h"
#include "app/turntable/frame_names.h"
#include "app/turntable/orbit.h"
#include "app/usage_error.h"
#include "io/file/sha256.h"
#include "io/parts/shard.h"
#include "io/scene/path/camera_path.h"
#include "raster/stopwatch.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

namespace refraster {
namespace {

constexpr double seconds_between_reports = 1; // what is lost if the process is killed, beside the frame it is at

struct TurntableArguments : PictureRun {
  std::string path;
  int frames = 72, rate = 24;
  std::optional<Shard> shard;

  PictureFile file() const { return is_film(output) ? PictureFile::film : PictureFile::image; }
};

void check_together(TurntableArguments& a) {
  if (is_film(a.output)) {
    if (a.shard)
      throw UsageError("--shard", "makes frames, of which `refraster assemble` makes a film: -o frames/####.png");
    if (a.files.bits != 0 && a.files.bits != 8)
      throw UsageError("--bits", std::to_string(a.files.bits), "8, which a film has");
    if (a.files.background == Background::transparent)
      throw UsageError("--transparent", "is for images, not for films");
    if (a.report.empty()) a.report = a.output + ".json";
    return;
  }
  const std::optional<FrameNames> names = FrameNames::of(a.output);
  if (!names)
    throw UsageError("--output", "\"" + a.output + "\"",
                     "one place for the number of a frame, as in out/####.png; or a film, as out.mp4");
  check_output(a.files, names->name(0), a.asked.transfer.value_or(Transfer::linear), a.diagnostics);
  if (a.shard && !a.report.empty()) throw UsageError("--report", "stands beside the frames of --shard");
  if (a.report.empty()) a.report = a.shard ? part_name(names->report_name(), *a.shard) : names->report_name();
}

std::vector<Camera> cameras_of(const SceneSource& source, const TurntableArguments& a) {
  if (a.path.empty() && source.view.fit) return fitted_orbit(source, a.size.width, a.size.height, a.frames);
  const Scene placed = SceneSource(source).placed(a.size.width, a.size.height);
  if (a.path.empty()) return orbit(placed.camera, a.frames);
  std::vector<Camera> cameras;
  Scene scene = source.scene;
  for (const PathCamera& one : read_cameras(a.path, placed.camera)) {
    scene.camera = one.camera;
    if (one.fit)
      place(scene, {.fit = one.fit, .moving_point_lights = {}, .moving_direction_lights = {}, .picture = {}},
            a.size.width, a.size.height);
    cameras.push_back(scene.camera);
  }
  return cameras;
}

/// Renders one frame after the other, in the memory of the one before.
class FrameSource {
public:
  FrameSource(SceneSource source, const TurntableArguments& a)
      : source_(std::move(source)), scene_(source_.scene), options_(render_options(a, a.file())) {
    source_.view.fit.reset(); // cameras are made already
  }

  const RenderOptions& options() const { return options_; }
  /// Null if it was interrupted.
  const Frame* render(const Camera& camera) {
    scene_.camera = camera;
    std::apply([&](auto... list) { ((scene_.*list = source_.scene.*list), ...); }, light_lists);
    place(scene_, source_.view, options_.width, options_.height); // lights that move with it
    renderer_.render(scene_, options_, frame_);
    return frame_.cancelled || interrupted() ? nullptr : &frame_;
  }

private:
  SceneSource source_;
  Scene scene_;
  RenderOptions options_;
  Renderer renderer_;
  Frame frame_;
};

ExitCode make_film(const TurntableArguments& a, const std::vector<Camera>& cameras, FrameSource& frames,
                   FrameDigests& known) {
  Film film(a.output, a.size.width, a.size.height, a.rate);
  const auto line = progress_line(a.diagnostics, "making " + a.output);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    const Frame* const frame = frames.render(cameras[i]);
    if (!frame) return ExitCode::interrupted;
    film.add(frame->rgb8);
    known.digests[i] = pixels_sha256(frame->rgb8);
    if (line) line->show(static_cast<double>(i + 1) / static_cast<double>(cameras.size()));
  }
  film.finish();
  write_text(a.report, digests_json(known));
  return ExitCode::ok;
}

ExitCode make_frames(const TurntableArguments& a, const std::vector<Camera>& cameras, FrameSource& frames,
                     FrameDigests& known) {
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < cameras.size(); ++i)
    if (!a.shard || has_frame(*a.shard, i)) own.push_back(i);
  const std::size_t there = take_known_frames(a.report, known), all = own.size();
  if (there > 0)
    print_note(std::to_string(there) + " of " + std::to_string(all) + " frames are there, as " + a.report +
                   " says, and are not made again",
               a.diagnostics);
  const auto line = progress_line(a.diagnostics, "rendering " + std::to_string(all - there) + " frames");
  Stopwatch since_report;
  std::size_t made = 0;
  for (const std::size_t i : own) {
    if (!known.digests[i].empty()) continue;
    const Frame* const frame = frames.render(cameras[i]);
    if (!frame) {
      write_text(a.report, digests_json(known));
      return ExitCode::interrupted;
    }
    write_frame(a.files, known.frames[i], frames.options(), *frame);
    known.digests[i] = file_sha256(known.frames[i]);
    if (since_report.seconds() > seconds_between_reports) {
      write_text(a.report, digests_json(known));
      since_report = Stopwatch();
    }
    if (line) line->show(static_cast<double>(++made) / static_cast<double>(all - there));
  }
  write_text(a.report, digests_json(known));
  return ExitCode::ok;
}

ExitCode run(TurntableArguments& a) {
  const bool film = is_film(a.output);
  check_different({a.output, a.report}, {a.scene, a.path});
  if (const std::string folder = std::filesystem::path(a.output).parent_path(); !film && !folder.empty())
    prepare_folder(folder);
  const std::string first = film ? a.output : FrameNames::of(a.output)->name(0);
  check_writable(first);
  check_writable(a.report);
  prepare_cache(a.reading.mesh_cache);

  SceneSource source = read_source(a, a.file());
  const std::vector<Camera> cameras = cameras_of(source, a);
  if (interrupted()) return ExitCode::interrupted;
  FrameDigests known{a.scene, picture_settings(a, source, cameras), std::vector<std::string>(cameras.size()),
                     std::vector<std::string>(cameras.size()), a.shard};
  for (std::size_t i = 0; i < cameras.size() && !film; ++i) known.frames[i] = FrameNames::of(a.output)->name(i);
  FrameSource frames(std::move(source), a);
  const ExitCode code = film ? make_film(a, cameras, frames, known) : make_frames(a, cameras, frames, known);
  if (code != ExitCode::ok) return code;
  if (film) std::cout << a.output << "\n";
  for (std::size_t i = 0; i < known.frames.size() && !film; ++i)
    if (!known.digests[i].empty()) std::cout << known.frames[i] << "\n";
  return code;
}

} // namespace

Command turntable_command() {
  const auto arguments = std::make_shared<TurntableArguments>();
  TurntableArguments& a = *arguments;
  return {
      .name = "turntable",
      .meaning = "Make frames around a scene, or along a path of cameras",
      .groups =
          {{"Scene",
            joined({scene_options(a),
                    {number_option("--frames", a.frames, Range{1, max_frames},
                                   "of a whole turn around the camera's target, about its up"),
                     file_option("--camera-path", "FILE", a.path,
                                 "a JSON list of cameras, each as \"camera\" of a scene, one a frame; what one leaves "
                                 "out is as in the scene; in place of --frames")}})},
           {"Image",
            joined({{file_option("-o,--output", "FILE", a.output,
                                 "frames to write, with # for the digits of their numbers, which begin at 1, as "
                                 "out/####.png: " +
                                     output_forms() + "; or a film, as out.mp4, by ffmpeg")
                         .required(),
                     size_option(a.asked)},
                    shading_options(a),
                    {number_option("--rate", a.rate, Range{1, 240}, "frames a second of a film")}})},
           file_options(a),
           scene_change_options(a.changes),
           {"Run", joined({{shard_option(a.shard, "make frames I, I + N, I + 2 N and so on: `refraster assemble` "
                                                  "joins the parts"),
                            threads_option(a), memory_option(a.max_memory),
                            file_option("--report", "FILE", a.report,
                                        "what is known of the frames, as JSON, by which an interrupted run goes on; by "
                                        "default beside them")},
                           diagnostic_options(a)})}},
      .notes =
          {"Frames that are there and whole, as the report beside them says, are not made again: an interrupted run "
           "goes on where it was. Another scene, other options or another version of the program begin anew. A "
           "film is made as a whole."},
      .finish = [arguments]() -> Action {
        check_together(*arguments);
        return [arguments] {
          set_limits(*arguments);
          return run(*arguments);
        };
      }};
}

} // namespace refraster
