// An entry's image against its reference.

#include "io/file/atomic_file.h"
#include "io/file/sha256.h"
#include "io/file/text.h"
#include "suite/actions/actions.h"
#include "suite/actions/made_image.h"
#include "suite/actions/thumbnail.h"
#include "verify/compare/compare_files.h"
#include "verify/compare/heat_legend.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>

namespace refraster::suite {
namespace {

std::string pixels_sha256(const Image<std::uint8_t>& rgb8) {
  Sha256 sha256;
  sha256.add(rgb8.values.data(), rgb8.values.size());
  return in_hexadecimal(sha256.result());
}

/// A reference as it is stored, as three channels of 8 bits; of others empty.
Image<std::uint8_t> stored_rgb8(const ImageFile& file) {
  if (file.bits != 8 || file.values.channels != 3) return {};
  Image<std::uint8_t> rgb8(file.values.width, file.values.height, 3);
  std::transform(file.values.values.begin(), file.values.values.end(), rgb8.values.begin(),
                 [](float level) { return static_cast<std::uint8_t>(level); });
  return rgb8;
}

void without_reference(Task& task, const MadeImage& made) {
  EntryResult& result = task.result;
  result.state = State::no_reference;
  result.message = "there is no reference of it; `suite update` makes one";
  write_made(task, made);
}

void against_digest(Task& task, const MadeImage& made, const Reference& reference) {
  EntryResult& result = task.result;
  result.image_sha256 = float_image_digest(made.radiance);
  if (result.image_sha256 == reference.sha256) {
    result.state = State::equal;
    result.message = "the same bits";
    return;
  }
  result.state = State::different;
  result.message = "other bits than its digest";
  result.details.emplace_back("no image of the old ones is kept: a render of version " + reference.version +
                              " would show them");
  result.severity = 1; // how far is not known
  write_made(task, made);
}

/// What of the scene the clusters of a difference show.
std::vector<std::string> objects_of(const ComparisonReport& report) {
  std::set<std::string> names;
  for (const ObjectCounts& counts : report.objects)
    for (const auto& [name, pixels] : counts) names.insert(name);
  return {names.begin(), names.end()};
}

/// The way of `refraster compare`, with its page.
void against_other_image(Task& task, const MadeImage& made, const std::string& path) {
  EntryResult& result = task.result;
  write_made(task, made);
  const std::string image = task.path_of(result.image);
  CompareRequest request{.a = path,
                         .b = image,
                         .pair = {},
                         .limits = task.entry.limits.compare,
                         .scene = task.entry.scene,
                         .memory = task.workplace.memory};
  request.seen = [&](int width, int height, NoteList&) -> std::optional<SeenObjects> {
    return seen_objects(task.source.scene, width, height, task.workplace.memory);
  };
  FileComparison compared = compare_files(request);
  // As it is called from the folder of results, wherever that is: merge moves pages.
  compared.report.name_b = result.image;
  const Comparison& found = compared.report.found;
  result.message = comparison_verdict(compared.report);
  result.max_levels = found.max, result.rms_levels = found.rms, result.pixels_over = found.pixels_over;
  if (found.same) {
    result.state = State::equal;
    std::error_code ignored;
    std::filesystem::remove(image, ignored);
    result.image.clear();
    return;
  }
  result.state = State::different;
  result.severity = std::min(found.rms / 255, 1.0);
  result.message += format(": %s, by at most %.3g levels", counted(found.pixels_over, "pixel").c_str(), found.max);
  result.details = comparison_causes(compared.report);
  if (std::vector<std::string> objects = objects_of(compared.report); !objects.empty())
    result.objects = std::move(objects);
  result.page = task.file(pages_folder, ".html");
  const std::string page = task.path_of(result.page);
  write_file(page, comparison_html(compared, page, task.workplace.memory));
  const double end = heat_ramp_end(found);
  const Image<std::uint8_t> heat = heat_image(compared.images.a, compared.images.b, compared.scale, end);
  result.difference = task.file(images_folder, ".difference.png");
  write_image(task.path_of(result.difference), with_legend(heat, found, end));
  result.difference_thumbnail = thumbnail_of(heat);
}

void against_image(Task& task, const MadeImage& made, const std::string& path) {
  EntryResult& result = task.result;
  const ImageFile file = read_image(path, task.workplace.memory);
  const Image<std::uint8_t> stored = stored_rgb8(file);
  if (stored.width == made.rgb8.width && stored.height == made.rgb8.height && stored.values == made.rgb8.values) {
    result.state = State::equal;
    result.message = "the same";
    return;
  }
  result.reference_thumbnail =
      thumbnail_of(stored.empty() ? levels_of(file.values, file.full_scale, Transfer::linear) : stored);
  if (file.values.width == made.rgb8.width && file.values.height == made.rgb8.height)
    return against_other_image(task, made, path);
  result.state = State::different;
  result.severity = 1;
  result.message = format("%dx%d pixels, the reference %dx%d", made.rgb8.width, made.rgb8.height, file.values.width,
                          file.values.height);
  write_made(task, made);
}

} // namespace

void compare_with_reference(Task& task) {
  const References& references = *task.workplace.references;
  const Reference* const record = references.find(task.entry.name);
  const bool by_digest = record != nullptr && record->kind == ReferenceKind::digest;
  const MadeImage made = make_image_of(task, by_digest ? Floats::wanted : Floats::unwanted);
  task.result.thumbnail = thumbnail_of(made.rgb8);
  if (by_digest) return against_digest(task, made, *record);
  task.result.image_sha256 = pixels_sha256(made.rgb8);
  if (const std::string path = references.image_of(task.entry.name); !path.empty())
    return against_image(task, made, path);
  without_reference(task, made);
}

} // namespace refraster::suite
