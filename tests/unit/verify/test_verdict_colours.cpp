#include "verify/page/verdict_colours.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

using namespace refraster;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

struct Sight {
  std::string_view name;
  Matrix matrix; // of linear sRGB
};

/// Machado, Oliveira, Fernandes, "A physiologically-based model for simulation of color vision deficiency", 2009, of
/// full severity.
constexpr Sight sights[] = {
    {"trichromat", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    {"protanope",
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    {"deuteranope",
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    {"tritanope",
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};

Triple times(const Matrix& matrix, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i] += matrix[i][j] * v[j];
  return result;
}

/// CIE L*a*b* of 1976 under D65.
Triple lab(const Triple& linear) {
  constexpr Matrix to_xyz = {
      {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};
  constexpr Triple white = {0.95047, 1, 1.08883};
  Triple f = times(to_xyz, linear);
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = f[i] / white[i];
    f[i] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

Triple seen(const Rgb8& colour, const Sight& sight) {
  Triple linear{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double s = colour[i] / 255.0;
    linear[i] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
  }
  Triple result = times(sight.matrix, linear);
  for (double& channel : result) channel = std::min(1.0, std::max(0.0, channel));
  return lab(result);
}

double distance(const Triple& a, const Triple& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace

// 2.3 of CIE 1976 is what one just notices side by side; ten times that is another colour also for single pixels.
TEST_CASE("any two colours of classes are told apart, with deficient colour vision too") {
  for (const Sight& sight : sights)
    for (std::size_t i = 0; i < verdict_colours.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        CAPTURE(sight.name);
        CAPTURE(i);
        CAPTURE(j);
        CHECK(distance(seen(verdict_colours[i], sight), seen(verdict_colours[j], sight)) > 23);
      }
}

TEST_CASE("the measure of colours is right: red and green come near for a deuteranope, black and white stay apart") {
  constexpr Rgb8 red = {200, 70, 60}, green = {120, 120, 50}, black = {0, 0, 0}, white = {255, 255, 255};
  CHECK(distance(seen(red, sights[2]), seen(green, sights[2])) <
        0.5 * distance(seen(red, sights[0]), seen(green, sights[0])));
  for (const Sight& sight : sights)
    CHECK(distance(seen(black, sight), seen(white, sight)) == doctest::Approx(100).epsilon(0.01));
}
