#include "app/arguments.h"

#include "math/precisions.h"

#include <algorithm>
#include <cmath>

namespace refraster {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

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

std::optional<std::vector<Aov>> aovs_from(std::string_view text) {
  std::vector<Aov> aovs;
  for (const std::string_view name : split(text, ',')) {
    const auto* found = std::find(std::begin(aov_names), std::end(aov_names), name);
    if (found == std::end(aov_names)) return std::nullopt;
    const Aov aov = static_cast<Aov>(found - std::begin(aov_names));
    if (std::find(aovs.begin(), aovs.end(), aov) != aovs.end()) return std::nullopt;
    aovs.push_back(aov);
  }
  return aovs;
}

std::vector<std::string> precision_names() {
  return listed_names(static_cast<const Precisions*>(nullptr));
}

std::vector<std::string> lane_precision_names() {
  return listed_names(static_cast<const LanePrecisions*>(nullptr));
}

std::optional<std::vector<std::string>> precisions_from(std::string_view text) {
  const std::vector<std::string> known = lane_precision_names();
  std::vector<std::string> precisions;
  for (const std::string_view name : split(text, ',')) {
    if (std::find(known.begin(), known.end(), name) == known.end()) return std::nullopt;
    if (std::find(precisions.begin(), precisions.end(), name) != precisions.end()) return std::nullopt;
    precisions.emplace_back(name);
  }
  return precisions;
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
    throw CLI::ValidationError("--samples", "found " + found_of(limit::frame_samples, all) + ", expected " +
                                                at_most(limit::frame_samples));
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

void add_outside_option(CLI::App& command, Outside& outside) {
  command.add_flag_callback(
      "--allow-outside", [&outside] { outside = Outside::allowed; },
      "let the scene name files outside its own folder: only for scenes that you trust");
}

void add_cache_option(CLI::App& command, std::string& folder) {
  command
      .add_option(
          "--cache", folder,
          "folder, made if need be, where the triangles of large OBJ files are cached, so that they are read faster "
          "the next time")
      ->type_name("DIR");
}

} // namespace refraster
