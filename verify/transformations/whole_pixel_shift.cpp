#include "verify/transformations/whole_pixel_shift.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace refraster {
namespace {

/// A pixel of b that differs from the one left of it or above it.
struct Probe {
  int x, y;
  double contrast;
};

double difference(const StoredImage& a, int ax, int ay, const StoredImage& b, int bx, int by) {
  double largest = 0;
  for (int c = 0; c < a.image.channels; ++c) {
    const double d = std::abs(a.levels(ax, ay, c) - b.levels(bx, by, c));
    largest = std::max(largest, std::isnan(d) ? HUGE_VAL : d);
  }
  return largest;
}

/// In each of 16 x 16 fields of the image the pixel that stands out most, if it does so by more than is allowed to
/// differ.
std::vector<Probe> probes_of(const StoredImage& image, double allowed) {
  constexpr int fields = 16;
  const int width = image.image.width, height = image.image.height;
  std::vector<Probe> best(std::size_t{fields} * fields, Probe{0, 0, allowed});
  for (int y = 1; y < height; ++y)
    for (int x = 1; x < width; ++x) {
      const double contrast =
          std::max(difference(image, x, y, image, x - 1, y), difference(image, x, y, image, x, y - 1));
      const auto column = static_cast<std::size_t>(x) * fields / static_cast<std::size_t>(width);
      const auto row = static_cast<std::size_t>(y) * fields / static_cast<std::size_t>(height);
      Probe& field = best[row * fields + column];
      if (contrast > field.contrast) field = {x, y, contrast};
    }
  std::erase_if(best, [](const Probe& probe) { return probe.x == 0; });
  // Those that stand out most refuse a wrong shift soonest.
  std::stable_sort(best.begin(), best.end(), [](const Probe& p, const Probe& q) { return p.contrast > q.contrast; });
  return best;
}

} // namespace

std::vector<PixelShift> likely_shifts(const StoredImage& a, const StoredImage& b, double limit) {
  const int width = a.image.width, height = a.image.height;
  const KnownTransformation& shifted = known(Transformation::shifted);
  const double at_white = undoing_tolerance(shifted, b.precision, a.precision, limit, 255, 255);
  const std::vector<Probe> probes = probes_of(b, at_white);
  if (probes.empty()) return {};

  struct Candidate {
    double missed; // share of the probes that have a counterpart
    int x, y;
    auto order() const { return std::tuple(missed, std::abs(x) + std::abs(y), y, x); }
  };
  constexpr std::size_t max_candidates = 8;
  std::vector<Candidate> best;
  const int reach_x = std::min(max_shift, width / 2), reach_y = std::min(max_shift, height / 2);
  for (int dy = -reach_y; dy <= reach_y; ++dy) {
    for (int dx = -reach_x; dx <= reach_x; ++dx) {
      if (dx == 0 && dy == 0) continue;
      std::size_t seen = 0, missed = 0;
      for (const Probe& probe : probes) {
        const int x = probe.x - dx, y = probe.y - dy;
        if (x < 0 || y < 0 || x >= width || y >= height) continue;
        ++seen;
        missed += difference(a, x, y, b, probe.x, probe.y) > at_white;
        // Pixels that stand out lie on edges, which two programs may draw one pixel apart here and there.
        if (4 * missed > probes.size()) break;
      }
      // Of shifts that leave hardly a probe in the image little is known.
      if (4 * missed > probes.size() || 4 * seen < probes.size()) continue;
      best.push_back({static_cast<double>(missed) / static_cast<double>(seen), dx, dy});
      std::sort(best.begin(), best.end(), [](const Candidate& p, const Candidate& q) { return p.order() < q.order(); });
      best.resize(std::min(best.size(), max_candidates));
    }
  }
  std::vector<PixelShift> shifts;
  for (const Candidate& candidate : best) shifts.push_back({candidate.x, candidate.y});
  return shifts;
}

} // namespace refraster
