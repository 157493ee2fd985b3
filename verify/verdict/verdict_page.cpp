#include "verify/verdict/verdict_page.h"

#include "verify/explain/explain_pixel.h"
#include "verify/explain/story_text.h"
#include "verify/page/verdict_colours.h"
#include "verify/report_text.h"
#include "verify/verdict/stored_value.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

/// A story is some kilobytes of text, and takes a frame's time for the vertices.
constexpr std::size_t max_stories = 12;
/// Pixels with an interval that may be looked at; unexplained ones come first.
constexpr std::size_t max_intervals = 200'000;

/// What each class means, in the order of PixelClass.
constexpr std::string_view meanings[] = {
    "the reference, rounded to the image's format",
    "at most one level from it, and within what the device may compute",
    "farther, and within that",
    "so only by what the device may do in reading textures",
    "so only by the other side of a comparison that the device may decide either way",
    "so only by another answer of a shadow map, whose comparison the device may decide either way",
    "the colour of another surface, whose edge the device may have on the other side of the sample",
    "the colour of another surface that may be as near",
    "the mathematics leaves the colour undefined here",
    "the device may show nearly anything here",
    "no right device shows this",
};
static_assert(std::size(meanings) == pixel_classes && verdict_colours.size() == pixel_classes);

PageImage reference_image(const Verdict& verdict, const StoredValue& stored) {
  PageImage page{.label = "reference", .source = "rendered by refraster in double"};
  if (!stored.is_integer()) {
    page.values = verdict.reference;
    return page;
  }
  page.rgb8 = Image<std::uint8_t>(verdict.width, verdict.height, 3);
  for (std::size_t i = 0; i < page.rgb8.values.size(); ++i)
    page.rgb8.values[i] =
        static_cast<std::uint8_t>(std::nearbyint(stored.of(static_cast<double>(verdict.reference.values[i]))));
  return page;
}

PageImage actual_image(const DeviceImage& image, const StoredValue& stored, const std::string& source) {
  PageImage page{.label = "image", .source = source};
  if (!stored.is_integer()) {
    page.values = image.colour;
    return page;
  }
  page.rgb8 = Image<std::uint8_t>(image.colour.width, image.colour.height, 3);
  for (std::size_t i = 0; i < page.rgb8.values.size(); ++i)
    page.rgb8.values[i] =
        static_cast<std::uint8_t>(std::nearbyint(std::clamp(stored.levels(image.colour.values[i]), 0.0, 255.0)));
  return page;
}

Image<std::uint32_t> counted(const Image<float>& numbers) {
  Image<std::uint32_t> result(numbers.width, numbers.height, 1);
  std::transform(numbers.values.begin(), numbers.values.end(), result.values.begin(),
                 [](float number) { return static_cast<std::uint32_t>(number); });
  return result;
}

std::array<float, 3> floats(const Double3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

void add_intervals(const Verdict& verdict, ReportPage& page) {
  for (const bool unexplained : {true, false})
    for (const JudgedDetail& detail : verdict.details) {
      if ((detail.found == PixelClass::unexplained) != unexplained || !detail.allowed.is_finite()) continue;
      if (page.allowed.size() == max_intervals) return;
      page.allowed.push_back({detail.x, detail.y, floats(detail.allowed.lo), floats(detail.allowed.hi)});
    }
}

std::string why(const JudgedDetail& detail) {
  std::string text;
  if (detail.objection == Objection::surface) text = "The device shows a triangle that cannot be seen here.\n";
  if (detail.objection == Objection::depth) text = "The depth is none that this surface may have here.\n";
  if (detail.surfaces > 1)
    text += "So may " + std::to_string(detail.surfaces - 1) + " more of what may be seen here; none has this colour.\n";
  return text;
}

void add_notes(const VerdictReport& report, const Scene& scene, const DeviceImage& image, ReportPage& page) {
  const Verdict& verdict = report.verdict;
  ExplainRequest request;
  request.width = verdict.width, request.height = verdict.height;
  request.samples = report.options.samples, request.transfer = report.transfer;
  for (std::size_t i = 0; i < std::min(verdict.clusters.size(), max_stories); ++i) {
    const Cluster& cluster = verdict.clusters[i].where;
    request.x = cluster.worst_x, request.y = cluster.worst_y;
    const float* const at = image.colour.at(request.x, request.y);
    const ActualPixel actual{
        report.actual, Double3(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2])),
        image.full_scale, image.precision};
    const auto detail = std::find_if(verdict.details.begin(), verdict.details.end(),
                                     [&](const JudgedDetail& d) { return d.x == request.x && d.y == request.y; });
    PageNote note{request.x, request.y};
    if (detail != verdict.details.end()) note.text = why(*detail);
    note.text += story_text(explain_pixel(scene, request, actual));
    page.notes.push_back(std::move(note));
  }
}

/// As the viewer has it beside the images: cut, so that 100 % means all.
std::string share_of(std::uint64_t count, std::uint64_t all) {
  const double hundredths = std::floor(1e4 * static_cast<double>(count) / static_cast<double>(all));
  return count > 0 && hundredths < 1 ? "< 0.01 %" : format("%.2f %%", hundredths / 100);
}

PageTable class_table(const Verdict& verdict) {
  PageTable table{.title = "Pixels by class", .columns = {"class", "pixels", "share"}, .rows = {}};
  const std::uint64_t all = verdict.classes.values.size();
  for (const auto& [pixel_class, name] : EnumNames<PixelClass>::names) {
    const std::uint64_t count = verdict.count(pixel_class);
    table.rows.push_back({std::string(name), with_commas(count), share_of(count, all)});
  }
  return table;
}

PageTable cause_table(const Verdict& verdict) {
  PageTable table{.title = "What makes the bounds as wide as they are",
                  .about = "of pixels chosen at random; each counts as much as any other",
                  .columns = {"cause", "share"},
                  .rows = {}};
  for (std::size_t i = 0; i < verdict.causes.size(); ++i)
    table.rows.push_back({std::string(bound_cause_names[i]), format("%.1f %%", 100 * verdict.causes[i])});
  return table;
}

PageTable drift_table(const Verdict& verdict, const Scene& scene) {
  PageTable table{.title = "Drift",
                  .about = "values that are stored as another level than the reference's",
                  .columns = {"object", "values", "moved", "by chance at most", ""},
                  .rows = {}};
  for (const ObjectBias& bias : verdict.biases)
    table.rows.push_back({scene.objects[bias.object].name, with_commas(bias.values),
                          rounded_text(100 * bias.moved, 3) + " %", rounded_text(100 * bias.allowed_moved, 3) + " %",
                          bias.is_biased() ? "drifts" : ""});
  return table;
}

} // namespace

ReportPage verdict_page(const VerdictReport& report, const Scene& scene, const DeviceImage& image) {
  const Verdict& verdict = report.verdict;
  const StoredValue stored(image, report.profile);
  ReportPage page;
  page.title = "verify " + report.scene;
  page.headline = verdict_headline(report);
  page.tone = report.passes() ? PageTone::passed : PageTone::failed;
  page.summary = {"device " + report.profile.name + ", version " + std::to_string(report.profile.version) + ": " +
                  report.profile.meaning};
  page.power = power_text(verdict.power);
  page.reference = reference_image(verdict, stored);
  page.actual = actual_image(image, stored, report.actual);
  for (std::size_t i = 0; i < pixel_classes; ++i)
    page.classes.push_back(
        {std::string(EnumNames<PixelClass>::names[i].second), verdict_colours[i], std::string(meanings[i])});
  page.class_map = verdict.classes;
  page.bound_width = verdict.width_levels;
  for (const Object& object : scene.objects) page.object_names.push_back(object.name);
  page.objects = counted(verdict.object), page.triangles = counted(verdict.triangle);
  add_intervals(verdict, page);
  add_notes(report, scene, image, page);
  for (const UnexplainedCluster& cluster : verdict.clusters)
    page.clusters.push_back({cluster.where, {{cluster.object, cluster.where.pixels}}});
  page.cluster_count = verdict.clusters.size();
  constexpr std::size_t max_shown_clusters = 25; // beyond, most are single pixels
  if (page.clusters.size() > max_shown_clusters) page.clusters.resize(max_shown_clusters);
  if (report.ranking)
    for (std::size_t i = 0; i < report.ranking->causes.size(); ++i) {
      const hypotheses::Cause& cause = report.ranking->causes[i];
      const std::uint64_t before = report.ranking->unexplained_in_image;
      PageHypothesis& hypothesis = page.hypotheses.emplace_back();
      hypothesis.text = report.cause_sentences[i];
      hypothesis.explained = cause.explained;
      hypothesis.before = before;
      hypothesis.after = static_cast<std::uint64_t>(std::lround((1 - cause.explained) * static_cast<double>(before)));
      hypothesis.detail = rounded_text(100 * cause.kept, 3) + " % of the pixels that are explained stay so";
    }
  page.tables = {class_table(verdict), cause_table(verdict)};
  if (!verdict.biases.empty()) page.tables.push_back(drift_table(verdict, scene));
  page.provenance = {{"scene", report.scene}, {"image", report.actual}};
  page.provenance.insert(page.provenance.end(), report.provenance.begin(), report.provenance.end());
  return page;
}

} // namespace refraster
