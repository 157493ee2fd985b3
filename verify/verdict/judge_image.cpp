#include "verify/verdict/judge_image.h"

#include "raster/samples.h"
#include "raster/vertex/subpixel.h"

#include <utility>
#include <vector>

namespace refraster {
namespace {

/// The standard positions of samples, counted from the lower left corner, as in OpenGL's window.
std::vector<SamplePosition> positions_y_up(int samples) {
  std::vector<SamplePosition> positions;
  for (const SamplePosition& at : sample_pattern(samples)) positions.push_back({at.x, subpixels - at.y});
  return positions;
}

} // namespace

void note_what_is_not_judged(VerdictReport& report, const Scene& scene) {
  if (has_shadows(scene, Shadow::exact))
    report.notes.add(Note{report.scene, 0, "shadow", "not judged: a light that has one may reach a surface or not"});
}

void judge_image(VerdictReport& report, const Scene& scene, DeviceImage& image, SampleOrder order) {
  report.transfer = image.transfer;
  report.verdict = judge(scene, image, report.profile, report.options);
  if (order == SampleOrder::known || report.options.samples == 1 || report.verdict.is_explained()) return;
  image.samples = positions_y_up(report.options.samples);
  Verdict other = judge(scene, image, report.profile, report.options);
  if (other.count(PixelClass::unexplained) >= report.verdict.count(PixelClass::unexplained)) return;
  report.verdict = std::move(other);
  report.provenance.emplace_back("samples", "at the standard positions counted upward, as in OpenGL's window");
}

} // namespace refraster
