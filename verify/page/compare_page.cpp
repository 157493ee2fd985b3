#include "verify/page/compare_page.h"
#include "verify/report_text.h"

#include "io/file/build_info.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "verify/compare/compare.h"
#include "verify/page/page_parts.h"
#include "verify/page/verdict_colours.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace refraster {
namespace {

/// 8 bits stay whole levels, unless alpha has made others of them.
bool holds_levels(const Image<float>& image, double full_scale) {
  return full_scale == 255 && std::all_of(image.values.begin(), image.values.end(), [](float value) {
           return value >= 0 && value <= 255 && value == std::floor(value);
         });
}

void set_pixels(PageImage& shown, const Image<float>& image, double full_scale, bool as_levels) {
  if (as_levels) {
    shown.rgb8 = Image<std::uint8_t>(image.width, image.height, image.channels);
    std::transform(image.values.begin(), image.values.end(), shown.rgb8.values.begin(),
                   [](float value) { return static_cast<std::uint8_t>(value); });
    return;
  }
  shown.values = image;
  if (full_scale == 1) return;
  for (float& value : shown.values.values) value = static_cast<float>(static_cast<double>(value) / full_scale);
}

const std::string& shown_b(const ComparisonReport& report) {
  return report.name_b.empty() ? report.file_b : report.name_b;
}

std::string unit_word(CompareUnit unit) {
  return unit == CompareUnit::levels ? " levels" : "";
}

std::string finite_text(double x) {
  return std::isfinite(x) ? rounded_text(x) : "none";
}

void add_classes(ReportPage& page, const ComparisonReport& report, const Image<double>& differences,
                 const Image<std::uint8_t>& over) {
  const bool limited = report.limits.max_abs.value_or(0) > 0;
  enum { equal, within, beyond, no_difference };
  page.classes = {{"equal", verdict_colours[0], "All values are the same."},
                  {"within the limit", verdict_colours[2], "Differs, by no more than the limit."},
                  {limited ? "over the limit" : "different", verdict_colours[10],
                   limited ? "A value differs by more than the limit." : "A value differs."},
                  {"no difference", verdict_colours[6], "A value is NaN, or infinite and not the same in both."}};
  page.class_map = Image<std::uint8_t>(differences.width, differences.height, 1);
  for (std::size_t i = 0; i < differences.values.size(); ++i) {
    const double difference = differences.values[i];
    page.class_map.values[i] = std::isinf(difference) ? no_difference
                               : over.values[i]       ? beyond
                               : difference > 0       ? within
                                                      : equal;
  }
}

void add_summary(ReportPage& page, const ComparisonReport& report) {
  const Comparison& found = report.found;
  page.title = "refraster compare " + report.file_a + " " + shown_b(report);
  page.headline = comparison_verdict(report);
  page.headline[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(page.headline[0])));
  page.tone = found.same ? PageTone::passed : PageTone::failed;
  page.summary = comparison_causes(report);
  const std::uint64_t unequal = found.pixels() - found.equal_pixels;
  if (unequal == 0) return;
  page.summary.push_back(with_commas(unequal) + " of " + with_commas(found.pixels()) + " pixels are not equal, " +
                         with_commas(found.pixels_over) + " over " + rounded_text(report.limits.max_abs.value_or(0)) +
                         unit_word(found.unit) + "; largest difference " + rounded_text(found.max) +
                         unit_word(found.unit));
}

void add_tables(ReportPage& page, const ComparisonReport& report) {
  const Comparison& found = report.found;
  const std::string unit = found.unit == CompareUnit::levels ? "levels (1/255)" : "values, 1 is white";
  PageTable all{"Differences", "B − A, in " + unit + ".", {"", ""}, {}};
  all.rows = {{"largest", rounded_text(found.max)}, {"root mean square", rounded_text(found.rms)}};
  all.rows.push_back({"PSNR", std::isfinite(found.psnr_db) ? format("%.2f dB", found.psnr_db) : "infinite"});
  const std::vector<std::string> names = channel_names(page.reference);
  for (std::size_t c = 0; c < found.mean.size(); ++c)
    all.rows.push_back({"mean, " + names[c], format("%+.3g", found.mean[c])});
  if (report.mean_flip) all.rows.push_back({"FLIP", format("%.6f", *report.mean_flip)});
  PageTable pixels{"Pixels", "", {"", ""}, {}};
  pixels.rows = {{"all", with_commas(found.pixels())},
                 {"equal", with_commas(found.equal_pixels)},
                 {"over the limit", with_commas(found.pixels_over)},
                 {"NaN or infinite", with_commas(found.incomparable_pixels)},
                 {"NaN in A", with_commas(found.nan_pixels_a)},
                 {"NaN in B", with_commas(found.nan_pixels_b)}};
  page.tables = {pixels, all};
  if (found.worst.empty()) return;
  PageTable worst{"Worst pixels", "One of each cluster.", {"pixel", "A", "B", "difference"}, {}};
  const auto values = [](const std::vector<double>& list) {
    std::string text;
    for (const double value : list) text += (text.empty() ? "" : "  ") + rounded_text(value, 7);
    return text;
  };
  for (const PixelDifference& one : found.worst)
    worst.rows.push_back({format("(%d, %d)", one.x, one.y), values(one.a), values(one.b), finite_text(one.difference)});
  page.tables.push_back(worst);
}

void add_provenance(ReportPage& page, const ComparisonReport& report) {
  const BuildInfo build = this_build();
  page.provenance = {{"A", report.file_a},
                     {"A sha256", file_sha256(report.file_a)},
                     {"B", shown_b(report)},
                     {"B sha256", file_sha256(report.file_b)}};
  if (!report.scene.empty()) {
    page.provenance.emplace_back("scene", report.scene);
    page.provenance.emplace_back("scene sha256", file_sha256(report.scene));
  }
  page.provenance.emplace_back("refraster", build.version + ", " + build.compiler + ", " + build.isa);
  for (const Note& note : report.notes.notes()) page.provenance.emplace_back("note", note.text());
}

} // namespace

ReportPage comparison_page(const ComparisonReport& report, const ImagePair& images, const PixelScale& scale,
                           const std::optional<SeenObjects>& seen) {
  ReportPage page;
  page.reference.label = "A", page.actual.label = "B";
  page.reference.source = report.file_a, page.actual.source = shown_b(report);
  const bool as_levels = holds_levels(images.a, images.full_scale) && holds_levels(images.b, images.full_scale);
  set_pixels(page.reference, images.a, images.full_scale, as_levels);
  set_pixels(page.actual, images.b, images.full_scale, as_levels);
  const Image<double> differences = pixel_differences(images.a, images.b, scale);
  add_classes(page, report, differences, pixels_over(images.a, images.b, differences, scale, report.limits));
  add_summary(page, report);
  add_tables(page, report);
  add_provenance(page, report);
  for (std::size_t i = 0; i < report.found.clusters.size(); ++i)
    page.clusters.push_back({report.found.clusters[i], i < report.objects.size() ? report.objects[i] : ObjectCounts{}});
  page.cluster_count = report.found.cluster_count;
  if (seen) {
    page.object_names = seen->names;
    page.objects = seen->object;
    page.triangles = seen->triangle;
  }
  return page;
}

} // namespace refraster
