#pragma once
// Words of the command line that are more than a number or a name.

#include <refraster/fields.h>
#include <refraster/render.h>

#include "io/file/limits.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace refraster {

struct Size {
  int width = 1280, height = 720;
  bool operator==(const Size&) const = default;
};
inline constexpr int largest_side = limit::frame_side.value; // pixels

/// "1280x720", each side 1 to largest_side.
std::optional<Size> size_from(std::string_view text);

/// "1280x720,1920x1080", each once.
std::optional<std::vector<Size>> sizes_from(std::string_view text);

/// "x,y,width,height", none negative, width and height at least 1.
std::optional<PixelRect> crop_from(std::string_view text);

/// The names of all precisions.
std::vector<std::string> precision_names();

/// The names of those that are measured for their speed: all but `exact`.
std::vector<std::string> lane_precision_names();

/// Throws UsageError for more than limit::frame_samples.
void check_frame_samples(int width, int height, int samples);

/// "1,2,4": numbers of threads, each 1 to limit::threads and once.
std::optional<std::vector<int>> thread_counts_from(std::string_view text);

/// "0.8" or "0.6,0.05,0.03": what is reflected of red, green and blue, each in [0, 1]. One number stands for all three.
std::optional<Double3> reflectance_from(std::string_view text);

/// A finite number, not negative.
std::optional<double> distance_from(std::string_view text);

/// A whole number, not negative.
std::optional<std::uint64_t> count_from(std::string_view text);

} // namespace refraster
