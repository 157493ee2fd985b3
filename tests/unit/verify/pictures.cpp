#include "tests/unit/verify/pictures.h"

#include <refraster/files.h>
#include <refraster/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace refraster::test {
namespace {

float level(double x) {
  return static_cast<float>(std::clamp(std::nearbyint(x), 0.0, 255.0));
}

/// Pixel (x, y) of the result is what `at` says of it.
Picture made(const Picture& like, const std::function<double(int x, int y, int c)>& at) {
  Picture result(like.width, like.height, like.channels);
  for (int y = 0; y < like.height; ++y)
    for (int x = 0; x < like.width; ++x)
      for (int c = 0; c < like.channels; ++c) result.at(x, y)[c] = level(at(x, y, c));
  return result;
}

double at_border(const Picture& p, int x, int y, int c) {
  return static_cast<double>(p.at(std::clamp(x, 0, p.width - 1), std::clamp(y, 0, p.height - 1))[c]);
}

// IEC 61966-2-1, written down again: what the program inverts.
double srgb_curve(double levels) {
  const double x = levels / 255;
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055);
}
double inverse_srgb_curve(double levels) {
  const double s = levels / 255;
  return 255 * (s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

Picture shifted(const Picture& p, int dx, int dy) {
  return made(p, [&](int x, int y, int c) { return at_border(p, x - dx, y - dy, c); });
}

double mean_of_neighbours(const Picture& p, int x, int y, int c) {
  double sum = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) sum += at_border(p, x + dx, y + dy, c);
  return sum / 9;
}

} // namespace

Picture mapped(const Picture& picture, const std::function<double(double)>& map) {
  return made(picture, [&](int x, int y, int c) { return map(static_cast<double>(picture.at(x, y)[c])); });
}

Picture drawn_picture() {
  Picture picture(96, 64, 3);
  const auto disc = [](int x, int y, double centre_x, double centre_y, double radius) {
    return std::hypot(x - centre_x, y - centre_y) < radius;
  };
  return made(picture, [&](int x, int y, int c) -> double {
    if (disc(x, y, 30, 24, 17)) return 255 * std::exp(-std::hypot(x - 25, y - 18) / 12) + (c == 0 ? 20 : 5 * c);
    if (disc(x, y, 70, 40, 14)) return (c + 1) * 60 * (0.4 + 0.6 * (x - 56) / 28.0);
    if (y > 56) return (x / 5 + y / 4) % 2 ? 240 - 20 * c : 30;
    if (x > 80 && y < 20) return 255;
    return c == 2 ? 90 - y : 12 + x / 4.0;
  });
}

std::vector<NamedPicture> gallery_pictures() {
  std::vector<NamedPicture> pictures;
  for (const char* const name : {"phong", "still_life", "filters", "specular_gate"}) {
    const std::string path = std::string(REFRASTER_SOURCE_DIR) + "/scenes/gallery/" + name + ".json";
    RenderOptions options;
    options.width = 160, options.height = 90;
    const Frame frame = render(read_scene(path), options);
    Picture picture(frame.rgb8.width, frame.rgb8.height, frame.rgb8.channels);
    std::copy(frame.rgb8.values.begin(), frame.rgb8.values.end(), picture.values.begin());
    pictures.push_back({name, std::move(picture)});
  }
  return pictures;
}

std::vector<Mistake> known_mistakes() {
  std::vector<Mistake> mistakes = {
      {Transformation::srgb_curve_added, [](const Picture& p) { return mapped(p, srgb_curve); }},
      {Transformation::srgb_curve_missing, [](const Picture& p) { return mapped(p, inverse_srgb_curve); }},
      {Transformation::upside_down,
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) { return at_border(p, x, p.height - 1 - y, c); });
       }},
      {Transformation::mirrored,
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) { return at_border(p, p.width - 1 - x, y, c); });
       }},
      {Transformation::red_blue_exchanged,
       [](const Picture& p) { return made(p, [&](int x, int y, int c) { return at_border(p, x, y, 2 - c); }); }},
      {Transformation::video_range,
       [](const Picture& p) { return mapped(p, [](double v) { return 16 + v * 219 / 255; }); }},
      {Transformation::video_range_removed,
       [](const Picture& p) { return mapped(p, [](double v) { return (v - 16) * 255 / 219; }); }},
  };
  for (const auto& [x, y] : {std::pair(1, 0), std::pair(0, -1), std::pair(-3, 2), std::pair(11, 7)})
    mistakes.push_back({Transformation::shifted,
                        [right = x, down = y](const Picture& p) { return shifted(p, right, down); }, 1, x, y});
  for (const double factor : {0.25, 0.5, 1 / std::numbers::pi, 1.2, 2.0})
    mistakes.push_back({Transformation::scaled,
                        [factor](const Picture& p) { return mapped(p, [&](double v) { return v * factor; }); },
                        factor});
  return mistakes;
}

std::vector<OtherChange> other_changes() {
  return {
      {"negative", [](const Picture& p) { return mapped(p, [](double v) { return 255 - v; }); }},
      {"lighter by 20 levels", [](const Picture& p) { return mapped(p, [](double v) { return v + 20; }); }},
      {"more contrast", [](const Picture& p) { return mapped(p, [](double v) { return 128 + 1.4 * (v - 128); }); }},
      {"gamma 1.5",
       [](const Picture& p) { return mapped(p, [](double v) { return 255 * std::pow(v / 255, 1 / 1.5); }); }},
      {"eight steps", [](const Picture& p) { return mapped(p, [](double v) { return std::floor(v / 32) * 32; }); }},
      {"black", [](const Picture& p) { return mapped(p, [](double) { return 0; }); }},
      {"white", [](const Picture& p) { return mapped(p, [](double) { return 255; }); }},
      {"grey", [](const Picture& p) { return mapped(p, [](double) { return 77; }); }},
      {"without colour",
       [](const Picture& p) {
         return made(p, [&](int x, int y, int) {
           return (at_border(p, x, y, 0) + at_border(p, x, y, 1) + at_border(p, x, y, 2)) / 3;
         });
       }},
      {"R, G and B turned around",
       [](const Picture& p) { return made(p, [&](int x, int y, int c) { return at_border(p, x, y, (c + 1) % 3); }); }},
      {"R and G exchanged",
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) { return at_border(p, x, y, c == 2 ? 2 : 1 - c); });
       }},
      {"blurred",
       [](const Picture& p) { return made(p, [&](int x, int y, int c) { return mean_of_neighbours(p, x, y, c); }); }},
      {"sharpened",
       [](const Picture& p) {
         return made(p,
                     [&](int x, int y, int c) { return 2 * at_border(p, x, y, c) - mean_of_neighbours(p, x, y, c); });
       }},
      {"shifted by half a pixel",
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) { return (at_border(p, x, y, c) + at_border(p, x - 1, y, c)) / 2; });
       }},
      {"stretched by a tenth",
       [](const Picture& p) { return made(p, [&](int x, int y, int c) { return at_border(p, x * 10 / 11, y, c); }); }},
      {"turned by half a turn",
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) { return at_border(p, p.width - 1 - x, p.height - 1 - y, c); });
       }},
      {"with noise",
       [](const Picture& p) {
         std::mt19937 random(1);
         return made(
             p, [&](int x, int y, int c) { return at_border(p, x, y, c) + static_cast<double>(random() % 17) - 8; });
       }},
      {"with a part that lacks",
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) {
           const bool lacks = 4 * x > p.width && 2 * x < p.width && 3 * y > p.height;
           return lacks ? 20 : at_border(p, x, y, c);
         });
       }},
      {"darker towards the corners",
       [](const Picture& p) {
         return made(p, [&](int x, int y, int c) {
           return at_border(p, x, y, c) * (1 - 0.5 * std::hypot(2.0 * x / p.width - 1, 2.0 * y / p.height - 1));
         });
       }},
      {"compressed", [](const Picture& p) { return compressed(p, 12); }},
  };
}

Picture compressed(const Picture& picture, double step) {
  constexpr int side = 8;
  // JFIF: luma and two differences of colour.
  const auto planes = [&](int x, int y, int c) {
    const double r = at_border(picture, x, y, 0), g = at_border(picture, x, y, 1), b = at_border(picture, x, y, 2);
    const double luma = 0.299 * r + 0.587 * g + 0.114 * b;
    return c == 0 ? luma : c == 1 ? (b - luma) / 1.772 : (r - luma) / 1.402;
  };
  const auto wave = [](int k, int i) {
    return std::sqrt((k == 0 ? 1.0 : 2.0) / side) * std::cos(std::numbers::pi * k * (2 * i + 1) / (2 * side));
  };
  Image<double> decoded(picture.width + side, picture.height + side, 3);
  for (int top = 0; top < picture.height; top += side)
    for (int left = 0; left < picture.width; left += side)
      for (int c = 0; c < 3; ++c)
        for (int v = 0; v < side; ++v)
          for (int u = 0; u < side; ++u) {
            double coefficient = 0;
            for (int y = 0; y < side; ++y)
              for (int x = 0; x < side; ++x) coefficient += planes(left + x, top + y, c) * wave(u, x) * wave(v, y);
            const double quantum = step * (1 + u + v);
            coefficient = std::nearbyint(coefficient / quantum) * quantum;
            if (coefficient == 0) continue;
            for (int y = 0; y < side; ++y)
              for (int x = 0; x < side; ++x) decoded.at(left + x, top + y)[c] += coefficient * wave(u, x) * wave(v, y);
          }
  return made(picture, [&](int x, int y, int c) {
    const double luma = decoded.at(x, y)[0], blue = luma + 1.772 * decoded.at(x, y)[1],
                 red = luma + 1.402 * decoded.at(x, y)[2];
    return c == 0 ? red : c == 2 ? blue : (luma - 0.299 * red - 0.114 * blue) / 0.587;
  });
}

Picture with_wrong_pixels(Picture picture, std::size_t count) {
  std::mt19937 random(2);
  const std::size_t pixels = picture.values.size() / 3;
  for (std::size_t i = 0; i < count; ++i) {
    // Each another one: 7919 is prime and divides no number of pixels here.
    float& value = picture.values[3 * ((i * 7919 + random() % 2) % pixels)];
    value = value < 128 ? value + 100 : value - 100;
  }
  return picture;
}

} // namespace refraster::test
