// An entry's image, ready to become its reference.

#include <refraster/files.h>

#include "io/file/atomic_file.h"
#include "io/file/sha256.h"
#include "io/image/png/png_write.h"
#include "suite/actions/actions.h"
#include "suite/actions/made_image.h"
#include "verify/compare/compare.h"

#include <algorithm>

namespace refraster::suite {
namespace {

/// How far the image is from the reference that there is; whether anything differs.
bool differs_from(Task& task, const MadeImage& made, const std::string& path) {
  EntryResult& result = task.result;
  Image<float> now(made.rgb8.width, made.rgb8.height, 3);
  std::copy(made.rgb8.values.begin(), made.rgb8.values.end(), now.values.begin());
  ImageFile before;
  try {
    before = read_image(path, task.workplace.memory);
  } catch (const InputError& error) { // what cannot be read is replaced
    result.details.emplace_back(error.faults().front().text());
    return true;
  }
  if (before.bits != 8 || before.values.width != now.width || before.values.height != now.height ||
      before.values.channels != 3)
    return true;
  const Comparison found = compare(before.values, now, PixelScale(CompareUnit::levels), {});
  result.max_levels = found.max, result.rms_levels = found.rms, result.pixels_over = found.pixels_over;
  return !found.same;
}

} // namespace

void update_reference(Task& task) {
  EntryResult& result = task.result;
  const References& references = *task.workplace.references;
  const Reference* const record = references.find(task.entry.name);
  const ReferenceKind kind = task.entry.reference.value_or(record != nullptr ? record->kind : ReferenceKind::image);
  const MadeImage made = make_image_of(task, kind == ReferenceKind::digest ? Floats::wanted : Floats::unwanted);
  const bool is_known = record != nullptr && record->kind == kind;
  if (kind == ReferenceKind::digest) {
    result.image_sha256 = float_image_digest(made.radiance);
    result.state = is_known && record->sha256 == result.image_sha256 ? State::equal : State::different;
    return;
  }
  const std::string path = references.image_of(task.entry.name);
  const bool differs = path.empty() || differs_from(task, made, path);
  if (is_known && !differs) {
    result.image_sha256 = record->sha256;
    result.state = State::equal;
    return;
  }
  WriteOptions options;
  options.threads = task.workplace.threads;
  if (made.transfer == Transfer::srgb) options.curve = StatedCurve::srgb;
  const std::string file = png_file(made.rgb8, options);
  result.image_sha256 = text_sha256(file);
  result.state = State::different;
  write_file(references.folder() + "/" + waiting_name(task.entry.name, result.image_sha256), file);
}

} // namespace refraster::suite
