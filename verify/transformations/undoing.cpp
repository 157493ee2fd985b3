#include "verify/transformations/undoing.h"

namespace refraster {

double undoing_tolerance(const KnownTransformation& which, const StoredPrecision& undone, const StoredPrecision& other,
                         double limit, double undone_levels, double other_levels) {
  const double rounding = which.slope * undone.absolute + which.condition * undone.relative * undone_levels +
                          which.float_roundings * 0x1p-24 * undone_levels + other.absolute +
                          other.relative * other_levels;
  const double sum = limit + rounding, step = other.step;
  if (step == 0) return sum;
  // The undone image is rounded once more, by half a step, and differences are whole steps then. A sum that is whole by
  // derivation must not fall below by rounding of its double (2^-30 of a step), and a whole step must pass: a quarter.
  return (std::floor(sum / step + 0.5 + 0x1p-30) + 0.25) * step;
}

bool saturation_explains(const KnownTransformation& which, const StoredImage& undone, const StoredImage& other, int x,
                         int y, int c, double undone_levels) {
  switch (which.which) {
  case Transformation::srgb_curve_added:
  case Transformation::srgb_curve_missing:
  case Transformation::video_range:
  case Transformation::video_range_removed:
  case Transformation::scaled:
    break;
  default:
    return false;
  }
  const double source = undone.levels(x, y, c), to = other.levels(x, y, c);
  const bool above = undone_levels > to;
  if (undone.precision.saturates() && (above ? source <= 0 : source >= 255)) return true;
  return other.precision.saturates() && (above ? to >= 255 : to <= 0);
}

std::vector<double> common_values(const StoredImage& image) {
  constexpr std::uint64_t most = 1 << 14; // pixels that are looked at: the median is that of the image to a percent
  const auto width = static_cast<std::uint64_t>(image.image.width);
  const std::uint64_t pixels = width * static_cast<std::uint64_t>(image.image.height);
  // Not a divisor of the width, as the columns of some would be looked at and no others.
  const std::uint64_t stride = (pixels / most + 1) | 1;
  std::vector<double> medians;
  for (int c = 0; c < image.image.channels; ++c) {
    std::vector<double> values;
    for (std::uint64_t i = 0; i < pixels; i += stride) {
      const double value = image.levels(static_cast<int>(i % width), static_cast<int>(i / width), c);
      if (!std::isnan(value)) values.push_back(value);
    }
    if (values.empty()) values.push_back(0);
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    medians.push_back(*middle);
  }
  return medians;
}

FoundTransformation found_transformation(Transformation which, const Judgement& judgement) {
  FoundTransformation found{};
  found.which = which;
  found.pixels = judgement.pixels;
  found.within = judgement.pixels - judgement.over;
  found.equal_within = judgement.equal_within;
  found.max = judgement.max;
  found.rms = judgement.rms();
  return found;
}

} // namespace refraster
