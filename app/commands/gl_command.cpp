// refraster gl SCENE

#include <refraster/files.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/commands/probe_run.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "gl/drawn_by_gl.h"
#include "gl/gl_report.h"
#include "gl/render_gl.h"
#include "io/scene/scene_source.h"
#include "io/scene/triangle_numbers.h"
#include "raster/explain/explain_dark.h"
#include "suite/judging/fewer_samples.h"

#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct GlArguments {
  std::string scene, output, radiance, depth, ids, json;
  PictureArguments picture;
  SceneOptions reading;
  SceneChanges changes;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
  GlOptions options;
  bool probes = false; // instead of drawing a scene
  std::string device;  // to compare with what is probed
};

void write_outputs(const GlArguments& a, const GlOptions& options, const GlFrame& frame) {
  if (!a.output.empty()) write_image(a.output, frame.rgb8);
  if (!a.radiance.empty()) write_image(a.radiance, frame.radiance);
  if (!a.depth.empty()) write_image(a.depth, frame.depth);
  if (!a.ids.empty()) write_values(a.ids, frame.ids, {"object", "triangle"});
  if (!a.json.empty()) write_text(a.json, gl_report_json(a.scene, options, frame));
}

/// Why OpenGL's image shows nothing, where that has a reason in the scene; empty if it shows something.
std::string why_dark(const Scene& scene, const GlOptions& options, const GlFrame& frame) {
  if (frame.rgb8.empty() && frame.radiance.empty()) return {};
  RenderOptions view;
  view.width = options.width, view.height = options.height, view.samples = options.samples;
  view.want_rgb8 = !frame.rgb8.empty(), view.transfer = options.transfer;
  return explain_dark_image(scene, view, {frame.rgb8, frame.radiance}, std::nullopt);
}

ExitCode run(const GlArguments& a) {
  const std::vector<std::string> outputs = {a.output, a.radiance, a.depth, a.ids, a.json};
  check_different(outputs, {a.scene});
  for (const std::string& path : outputs)
    if (!path.empty()) check_writable(path);
  prepare_cache(a.reading.mesh_cache);
  GlOptions options = a.options;
  options.want_rgb8 = !a.output.empty();
  options.want_radiance = !a.radiance.empty();
  options.want_depth = !a.depth.empty();
  options.want_ids = !a.ids.empty();

  GlFrame frame;
  std::string note;
  try {
    NoteList notes;
    SceneOptions reading = a.reading;
    reading.notes = &notes;
    auto line = progress_line(a.diagnostics, "reading " + a.scene);
    SceneSource source = read_scene_source(a.scene, reading, a.changes.edits());
    const Picture picture = a.picture.over(source.view.picture);
    options.width = picture.width, options.height = picture.height;
    options.samples = picture.samples, options.transfer = picture.transfer;
    const Scene scene = std::move(source).placed(options.width, options.height);
    line.reset(); // before anything is printed
    print_file_notes(notes, a.diagnostics);
    check_drawn_by_gl(a.scene, scene);
    if (options.want_ids) check_triangle_numbers(a.scene, scene, "--ids");
    line = progress_line(a.diagnostics, "drawing " + a.scene);
    std::string fewer;
    frame =
        draw_with_samples(options.samples, a.picture.samples, fewer, [&](int) { return render_gl(scene, options); });
    line.reset();
    if (!fewer.empty()) print_note(fewer, a.diagnostics);
    note = why_dark(scene, options, frame);
  } catch (const NoOpenGl& error) {
    std::cerr << "refraster: " << error.what() << "\n";
    return ExitCode::no_opengl;
  }
  if (a.diagnostics.verbosity == Verbosity::normal) {
    for (const std::string& line : frame.shaders) std::cerr << line << "\n";
    for (const std::string& line : frame.warnings) std::cerr << "warning: " << line << "\n";
  }
  if (!note.empty()) print_note(note, a.diagnostics);
  write_outputs(a, options, frame);
  if (a.json == standard_output) return ExitCode::ok; // which then holds the report and nothing else
  for (const std::string& path : {a.output, a.radiance, a.depth, a.ids})
    if (!path.empty()) std::cout << path << "\n";
  return ExitCode::ok;
}

/// What one option alone does not show; and the default output.
void check_together(GlArguments& a) {
  if (a.output.empty() && a.radiance.empty() && a.depth.empty() && a.ids.empty() && a.json.empty())
    a.output = stem(a.scene) + ".gl.png";
  if (!a.output.empty()) check_extension("--output", a.output, {rgb8_image});
  if (!a.radiance.empty()) check_extension("--float", a.radiance, {float_rgb_image});
  if (!a.depth.empty()) check_extension("--depth", a.depth, {float_grey_image});
  if (!a.ids.empty()) check_extension("--ids", a.ids, {float_grey_image});
  if (a.picture.size) check_frame_samples(a.picture.size->width, a.picture.size->height, a.picture.samples.value_or(1));
}

/// What is done instead of drawing a scene. Throws UsageError for what only a scene has.
Action probing(const GlArguments& a) {
  const std::pair<const char*, bool> of_a_scene[] = {{"SCENE", !a.scene.empty()},
                                                     {"--float", !a.radiance.empty()},
                                                     {"--depth", !a.depth.empty()},
                                                     {"--json", !a.json.empty()},
                                                     {"--frames", a.options.timed_frames > 0},
                                                     {"--cache", !a.reading.mesh_cache.empty()}};
  for (const auto& [name, is_given] : of_a_scene)
    if (is_given) throw UsageError("gl", std::string(name) + " beside --probe", "one of the two");
  return [probe = ProbeArguments{a.output, a.device, a.options.renderer, a.diagnostics}] { return run_probe(probe); };
}

} // namespace

Command gl_command() {
  const auto arguments = std::make_shared<GlArguments>();
  GlArguments& a = *arguments;
  Option scene = scene_argument(a.scene);
  scene.occurs = Occurs::at_most_once; // --probe needs none
  return {
      .name = "gl",
      .meaning = "Make the image of a scene with OpenGL",
      .groups =
          {{"Scene",
            {scene, outside_option(a.reading.outside), exposure_option(a.reading.exposure_stops),
             shadow_option(a.reading), cache_option(a.reading.mesh_cache)}},
           {"Image",
            {file_option("-o,--output", "FILE.png", a.output,
                         "8-bit image to write, read back from an RGBA8 target; by default, if no other file is asked "
                         "for, the scene's name with .gl.png, in the current directory; with --probe the profile"),
             file_option("--float", "FILE", a.radiance,
                         "unclamped image to write, read back from an RGBA32F target: " +
                             writable_extensions({float_rgb_image})),
             file_option("--depth", "FILE", a.depth,
                         "window depth to write, 1 where nothing was drawn: " +
                             writable_extensions({float_grey_image})),
             file_option("--ids", "FILE", a.ids,
                         "numbers of object and triangle to write, each counted from 1, 0 where nothing was drawn: " +
                             writable_extensions({float_grey_image})),
             size_option(a.picture),
             samples_option(a.picture,
                            "samples a pixel, where and as the driver resolves them; depth and ids are those of "
                            "sample 0"),
             srgb_option(a.picture, "read the 8-bit image back as floats, and apply the sRGB curve to them"),
             linear_option(a.picture)}},
           scene_change_options(a.changes),
           {"OpenGL",
            {enum_option("--renderer", a.options.renderer, "who draws; the software drivers are Mesa's"),
             enum_option("--merl-filter", a.options.merl_filter,
                         "how our GLSL reads a measured table between its samples"),
             number_option("--frames", a.options.timed_frames, Range{0, 1'000'000},
                           "draw so many more frames and time each; see --json")}},
           {"Device",
            {flag(
                 "--probe", [&a] { a.probes = true; },
                 "draw no scene, but measure the device and write its profile, JSON, to --output, or to standard "
                 "output; docs/devices.md"),
             text_option("--device", "NAME|FILE", a.device,
                         "with --probe: compare with this profile, and measure its renderer in its environment; exit "
                         "code 1 if more was measured than it allows")}},
           {"Run",
            {memory_option(a.max_memory),
             file_option("--json", "FILE", a.json, "write driver, times and counts as JSON; - is standard output"),
             strict_option(a.diagnostics), quiet_option(a.diagnostics)}}},
      .notes = {"An object is drawn by the GLSL files that the scene names where they exist, else by our own GLSL of "
                "the same formulas; a line on standard error says which. docs/glsl-interface.md: what a shader is "
                "given.",
                "Exit code 3: GLSL that does not compile, link or draw. 5: no OpenGL 3.3, not the renderer or not the "
                "number of samples that was asked for."},
      .finish = [arguments]() -> Action {
        if (arguments->probes) return probing(*arguments);
        if (!arguments->device.empty()) throw UsageError("gl", "--device without --probe", "both");
        if (arguments->scene.empty())
          throw UsageError("gl", "nothing", "SCENE (scene file or OBJ model; docs/scene-format.md), or --probe");
        check_together(*arguments);
        return [arguments] {
          arguments->reading.memory = set_memory_limit(arguments->max_memory, 1);
          clear_memory_limit(); // drivers do not bear it
          return run(*arguments);
        };
      }};
}

} // namespace refraster
