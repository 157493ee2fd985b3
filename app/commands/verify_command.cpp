// refraster verify SCENE ACTUAL, refraster verify SCENE --gl

#include <refraster/files.h>
#include <refraster/notes.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "suite/judging/verify_scene.h"

#include <algorithm>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

struct VerifyArguments {
  std::string scene, actual, json, html, device;
  DeviceImageRequest image;
  SceneOptions reading;
  SceneChanges changes;
  std::optional<ShaderMatrices> matrices;
  std::optional<GlRenderer> renderer;
  PictureArguments asked; // the size is for OpenGL
  JudgedSource source = JudgedSource::file;
  std::vector<ClassLimit> limits;
  std::uint64_t max_memory = 0;
  Diagnostics diagnostics;
};

/// "edge" or "edge:12".
std::optional<ValueFault> add_limit(std::string_view text, std::vector<ClassLimit>& limits) {
  const std::size_t colon = text.find(':');
  const std::string name(text.substr(0, colon));
  const std::optional<PixelClass> pixel_class = value_named<PixelClass>(name);
  if (!pixel_class || *pixel_class == PixelClass::exact) {
    std::string classes;
    for (const auto& [value, listed] : EnumNames<PixelClass>::names)
      if (value != PixelClass::exact) classes += (classes.empty() ? "" : ", ") + std::string(listed);
    return ValueFault{"one of " + classes + ", perhaps followed by :COUNT", name};
  }
  std::uint64_t most = 0;
  if (colon != std::string::npos) {
    const std::optional<std::uint64_t> count = count_from(text.substr(colon + 1));
    if (!count) return ValueFault{"a whole number >= 0 behind the colon", std::string(text.substr(colon + 1))};
    most = *count;
  }
  limits.push_back({*pixel_class, most});
  return std::nullopt;
}

/// What is done with the scene that was read.
VerifyTask task_of(const VerifyArguments& a, const Picture& of_scene, const MemoryBudget& memory) {
  const bool is_told = a.diagnostics.verbosity == Verbosity::normal || !a.json.empty() || !a.html.empty();
  return {.scene = a.scene,
          .actual = a.actual,
          .source = a.source,
          .image = a.image,
          .device = a.device,
          .renderer = a.renderer,
          .matrices = a.matrices,
          .picture = a.asked.over(of_scene),
          .asked_samples = a.asked.samples,
          .asked_transfer = a.asked.transfer,
          .limits = a.limits,
          .causes = is_told ? CauseSearch::done : CauseSearch::left_out,
          .memory = memory};
}

ExitCode run(VerifyArguments& a) {
  const MemoryBudget memory = set_memory_limit(a.max_memory, 1);
  if (a.source != JudgedSource::file) clear_memory_limit(); // drivers do not bear it
  a.reading.memory = memory;
  check_different({a.json, a.html}, {a.scene, a.actual, a.image.ids, a.image.depth});
  for (const std::string& path : {a.json, a.html})
    if (!path.empty()) check_writable(path);
  prepare_cache(a.reading.mesh_cache);
  NoteList notes;
  SceneOptions reading = a.reading;
  reading.notes = &notes;
  if (!a.device.empty()) device_profile(a.device); // what is wrong with it is said before a scene is read
  auto line = progress_line(a.diagnostics, "reading " + a.scene);
  SceneSource source = read_scene_source(a.scene, reading, a.changes.edits());
  VerifySteps steps;
  steps.begin = [&](const std::string& what) { line = progress_line(a.diagnostics, what); };
  steps.progress = [&](double fraction) {
    if (line) line->show(fraction);
  };
  steps.warning = [&](const std::string& text) {
    if (a.diagnostics.verbosity == Verbosity::normal) std::cerr << "warning: " << text << "\n";
  };
  steps.check_size = check_frame_samples;
  VerifiedScene verified;
  try {
    verified = verify_scene(task_of(a, source.view.picture, memory), source, std::move(notes), steps);
  } catch (const NoOpenGl& error) {
    line.reset();
    std::cerr << "refraster: " << error.what() << "\n";
    return ExitCode::no_opengl;
  }
  const VerdictReport& report = verified.report;
  line.reset(); // before anything is printed
  print_file_notes(report.notes, a.diagnostics);
  if (!a.json.empty()) write_text(a.json, verdict_json(report));
  if (!a.html.empty()) {
    line = progress_line(a.diagnostics, "writing " + a.html);
    write_text(a.html, verified_html(verified, source.scene, a.html, memory));
    line.reset();
  }
  if (a.json != standard_output && a.diagnostics.verbosity == Verbosity::normal) std::cout << verdict_text(report);
  return report.passes() ? ExitCode::ok : ExitCode::differ;
}

void check_together(const VerifyArguments& a) {
  const bool from_file = a.source == JudgedSource::file;
  if (from_file && a.actual.empty()) throw UsageError("ACTUAL", "found no image to judge, expected one, or --gl");
  if (!from_file && !a.actual.empty())
    throw UsageError("ACTUAL", "found an image and --gl, which draws one: expected one of them");
  if (from_file && a.asked.size) throw UsageError("--size", "is for --gl; an image file has its own");
  if (from_file && a.renderer) throw UsageError("--renderer", "found no --gl, which it is for");
  if (!from_file && (!a.image.ids.empty() || !a.image.depth.empty()))
    throw UsageError(a.image.ids.empty() ? "--depth" : "--ids", "is for an image file; --gl reads its own");
}

} // namespace

Command verify_command() {
  const auto arguments = std::make_shared<VerifyArguments>();
  VerifyArguments& a = *arguments;
  Option actual = argument("ACTUAL", a.actual, "image to judge: " + readable_formats());
  actual.occurs = Occurs::at_most_once;
  std::vector<std::string> renderers;
  for (const auto& [value, name] : EnumNames<GlRenderer>::names) renderers.emplace_back(name);
  return {
      .name = "verify",
      .meaning = "Whether a GPU's image of a scene is right, and where it is not",
      .groups =
          {{"Scene and image",
            {scene_argument(a.scene), actual,
             flag(
                 "--gl", [&a] { a.source = std::max(a.source, JudgedSource::opengl_rgb8); },
                 "judge the 8-bit image that OpenGL draws here, with what it shows in each pixel and how deep"),
             flag(
                 "--gl-float", [&a] { a.source = JudgedSource::opengl_float; }, "the same of its float image"),
             word_option(
                 "--renderer", renderers, [&a](std::size_t i) { a.renderer = EnumNames<GlRenderer>::names[i].first; },
                 "who draws for --gl; by default the device's"),
             size_option(a.asked, "pixels that OpenGL draws; an image file has its own"),
             outside_option(a.reading.outside), exposure_option(a.reading.exposure_stops), shadow_option(a.reading),
             cache_option(a.reading.mesh_cache)}},
           scene_change_options(a.changes),
           {"Image",
            {file_option("--ids", "FILE", a.image.ids,
                         "what the device shows in each pixel: object and triangle, as gl --ids writes them"),
             file_option("--depth", "FILE", a.image.depth, "its window depth in [0, 1], as gl --depth writes it"),
             samples_option(a.asked, "a pixel, at the standard positions, shaded once a triangle"),
             srgb_option(a.asked, "the image is stored with the sRGB curve"), linear_option(a.asked),
             flag(
                 "--flip-y", [&a] { a.image.rows = RowOrder::bottom_first; },
                 "the image's first row is the lowest, as OpenGL reads it back"),
             alpha_option(a.image.alpha, a.image.background, ComparedAlpha::refused),
             premultiplied_option(a.image.encoding),
             text_option("--layer", "NAME", a.image.layer, "of .exr files: the layer whose R, G and B are judged")}},
           {"Device",
            {text_option(
                 "--device", "NAME|FILE", a.device,
                 "what a right device may do: one of refraster list devices, or a file of your own; by default, "
                 "with --gl, that of the driver if there is one, else gl-generic"),
             word_option(
                 "--matrices", {"one", "three"},
                 [&a](std::size_t i) { a.matrices = EnumNames<ShaderMatrices>::names[i].first; },
                 "how its vertex shader multiplies: a matrix made before, or projection * view * model; by "
                 "default three, with --gl and our own shader one")}},
           {"Report",
            {value_option("--fail-on", "CLASS[:COUNT],...",
                          "exit with 1 if more than COUNT pixels, 0 if not given, are of this class; of unexplained "
                          "ones none may be unless this says so",
                          [&a](const std::string& text) -> std::optional<ValueFault> {
                            for (const std::string_view part : split(text, ','))
                              if (auto fault = add_limit(part, a.limits)) return fault;
                            return std::nullopt;
                          }),
             file_option("--html", "FILE", a.html,
                         "write a page to look at: both images, what each pixel is, and why; docs/report-page.md"),
             file_option("--json", "FILE", a.json, "write the verdict as JSON; - is standard output"),
             memory_option(a.max_memory), strict_option(a.diagnostics),
             quiet_option(a.diagnostics,
                          "print errors only: no report, progress or notes; the exit code says the result")}}},
      .notes =
          {"Each pixel is one of exact, rounding, shading, texel, branch, edge, depth, undefined, unverifiable and "
           "unexplained: docs/verification.md says what each means, and what of a device makes it so.",
           "Exit code 0: every pixel is explained; 1: some are not, or a limit is exceeded; 3: not readable; 5: "
           "no OpenGL for --gl."},
      .finish = [arguments]() -> Action {
        check_together(*arguments);
        return [arguments] { return run(*arguments); };
      }};
}

} // namespace refraster
