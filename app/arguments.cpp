#include "app/arguments.h"

#include "app/options/option.h"
#include "app/usage_error.h"
#include "math/precisions.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

/// Exactly `count` whole numbers in [0, largest_side], and nothing else.
std::optional<std::vector<int>> numbers_from(std::string_view text, char separator, std::size_t count) {
  std::vector<int> numbers;
  for (const std::string_view part : split(text, separator)) {
    const std::optional<int> number = number_from<int>(part);
    if (!number || *number < 0 || *number > largest_side) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

template <class... Precision>
std::vector<std::string> listed_names(const std::tuple<Precision...>*) {
  return {std::string(Precision::name)...};
}

} // namespace

std::optional<Size> size_from(std::string_view text) {
  const auto numbers = numbers_from(text, 'x', 2);
  if (!numbers || (*numbers)[0] < 1 || (*numbers)[1] < 1) return std::nullopt;
  return Size{(*numbers)[0], (*numbers)[1]};
}

std::optional<std::vector<Size>> sizes_from(std::string_view text) {
  std::vector<Size> sizes;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<Size> size = size_from(part);
    if (!size || std::find(sizes.begin(), sizes.end(), *size) != sizes.end()) return std::nullopt;
    sizes.push_back(*size);
  }
  return sizes;
}

std::optional<PixelRect> crop_from(std::string_view text) {
  const auto numbers = numbers_from(text, ',', 4);
  if (!numbers || (*numbers)[2] < 1 || (*numbers)[3] < 1) return std::nullopt;
  return PixelRect{(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
}

std::vector<std::string> precision_names() {
  return listed_names(static_cast<const Precisions*>(nullptr));
}

std::vector<std::string> lane_precision_names() {
  return listed_names(static_cast<const LanePrecisions*>(nullptr));
}

std::optional<std::vector<int>> thread_counts_from(std::string_view text) {
  std::vector<int> counts;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<int> count = number_from<int>(part);
    if (!count || *count < 1 || *count > static_cast<int>(limit::threads.value)) return std::nullopt;
    if (std::find(counts.begin(), counts.end(), *count) != counts.end()) return std::nullopt;
    counts.push_back(*count);
  }
  return counts;
}

void check_frame_samples(int width, int height, int samples) {
  const std::uint64_t all =
      static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * static_cast<std::uint64_t>(samples);
  if (all > limit::frame_samples.value)
    throw UsageError("--samples",
                     "found " + found_of(limit::frame_samples, all) + ", expected " + at_most(limit::frame_samples));
}

std::optional<Double3> reflectance_from(std::string_view text) {
  std::vector<double> numbers;
  for (const std::string_view part : split(text, ',')) {
    const std::optional<double> number = number_from<double>(part);
    if (!number || !(0 <= *number && *number <= 1)) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() == 1) return Double3(numbers[0]);
  if (numbers.size() == 3) return Double3(numbers[0], numbers[1], numbers[2]);
  return std::nullopt;
}

std::optional<double> distance_from(std::string_view text) {
  const std::optional<double> number = number_from<double>(text);
  return number && std::isfinite(*number) && *number >= 0 ? number : std::nullopt;
}

std::optional<std::uint64_t> count_from(std::string_view text) {
  return number_from<std::uint64_t>(text);
}

} // namespace refraster
