#include "verify/compare/compare_files.h"

#include "verify/compare/clusters.h"
#include "verify/compare/compare.h"
#include "verify/page/compare_page.h"

namespace refraster {
namespace {

/// What is seen in each cluster of the report.
void name_clusters(FileComparison& found, const SeenObjects& seen) {
  ComparisonReport& report = found.report;
  const Image<double> differences = pixel_differences(found.images.a, found.images.b, found.scale);
  const Image<std::uint8_t> over = pixels_over(found.images.a, found.images.b, differences, found.scale, report.limits);
  for (const Cluster& cluster : report.found.clusters) report.objects.push_back(cluster_objects(over, cluster, seen));
}

} // namespace

FileComparison compare_files(const CompareRequest& request) {
  const double limit_levels = converted(request.limits, request.unit, CompareUnit::levels).max_abs.value_or(0);
  PairRequest pair = request.pair;
  pair.limit_levels = limit_levels;
  ImagePair images = read_image_pair(request.a, request.b, pair, request.memory);
  const PixelScale scale(images.full_scale, request.unit);
  ComparisonReport report{request.a, request.b, request.limits, compare(images.a, images.b, scale, request.limits)};
  report.notes = images.notes;
  report.scene = request.scene;
  FileComparison result{std::move(images), scale, std::move(report), {}};
  const Comparison& found = result.report.found;
  if (request.seen) result.seen = request.seen(found.width, found.height, result.report.notes);
  if (result.seen) name_clusters(result, *result.seen);
  if (!found.same) {
    const StoredImage a{result.images.a, result.images.full_scale, result.images.precision_a};
    const StoredImage b{result.images.b, result.images.full_scale, result.images.precision_b};
    result.report.transformation = find_transformation(a, b, result.images.alpha, limit_levels);
    if (!result.report.transformation) result.report.compressed = find_block_compression(a, b);
  }
  return result;
}

std::string comparison_html(const FileComparison& found, const std::string& path, const MemoryBudget& memory) {
  constexpr std::uint64_t bytes_a_pixel = 48; // the images once more, filtered, compressed and as text
  memory.need(bytes_a_pixel * found.report.found.pixels(), path);
  return report_html(comparison_page(found.report, found.images, found.scale, found.seen));
}

} // namespace refraster
