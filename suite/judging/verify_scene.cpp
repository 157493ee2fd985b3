#include "suite/judging/verify_scene.h"

#include "gl/context/driver_environment.h"
#include "gl/drawn_by_gl.h"
#include "io/file/sha256.h"
#include "io/image/image_formats.h"
#include "io/scene/triangle_numbers.h"
#include "suite/judging/fewer_samples.h"
#include "verify/verdict/judge_image.h"
#include "verify/verdict/verdict_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace refraster {
namespace {

/// What is assumed of a device of which nothing is known.
constexpr const char* widest_device = "gl-generic";

void begin(const VerifySteps& steps, const std::string& what) {
  if (steps.begin) steps.begin(what);
}

DeviceImage image_from_file(const VerifyTask& task, VerdictReport& report) {
  DeviceImageRequest request = task.image;
  request.colour = task.actual;
  // Floats hold linear values, unless they are said not to.
  const bool is_float = format_to_write(task.actual, {float_rgb_image, float_grey_image}) != nullptr;
  request.transfer = task.asked_transfer.value_or(is_float ? Transfer::linear : task.picture.transfer);
  request.memory = task.memory;
  report.provenance.emplace_back("image sha256", file_sha256(task.actual));
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
DeviceImage image_from_opengl(const VerifyTask& task, const Scene& scene, int& samples, VerdictReport& report,
                              const VerifySteps& steps) {
  const DeviceProfile& profile = report.profile;
  enter_environment(profile.environment);
  GlOptions options;
  options.width = task.picture.width, options.height = task.picture.height;
  options.renderer = task.renderer.value_or(profile.renderer);
  const bool is_float = task.source == JudgedSource::opengl_float;
  options.want_rgb8 = !is_float, options.want_radiance = is_float;
  if (!is_float) options.transfer = task.picture.transfer;
  std::string fewer;
  GlFrame frame = draw_with_samples(samples, task.asked_samples, fewer, [&](int drawn_samples) {
    options.samples = drawn_samples;
    options.want_ids = options.want_depth = drawn_samples == 1;
    return render_gl(scene, options);
  });
  if (!fewer.empty()) report.notes.add(Note{"", 0, "", fewer});
  if (steps.warning)
    for (const std::string& line : frame.warnings) steps.warning(line);
  if (task.device.empty()) report.profile = profile_of_driver(frame.driver.renderer);
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
  if (samples > 1)
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

} // namespace

VerifiedScene verify_scene(VerifyTask task, SceneSource& source, NoteList notes, const VerifySteps& steps) {
  const bool is_drawn = task.source == JudgedSource::opengl_rgb8 || task.source == JudgedSource::opengl_float;
  VerifiedScene result;
  VerdictReport& report = result.report;
  DeviceImage& image = result.image;
  report.scene = task.scene, report.actual = is_drawn ? "drawn by OpenGL" : task.actual;
  report.profile = device_profile(task.device.empty() ? widest_device : task.device);
  report.limits = task.limits;
  report.notes = std::move(notes);
  Scene& scene = source.scene;
  int samples = task.picture.samples;
  if (is_drawn) check_drawn_by_gl(task.scene, scene);
  note_what_is_not_judged(report, scene);
  check_triangle_numbers(task.scene, scene, "verify");
  if (task.origin == SceneOrigin::file) report.provenance.emplace_back("scene sha256", file_sha256(task.scene));
  if (is_drawn) {
    begin(steps, "drawing " + task.scene);
    place(scene, source.view, task.picture.width, task.picture.height);
    image = image_from_opengl(task, scene, samples, report, steps);
  } else {
    image = task.source == JudgedSource::file ? image_from_file(task, report) : std::move(task.given);
    place(scene, source.view, image.colour.width, image.colour.height);
  }
  if (steps.check_size) steps.check_size(image.colour.width, image.colour.height, samples);
  begin(steps, "judging " + report.actual);
  report.options = task.judging;
  report.options.samples = samples;
  report.options.memory = task.memory;
  report.options.matrices =
      task.matrices.value_or(!is_drawn || has_own_vertex_shader(scene) ? ShaderMatrices::three : ShaderMatrices::one);
  report.options.progress = steps.progress;
  judge_image(report, scene, image, is_drawn ? SampleOrder::known : SampleOrder::either);
  if (task.causes == CauseSearch::done && !report.verdict.is_explained()) {
    begin(steps, "looking for the cause");
    rank_causes(report, scene, image);
  }
  report.options.progress = {}; // the report outlives whoever is told
  return result;
}

std::string verified_html(const VerifiedScene& verified, const Scene& scene, const std::string& path,
                          const MemoryBudget& memory) {
  constexpr std::uint64_t bytes_a_pixel = 96; // of images, maps and the text that they become
  memory.need(bytes_a_pixel * verified.report.verdict.classes.values.size(), path);
  return report_html(verdict_page(verified.report, scene, verified.image));
}

} // namespace refraster
