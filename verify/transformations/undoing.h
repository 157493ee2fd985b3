#pragma once
// Judges one undoing of a transformation; for find_transformation.cpp and its kin.

#include "verify/transformations/transformations.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace refraster {

/// What is counted while an undone image is held against the other one.
struct Judgement {
  std::uint64_t pixels = 0;        // that both have
  std::uint64_t over = 0;          // of these: beyond the limit and the rounding
  std::uint64_t over_before = 0;   // beyond it as the images are, of those that both have, there and at their old place
  std::uint64_t over_anywhere = 0; // beyond it as the images are
  std::uint64_t varied = 0;        // pixels of the other image that are not of its most common values
  std::uint64_t by_value = 0, by_saturation = 0; // values over before and not after, and why
  double equal_within = 0, max = 0, squares = 0;
  std::uint64_t values = 0;

  bool convinces() const {
    return pixels > 0 && over <= pixels / one_unexplained_in && over_before > 0 && over_before >= 10 * over &&
           10 * over_before >= over_anywhere && varied > 0 && varied >= 10 * over && 10 * by_value >= by_saturation;
  }
  double rms() const { return values > 0 ? std::sqrt(squares / static_cast<double>(values)) : 0; }
  bool better_than(const Judgement& other) const {
    return over != other.over ? over < other.over : rms() < other.rms();
  }
};

/// Whether the values differ only because one of them was cut off: a stored 0 may have been less, a stored 1 more. Of
/// maps of values, which are all rising.
bool saturation_explains(const KnownTransformation& which, const StoredImage& undone, const StoredImage& other, int x,
                         int y, int c, double undone_levels);

/// The medians of all channels, in levels, of some thousand pixels over all the image.
std::vector<double> common_values(const StoredImage& image);

/// Holds the undone image against the other. `undo(x, y, c)` gives the value that is undone to pixel (x, y) of `other`,
/// in levels; `has(x, y)` whether there is one, and `moves(x, y)` whether the pixel of `undone` at this place has one
/// in `other` too. Goes row by row, and ends early where too much is over.
template <class Undo, class Has, class Moves>
Judgement judge(const KnownTransformation& which, const StoredImage& undone, const StoredImage& other, double limit,
                Undo&& undo, Has&& has, Moves&& moves) {
  const int width = other.image.width, height = other.image.height, channels = other.image.channels;
  const bool same_size = undone.image.width == width && undone.image.height == height;
  const std::vector<double> common = common_values(other);
  const double step = other.precision.step;
  Judgement found;
  const std::uint64_t most =
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) / one_unexplained_in;
  std::vector<double> now(static_cast<std::size_t>(channels));
  for (int y = 0; y < height && found.over <= most; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool there = has(x, y);
      double largest_now = 0, largest = 0;
      for (int c = 0; c < channels; ++c) {
        double& value = now[static_cast<std::size_t>(c)];
        value = there ? undo(x, y, c) : 0;
        if (step > 0) value = std::nearbyint(value / step) * step;
        largest_now = std::max(largest_now, std::abs(value));
        largest = std::max(largest, std::abs(other.levels(x, y, c)));
      }
      const double allowed = undoing_tolerance(which, undone.precision, other.precision, limit, largest_now, largest);
      bool over = false, before = false, varies = false;
      double pixel_max = 0;
      for (int c = 0; c < channels; ++c) {
        const double old = same_size ? undone.levels(x, y, c) : 0, to = other.levels(x, y, c);
        const double from = now[static_cast<std::size_t>(c)];
        // Not <=: NaN and infinities that are not the same are beyond anything.
        const auto beyond = [&](double u, double v) { return u != v && !(std::abs(u - v) <= allowed); };
        const bool was = same_size ? beyond(old, to) : true;
        before |= was;
        varies |= beyond(to, common[static_cast<std::size_t>(c)]);
        if (!there) continue;
        double difference = from == to ? 0 : std::abs(from - to);
        if (beyond(from, to) && saturation_explains(which, undone, other, x, y, c, from)) {
          found.by_saturation += was;
          difference = 0;
        } else if (beyond(from, to)) {
          over = true;
        } else {
          found.by_value += was;
        }
        pixel_max = std::max(pixel_max, std::isnan(difference) ? HUGE_VAL : difference);
        if (std::isfinite(difference)) found.squares += difference * difference, ++found.values;
      }
      found.over_anywhere += before;
      if (!there) continue;
      ++found.pixels;
      found.over += over;
      found.over_before += before && moves(x, y);
      found.varied += varies;
      if (!over) found.equal_within = std::max(found.equal_within, pixel_max);
      found.max = std::max(found.max, pixel_max);
    }
  }
  return found;
}

/// Where all pixels have a counterpart.
template <class Undo>
Judgement judge(const KnownTransformation& which, const StoredImage& undone, const StoredImage& other, double limit,
                Undo&& undo) {
  const auto always = [](int, int) { return true; };
  return judge(which, undone, other, limit, undo, always, always);
}

/// What is found, in words.
FoundTransformation found_transformation(Transformation which, const Judgement& judgement);

} // namespace refraster
