#include "verify/compare/compare_files.h"

#include "io/file/limits.h"
#include "io/file/text.h"
#include "io/scene/scene_source.h"
#include "verify/compare/clusters.h"
#include "verify/compare/compare.h"
#include "verify/compare/flip.h"
#include "verify/page/compare_page.h"

#include <algorithm>

namespace refraster {
namespace {

/// What is seen in each cluster of the report.
void name_clusters(FileComparison& found, const SeenObjects& seen) {
  ComparisonReport& report = found.report;
  const Image<double> differences = pixel_differences(found.images.a, found.images.b, found.scale);
  const Image<std::uint8_t> over = pixels_over(found.images.a, found.images.b, differences, found.scale, report.limits);
  for (const Cluster& cluster : report.found.clusters) report.objects.push_back(cluster_objects(over, cluster, seen));
}

/// As a screen shows it, 0 to 255 in three channels.
Image<float> as_shown(const Image<float>& image, double full_scale) {
  Image<float> shown(image.width, image.height, 3);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < 3; ++c)
        shown.at(x, y)[c] = static_cast<float>(
            std::min(static_cast<double>(image.at(x, y)[image.channels == 1 ? 0 : c]) / full_scale, 1.0) * 255);
  return shown;
}

double limit_levels(const CompareRequest& request) {
  return converted(request.limits, request.unit, CompareUnit::levels).max_abs.value_or(0);
}

} // namespace

FileComparison compare_files(const CompareRequest& request) {
  PairRequest pair = request.pair;
  pair.limit_levels = limit_levels(request);
  return compare_pair(read_image_pair(request.a, request.b, pair, request.memory), request);
}

FileComparison compare_pair(ImagePair images, const CompareRequest& request) {
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
    result.report.transformation = find_transformation(a, b, result.images.alpha, limit_levels(request));
    if (!result.report.transformation) result.report.compressed = find_block_compression(a, b);
  }
  return result;
}

std::function<std::optional<SeenObjects>(int width, int height, NoteList& notes)>
objects_of_scene(const std::string& scene, const SceneOptions& reading, const std::string& image) {
  return [=](int width, int height, NoteList& notes) {
    constexpr auto largest_side = static_cast<int>(limit::frame_side.value);
    if (std::max(width, height) > largest_side)
      throw InputError(
          InputFault{image, 0, 0, "", format("%d x %d pixels", width, height),
                     "at most " + std::to_string(largest_side) + " on a side, which --scene is rendered in"});
    SceneOptions options = reading;
    options.notes = &notes;
    const Scene placed = read_scene_source(scene, options).placed(width, height);
    return std::optional(seen_objects(placed, width, height, reading.memory));
  };
}

double flip_of(const FileComparison& found) {
  const ImagePair& images = found.images;
  const auto refuse = [](const std::string& file, const std::string& what) {
    throw InputError(InputFault{file, 0, 0, "", what,
                                "red, green and blue, or grey, of 8 or 16 bits: --flip compares what a screen shows"});
  };
  if (images.precision_a.relative > 0) refuse(found.report.file_a, "values of floating point");
  if (images.precision_b.relative > 0) refuse(found.report.file_b, "values of floating point");
  if (images.a.channels != 1 && images.a.channels != 3)
    refuse(found.report.file_a, std::to_string(images.a.channels) + " channels to compare");
  return mean_flip(as_shown(images.a, images.full_scale), as_shown(images.b, images.full_scale));
}

std::string comparison_html(const FileComparison& found, const std::string& path, const MemoryBudget& memory) {
  constexpr std::uint64_t bytes_a_pixel = 48; // the images once more, filtered, compressed and as text
  memory.need(bytes_a_pixel * found.report.found.pixels(), path);
  return report_html(comparison_page(found.report, found.images, found.scale, found.seen));
}

} // namespace refraster
