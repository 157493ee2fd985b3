#include "app/view/draw/aov_colours.h"

#include "io/file/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace refraster {
namespace {

/// Half of it is mixed into a pixel: seen over what is dark and what is light, and rare in pictures.
constexpr std::array edge_colour{0, 224, 255};

/// What is black and what is white, in each channel.
struct Span {
  std::array<double, 3> black{0, 0, 0}, white{1, 1, 1};
  bool found = false; // in the image
};

Span found_span(const Image<float>& values, const Image<float>& objects) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Span span{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}, true};
  const auto channels = static_cast<std::size_t>(values.channels);
  for (std::size_t i = 0; i < objects.values.size(); ++i) {
    if (objects.values[i] == 0) continue;
    for (std::size_t c = 0; c < channels; ++c) {
      const double value = static_cast<double>(values.values[i * channels + c]);
      span.black[c] = std::min(span.black[c], value), span.white[c] = std::max(span.white[c], value);
    }
  }
  return span;
}

Span span_of(Aov aov, const Image<float>& values, const Image<float>& objects) {
  switch (aov) {
  case Aov::normal:
    return {{-1, -1, -1}, {1, 1, 1}};
  case Aov::uv:
  case Aov::albedo:
  case Aov::alpha:
    return {};
  default:
    return found_span(values, objects);
  }
}

std::uint8_t level(double value, double black, double white) {
  if (!(white > black)) return std::isfinite(value) ? 128 : 0; // all are the same
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp((value - black) / (white - black), 0.0, 1.0)));
}

/// Far from that of the numbers next to it, and never dark: the fractional parts of multiples of the golden ratio are
/// spread evenly, and so are those of its square.
std::array<std::uint8_t, 3> colour_of_number(double number) {
  constexpr double golden = 0.6180339887498949;
  const double hue = 6 * std::fmod(number * golden, 1), strength = 0.45 + 0.4 * std::fmod(number * golden * 7, 1);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) { // of HSV, with a value of 1
    const double k = std::fmod(5 - 2 * static_cast<double>(c) + hue, 6);
    colour[c] = level(1 - strength * std::clamp(std::min(k, 4 - k), 0.0, 1.0), 0, 1);
  }
  return colour;
}

std::string legend_of(Aov aov, const Span& span, bool any) {
  const AovKind& kind = kind_of(aov);
  const std::string name(kind.name);
  if (!any) return name + ": no surface";
  if (kind.values == AovValues::numbers) return name + ": a colour for each number";
  if (aov == Aov::uv) return name + ": fractional parts, u red and v green";
  if (!span.found && kind.channels == 3)
    return name + (aov == Aov::normal ? ": x, y, z as red, green, blue, -1 black to 1 full" : ": red, green, blue");
  std::string text = name + ": ";
  static constexpr const char* axes[] = {"x red ", "y green ", "z blue "};
  const bool one = kind.channels == 1;
  for (std::size_t c = 0; c < static_cast<std::size_t>(kind.channels); ++c)
    text += format(one ? "%s%.6g black to %.6g white" : "%s%.6g to %.6g", one ? "" : axes[c], span.black[c],
                   span.white[c]) +
            (c + 1 < static_cast<std::size_t>(kind.channels) ? ", " : "");
  return text;
}

} // namespace

AovPicture aov_picture(Aov aov, const Image<float>& values, const Image<float>& objects) {
  const Span span = span_of(aov, values, objects);
  const bool numbers = kind_of(aov).values == AovValues::numbers;
  const auto channels = static_cast<std::size_t>(values.channels);
  AovPicture picture{Image<std::uint8_t>(values.width, values.height, 3), {}};
  bool any = false;
  for (std::size_t i = 0; i < objects.values.size(); ++i) {
    if (objects.values[i] == 0) continue;
    any = true;
    const float* const of_pixel = &values.values[i * channels];
    std::uint8_t* const to = &picture.rgb8.values[3 * i];
    if (numbers) {
      std::ranges::copy(colour_of_number(static_cast<double>(of_pixel[0])), to);
      continue;
    }
    for (std::size_t c = 0; c < 3; ++c) {
      if (channels == 2 && c == 2) continue; // no blue
      double value = static_cast<double>(of_pixel[channels == 1 ? 0 : c]);
      if (aov == Aov::uv) value -= std::floor(value);
      const std::size_t of_span = channels == 1 ? 0 : c;
      to[c] = level(value, span.black[of_span], span.white[of_span]);
    }
  }
  picture.legend = legend_of(aov, span, any);
  return picture;
}

void draw_edges(Image<std::uint8_t>& rgb8, const Image<float>& objects, const Image<float>& triangles) {
  const auto differ = [&](int x, int y, int other_x, int other_y) {
    return *objects.at(x, y) != *objects.at(other_x, other_y) || *triangles.at(x, y) != *triangles.at(other_x, other_y);
  };
  for (int y = 0; y < rgb8.height; ++y)
    for (int x = 0; x < rgb8.width; ++x) {
      const bool edge =
          (x + 1 < rgb8.width && differ(x, y, x + 1, y)) || (y + 1 < rgb8.height && differ(x, y, x, y + 1));
      if (!edge) continue;
      std::uint8_t* const pixel = rgb8.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>((pixel[c] + edge_colour[c]) / 2);
    }
}

} // namespace refraster
