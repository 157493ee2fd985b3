// refraster verify SCENE ACTUAL, refraster verify SCENE --gl

#include <refraster/files.h>
#include <refraster/notes.h>
#include <refraster/render.h>

#include "app/arguments.h"
#include "app/command.h"
#include "app/commands/fewer_samples.h"
#include "app/diagnostics.h"
#include "app/memory_limit.h"
#include "app/options/picture_options.h"
#include "app/options/scene_options.h"
#include "app/options/shared_options.h"
#include "app/output.h"
#include "app/progress_line.h"
#include "app/usage_error.h"
#include "gl/context/driver_environment.h"
#include "gl/drawn_by_gl.h"
#include "gl/render_gl.h"
#include "io/file/sha256.h"
#include "io/scene/scene_source.h"
#include "io/scene/triangle_numbers.h"
#include "verify/device/read_profile.h"
#include "verify/images/read_device_image.h"
#include "verify/verdict/judge_image.h"
#include "verify/verdict/verdict_page.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

namespace refraster {
namespace {

/// What is assumed of a device of which nothing is known.
constexpr const char* widest_device = "gl-generic";

/// What draws the image that is judged.
enum class Source { file, opengl_rgb8, opengl_float };

struct VerifyArguments {
  std::string scene, actual, json, html, device;
  DeviceImageRequest image;
  SceneOptions reading;
  SceneChanges changes;
  JudgeOptions judging;
  std::optional<ShaderMatrices> matrices;
  std::optional<GlRenderer> renderer;
  PictureArguments asked; // the size is for OpenGL
  Picture picture;        // once the scene is read
  Source source = Source::file;
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

DeviceImage image_from_file(const VerifyArguments& a, VerdictReport& report) {
  DeviceImageRequest request = a.image;
  request.colour = a.actual;
  // Floats hold linear values, unless they are said not to.
  const bool is_float = format_to_write(a.actual, {float_rgb_image, float_grey_image}) != nullptr;
  request.transfer = a.asked.transfer.value_or(is_float ? Transfer::linear : a.picture.transfer);
  request.memory = a.reading.memory;
  report.provenance.emplace_back("image sha256", file_sha256(a.actual));
  return read_device_image(request, report.notes);
}

/// Of the shipped profiles the one that a driver of this name has; else what every device may do.
DeviceProfile profile_of_driver(const std::string& renderer) {
  for (const std::string_view name : device_profile_names())
    if (name != widest_device && renderer.find(name) != std::string::npos) return device_profile(std::string(name));
  if (renderer.find("SwiftShader") != std::string::npos) return device_profile("swiftshader");
  return device_profile(widest_device);
}

/// Driven as the profile says: by its renderer, in its environment; with the samples that it has.
DeviceImage image_from_opengl(VerifyArguments& a, const Scene& scene, VerdictReport& report) {
  const DeviceProfile& profile = report.profile;
  enter_environment(profile.environment);
  GlOptions options;
  options.width = a.picture.width, options.height = a.picture.height;
  options.renderer = a.renderer.value_or(profile.renderer);
  const bool is_float = a.source == Source::opengl_float;
  options.want_rgb8 = !is_float, options.want_radiance = is_float;
  if (!is_float) options.transfer = a.picture.transfer;
  std::string fewer;
  GlFrame frame = draw_with_samples(a.judging.samples, a.asked.samples, fewer, [&](int samples) {
    options.samples = samples;
    options.want_ids = options.want_depth = samples == 1;
    return render_gl(scene, options);
  });
  if (!fewer.empty()) report.notes.add(Note{"", 0, "", fewer});
  if (a.diagnostics.verbosity == Verbosity::normal)
    for (const std::string& line : frame.warnings) std::cerr << "warning: " << line << "\n";
  if (a.device.empty()) report.profile = profile_of_driver(frame.driver.renderer);
  report.provenance.emplace_back("driver", frame.driver.renderer);
  report.provenance.emplace_back("OpenGL", frame.driver.version);
  DeviceImage image;
  if (is_float) {
    image.colour = std::move(frame.radiance);
    image.full_scale = 1;
    image.precision = StoredPrecision::floats(0x1p-24);
  } else {
    image.colour = Image<float>(frame.rgb8.width, frame.rgb8.height, 3);
    std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), image.colour.values.begin());
    image.precision = StoredPrecision::integers(255);
    image.transfer = options.transfer;
  }
  image.ids = std::move(frame.ids), image.depth = std::move(frame.depth);
  if (a.judging.samples > 1)
    for (const GlSamplePosition& at : frame.sample_positions)
      image.samples.push_back({static_cast<std::int32_t>(std::lround(at.x * subpixels)),
                               static_cast<std::int32_t>(std::lround(at.y * subpixels))});
  return image;
}

/// Whether the GLSL of an object is not ours: then nothing is known of how it multiplies its matrices.
bool has_own_vertex_shader(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [](const Object& object) { return !object.vertex_shader_path.empty(); });
}

void write_page(const VerifyArguments& a, const VerdictReport& report, const Scene& scene, const DeviceImage& image,
                const MemoryBudget& memory) {
  constexpr std::uint64_t bytes_a_pixel = 96; // of images, maps and the text that they become
  const auto line = progress_line(a.diagnostics, "writing " + a.html);
  memory.need(bytes_a_pixel * report.verdict.classes.values.size(), a.html);
  write_text(a.html, report_html(verdict_page(report, scene, image)));
}

ExitCode run(VerifyArguments& a) {
  const MemoryBudget memory = set_memory_limit(a.max_memory, 1);
  if (a.source != Source::file) clear_memory_limit(); // drivers do not bear it
  a.reading.memory = memory;
  check_different({a.json, a.html}, {a.scene, a.actual, a.image.ids, a.image.depth});
  for (const std::string& path : {a.json, a.html})
    if (!path.empty()) check_writable(path);
  prepare_cache(a.reading.mesh_cache);
  VerdictReport report;
  report.scene = a.scene, report.actual = a.source == Source::file ? a.actual : "drawn by OpenGL";
  report.profile = device_profile(a.device.empty() ? widest_device : a.device);
  report.limits = a.limits;
  SceneOptions reading = a.reading;
  reading.notes = &report.notes;
  auto line = progress_line(a.diagnostics, "reading " + a.scene);
  SceneSource source = read_scene_source(a.scene, reading, a.changes.edits());
  Scene& scene = source.scene;
  a.picture = a.asked.over(source.view.picture);
  a.judging.samples = a.picture.samples;
  if (a.source != Source::file) check_drawn_by_gl(a.scene, scene);
  note_what_is_not_judged(report, scene);
  check_triangle_numbers(a.scene, scene, "verify");
  report.provenance.emplace_back("scene sha256", file_sha256(a.scene));
  DeviceImage image;
  try {
    if (a.source == Source::file) {
      image = image_from_file(a, report);
      place(scene, source.view, image.colour.width, image.colour.height);
    } else {
      line = progress_line(a.diagnostics, "drawing " + a.scene);
      place(scene, source.view, a.picture.width, a.picture.height);
      image = image_from_opengl(a, scene, report);
    }
  } catch (const NoOpenGl& error) {
    line.reset();
    std::cerr << "refraster: " << error.what() << "\n";
    return ExitCode::no_opengl;
  }
  check_frame_samples(image.colour.width, image.colour.height, a.judging.samples);
  line = progress_line(a.diagnostics, "judging " + report.actual);
  report.options = a.judging;
  report.options.memory = memory;
  report.options.matrices = a.matrices.value_or(
      a.source == Source::file || has_own_vertex_shader(scene) ? ShaderMatrices::three : ShaderMatrices::one);
  if (line) report.options.progress = [&line](double done) { line->show(done); };
  judge_image(report, scene, image, a.source == Source::file ? SampleOrder::either : SampleOrder::known);
  const bool is_told = a.diagnostics.verbosity == Verbosity::normal || !a.json.empty() || !a.html.empty();
  if (is_told && !report.verdict.is_explained()) {
    line = progress_line(a.diagnostics, "looking for the cause");
    rank_causes(report, scene, image);
  }
  line.reset(); // before anything is printed
  print_file_notes(report.notes, a.diagnostics);
  if (!a.json.empty()) write_text(a.json, verdict_json(report));
  if (!a.html.empty()) write_page(a, report, scene, image, memory);
  if (a.json != standard_output && a.diagnostics.verbosity == Verbosity::normal) std::cout << verdict_text(report);
  return report.passes() ? ExitCode::ok : ExitCode::differ;
}

void check_together(const VerifyArguments& a) {
  const bool from_file = a.source == Source::file;
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
                 "--gl", [&a] { a.source = std::max(a.source, Source::opengl_rgb8); },
                 "judge the 8-bit image that OpenGL draws here, with what it shows in each pixel and how deep"),
             flag(
                 "--gl-float", [&a] { a.source = Source::opengl_float; }, "the same of its float image"),
             word_option(
                 "--renderer", renderers, [&a](std::size_t i) { a.renderer = EnumNames<GlRenderer>::names[i].first; },
                 "who draws for --gl; by default the device's"),
             size_option(a.asked, "pixels that OpenGL draws; an image file has its own"),
             outside_option(a.reading.outside), exposure_option(a.reading.exposure_stops),
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
