// OpenGL's image, or that of another program, against the bounds of a device.

#include "io/file/atomic_file.h"
#include "suite/actions/actions.h"
#include "suite/actions/thumbnail.h"
#include "suite/judging/verify_scene.h"
#include "verify/page/verdict_colours.h"

#include <algorithm>
#include <set>

namespace refraster::suite {
namespace {

/// Each pixel's class in its colour, as the page shows it.
Image<std::uint8_t> class_colours(const Image<std::uint8_t>& classes) {
  Image<std::uint8_t> colours(classes.width, classes.height, 3);
  for (int y = 0; y < classes.height; ++y)
    for (int x = 0; x < classes.width; ++x)
      std::copy_n(verdict_colours[*classes.at(x, y)].begin(), 3, colours.at(x, y));
  return colours;
}

JudgedSource source_of(const Entry& entry) {
  if (entry.image_from == ImageFrom::file) return JudgedSource::file;
  return entry.image_from == ImageFrom::gl_float ? JudgedSource::opengl_float : JudgedSource::opengl_rgb8;
}

std::string found_of(const VerdictReport& report, const char* label) {
  for (const auto& [name, content] : report.provenance)
    if (name == label) return content;
  return {};
}

} // namespace

void verify_image(Task& task) {
  EntryResult& result = task.result;
  const Entry& entry = task.entry;
  VerifyTask verify{.scene = entry.scene,
                    .actual = entry.image_file,
                    .source = source_of(entry),
                    .image = {},
                    .device = entry.device,
                    .renderer = {},
                    .matrices = {},
                    .picture = task.picture,
                    .asked_samples = entry.samples,
                    .asked_transfer = entry.transfer,
                    .limits = entry.limits.classes,
                    .memory = task.workplace.memory};
  verify.judging.threads = task.workplace.threads;
  const VerifiedScene verified = verify_scene(verify, task.source, {});
  const VerdictReport& report = verified.report;
  const Verdict& verdict = report.verdict;
  const Image<float>& colour = verified.image.colour;
  result.width = verdict.width, result.height = verdict.height;
  result.samples = report.options.samples;
  result.device = report.profile.name;
  result.driver = found_of(report, "driver");
  result.message = verdict_headline(report);
  result.pixels_over = verdict.count(PixelClass::unexplained);
  result.thumbnail = thumbnail_of(levels_of(colour, verified.image.full_scale, Transfer::linear));
  result.state = report.passes() ? State::explained : State::unexplained;
  if (report.passes()) return;
  const auto pixels = static_cast<double>(verdict.classes.values.size());
  std::uint64_t over = 0;
  for (const ClassLimit& limit : report.exceeded()) over += verdict.count(limit.pixel_class);
  result.severity = static_cast<double>(over) / pixels;
  result.details = report.cause_sentences;
  if (const std::string power = power_text(verdict.power); !power.empty()) result.details.push_back(power);
  std::set<std::string> objects;
  for (const UnexplainedCluster& cluster : verdict.clusters) objects.insert(cluster.object);
  if (!objects.empty()) result.objects = {objects.begin(), objects.end()};
  result.page = task.file(pages_folder, ".html");
  const std::string page = task.path_of(result.page);
  write_file(page, verified_html(verified, task.source.scene, page, task.workplace.memory));
  result.reference_thumbnail = thumbnail_of(levels_of(verdict.reference, 1, report.transfer));
  result.difference_thumbnail = thumbnail_of(class_colours(verdict.classes));
  if (entry.image_from == ImageFrom::file) return;
  result.image = task.file(images_folder, ".png");
  write_image(task.path_of(result.image), levels_of(colour, verified.image.full_scale, Transfer::linear));
}

} // namespace refraster::suite
