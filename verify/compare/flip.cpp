#include "verify/compare/flip.h"

#include "math/vec.h"
#include "shading/srgb_curve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace refraster {
namespace {

constexpr double pi = std::numbers::pi;

// Colour spaces.

/// Of sRGB's primaries and white, D65; white has Y = 1.
const Double3x3 xyz_from_rgb =
    glm::transpose(Double3x3({10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                             {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                             {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}));
const Double3x3 rgb_from_xyz = glm::inverse(xyz_from_rgb);
const Double3 white = xyz_from_rgb * Double3(1);

/// A linear opponent space: lightness, red against green, blue against yellow.
Double3 opponent_from_rgb(const Double3& rgb) {
  const Double3 xyz = (xyz_from_rgb * rgb) / white;
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}
Double3 rgb_from_opponent(const Double3& ycc) {
  const double y = (ycc.x + 16) / 116;
  return rgb_from_xyz * (Double3(y + ycc.y / 500, y, y - ycc.z / 200) * white);
}

/// CIELAB, with a and b scaled by lightness: in the dark, colours are told apart less (Hunt).
Double3 hunt_lab_from_rgb(const Double3& rgb) {
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Double3 xyz = (xyz_from_rgb * rgb) / white;
  const double x = f(xyz.x), y = f(xyz.y), z = f(xyz.z), lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

/// The distance for large differences: lightness and chroma add up.
double hyab(const Double3& a, const Double3& b) {
  return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

// Filters.

using Plane = Image<double>;

/// Weights at -radius .. radius.
using Kernel = std::vector<double>;

template <class Weight>
Kernel kernel(int radius, Weight&& weight) {
  Kernel result;
  for (int i = -radius; i <= radius; ++i) result.push_back(weight(i));
  return result;
}

enum class Axis { x, y };

/// The sum of f(i) at(x + i, y), or at(x, y + i); the border goes on outside.
Plane along(const Plane& plane, const Kernel& weights, Axis axis) {
  const int radius = static_cast<int>(weights.size() / 2);
  Plane result(plane.width, plane.height, 1);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      double sum = 0;
      for (int i = -radius; i <= radius; ++i) {
        const int there_x = axis == Axis::x ? std::clamp(x + i, 0, plane.width - 1) : x;
        const int there_y = axis == Axis::x ? y : std::clamp(y + i, 0, plane.height - 1);
        sum += weights[static_cast<std::size_t>(i + radius)] * *plane.at(there_x, there_y);
      }
      *result.at(x, y) = sum;
    }
  return result;
}
Plane filtered(const Plane& plane, const Kernel& along_x, const Kernel& along_y) {
  return along(along(plane, along_x, Axis::x), along_y, Axis::y);
}

double sum_of(const Kernel& k) {
  double sum = 0;
  for (const double weight : k) sum += weight;
  return sum;
}

/// A contrast sensitivity function in space: a sum of Gaussians a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
  struct {
    double a, b;
  } gaussian[2];
};
constexpr Sensitivity sensitivities[3] = {
    {{{1, 0.0047}, {0, 1e-5}}}, {{{1, 0.0053}, {0, 1e-5}}}, {{{34.1, 0.04}, {13.5, 0.025}}}};

Plane seen(const Plane& plane, const Sensitivity& sensitivity) {
  constexpr double widest = 0.04;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * flip_pixels_per_degree));
  Plane result(plane.width, plane.height, 1);
  double whole = 0;
  for (const auto& gaussian : sensitivity.gaussian) {
    const double a = gaussian.a, b = gaussian.b;
    if (a == 0) continue;
    const Kernel k = kernel(radius, [&](int i) {
      const double d = i / flip_pixels_per_degree;
      return std::exp(-pi * pi * d * d / b);
    });
    const double height = a * std::sqrt(pi / b);
    whole += height * sum_of(k) * sum_of(k);
    const Plane part = filtered(plane, k, k);
    for (std::size_t i = 0; i < part.values.size(); ++i) result.values[i] += height * part.values[i];
  }
  for (double& value : result.values) value /= whole;
  return result;
}

/// How much of an edge and of a point there is at each pixel: lengths of first and second derivatives.
struct Features {
  Plane edge, point;
};

Features features(const Plane& lightness) {
  constexpr double deviation = 0.5 * 0.082 * flip_pixels_per_degree; // of the features' width, 0.082 degrees
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gauss = [&](int i) { return std::exp(-(i * i) / (2 * deviation * deviation)); };
  Kernel smooth = kernel(radius, gauss);
  Kernel first = kernel(radius, [&](int i) { return -i * gauss(i); });
  Kernel second = kernel(radius, [&](int i) { return (i * i / (deviation * deviation) - 1) * gauss(i); });
  // Positive weights to a sum of 1, negative ones to -1, and the smoothing to 1.
  const double smooth_sum = sum_of(smooth);
  for (double& weight : smooth) weight /= smooth_sum;
  for (Kernel* const k : {&first, &second}) {
    double positive = 0, negative = 0;
    for (const double weight : *k) (weight > 0 ? positive : negative) += weight;
    for (double& weight : *k) weight /= weight > 0 ? positive : -negative;
  }
  const auto lengths = [&](const Kernel& derivative) {
    const Plane x = filtered(lightness, derivative, smooth), y = filtered(lightness, smooth, derivative);
    Plane result = x;
    for (std::size_t i = 0; i < x.values.size(); ++i) result.values[i] = std::hypot(x.values[i], y.values[i]);
    return result;
  };
  return {lengths(first), lengths(second)};
}

/// What an observer sees of an image.
struct Percept {
  std::vector<Double3> colour; // after the eye's filter
  Features features;
};

Percept percept(const Image<float>& image) {
  Plane channels[3];
  for (Plane& channel : channels) channel = Plane(image.width, image.height, 1);
  Plane lightness(image.width, image.height, 1);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      Double3 rgb;
      for (int c = 0; c < 3; ++c) rgb[c] = srgb_decoded(static_cast<double>(image.at(x, y)[c]) / 255);
      const Double3 ycc = opponent_from_rgb(rgb);
      for (int c = 0; c < 3; ++c) *channels[c].at(x, y) = ycc[c];
      *lightness.at(x, y) = (ycc.x + 16) / 116;
    }
  for (int c = 0; c < 3; ++c) channels[c] = seen(channels[c], sensitivities[c]);
  Percept result{{}, features(lightness)};
  for (std::size_t i = 0; i < lightness.values.size(); ++i) {
    const Double3 rgb = rgb_from_opponent({channels[0].values[i], channels[1].values[i], channels[2].values[i]});
    result.colour.push_back(hunt_lab_from_rgb(glm::clamp(rgb, 0.0, 1.0)));
  }
  return result;
}

/// In [0, 1]: small distances keep most of the range, since large ones all look alike.
double colour_difference(const Double3& a, const Double3& b) {
  constexpr double power = 0.7, knee = 0.4, knee_value = 0.95;
  static const double largest = std::pow(hyab(hunt_lab_from_rgb({0, 1, 0}), hunt_lab_from_rgb({0, 0, 1})), power);
  const double d = std::pow(hyab(a, b), power), at_knee = knee * largest;
  return d < at_knee ? d * knee_value / at_knee : knee_value + (d - at_knee) / (largest - at_knee) * (1 - knee_value);
}

} // namespace

double mean_flip(const Image<float>& reference, const Image<float>& test) {
  const Percept a = percept(reference), b = percept(test);
  double sum = 0;
  for (std::size_t i = 0; i < a.colour.size(); ++i) {
    const double edge = std::abs(a.features.edge.values[i] - b.features.edge.values[i]);
    const double point = std::abs(a.features.point.values[i] - b.features.point.values[i]);
    const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
    sum += std::pow(colour_difference(a.colour[i], b.colour[i]), 1 - feature);
  }
  return a.colour.empty() ? 0 : sum / static_cast<double>(a.colour.size());
}

} // namespace refraster
