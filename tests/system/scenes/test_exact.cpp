// The precision `exact` against the tests' own renderer in long double, which shares no line with it; and every
// precision against `exact` and against bounds.

#include "math/bounds/interval_functions.h"
#include "raster/render_in.h"
#include "shading/precision_bounds.h"
#include "tests/support/scenes/half_textured.h"
#include "tests/support/scenes/listed_scenes.h"
#include "tests/support/slow/slow_shading.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace refraster {
namespace {

/// Of the slow path, as a fraction of the sum of all that was added up to a colour: roundings of 2^-64, of world
/// positions with magnitudes up to 2^10 that are seen from 2^-1 away or more, turn directions by at most 2^-64 2^11
/// 2^2; and a highlight, a texel or a bin of a table changes its value at most 2^10 times as fast as the direction
/// turns. As in test_colours.cpp, for another number.
constexpr slow::Real error_fraction = 0x1p-41L;

/// How many pixels were compared.
std::size_t check_against_slow_path(const Scene& scene, int rows_apart) {
  constexpr int width = 320, height = 180;
  std::vector<slow::Pixel> pixels;
  for (int y = 3; y < height; y += rows_apart)
    for (int x = 5; x < width; x += 21) pixels.push_back({x, y});

  RenderOptions options;
  options.width = width, options.height = height;
  SampleRequest<Exact> request;
  request.wanted = [&](int x, int y) { return y >= 3 && (y - 3) % rows_apart == 0 && x >= 5 && (x - 5) % 21 == 0; };
  Image<Exact> found(width, height, 3);
  Image<std::uint8_t> shown(width, height, 1);
  request.take = [&](int x, int y, const Rgb<Exact>& rgb) {
    *shown.at(x, y) = 1;
    for (int c = 0; c < 3; ++c) found.at(x, y)[c] = rgb[c];
  };
  shade_in(scene, options, request);

  const auto seen = slow::seen_at(scene, width, height, pixels, slow::Vertices::of_the_renderer);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto x = pixels[i].x, y = pixels[i].y;
    if (!seen[i] || !seen[i]->object || !*shown.at(x, y)) continue;
    const auto expected = slow::shaded(scene, *seen[i]);
    if (!expected) continue;
    ++compared;
    CAPTURE(x);
    CAPTURE(y);
    const slow::Real values[] = {expected->radiance.x, expected->radiance.y, expected->radiance.z};
    const slow::Real sizes[] = {expected->magnitude.x, expected->magnitude.y, expected->magnitude.z};
    for (int c = 0; c < 3; ++c) {
      CAPTURE(c);
      const auto exact = found.at(x, y)[c].value().convert_to<slow::Real>();
      CHECK(std::abs(exact - values[c]) <= error_fraction * sizes[c]);
    }
  }
  return compared;
}

void check_against_slow_path(const std::vector<std::string>& paths, int rows_apart) {
  std::size_t compared = 0;
  for (const std::string& path : paths) {
    CAPTURE(path);
    compared += check_against_slow_path(listed_scene(path), rows_apart);
  }
  CHECK(compared >= 100);
}

using InDouble = Interval<DoubleArithmetic>;
using InFloat = Interval<FloatArithmetic>;

bool contains(const auto& bounds, const Exact& x) {
  return Exact(bounds.lo) <= x && x <= Exact(bounds.hi);
}

/// Every pixel of a small frame. The samples of `exact`, of the bounds and of the precisions are the same.
void check_frame(const Scene& scene, int samples, int width = 64, int height = 36) {
  CAPTURE(samples);
  RenderOptions options;
  options.width = width, options.height = height, options.samples = samples;
  options.want_rgb8 = false, options.want_radiance_double = true;
  const Frame in_double = render(scene, options);
  options.precision = Precision::float_;
  const Frame in_float = render(scene, options);
  const Image<Exact> exact = render_in<Exact>(scene, options);
  const Image<InDouble> double_bounds = render_in<InDouble>(scene, options);
  const Image<InFloat> float_bounds = render_in<InFloat>(scene, options);
  std::size_t far = 0, outside = 0, loose = 0;
  for (std::size_t i = 0; i < exact.values.size(); ++i) {
    const double found = in_double.radiance_double.values[i];
    // docs/precision.md, "Frames": the error of a pixel in units of 2^-53 of the image's white, or of itself if
    // brighter.
    const Exact error = abs(Exact(found) - exact.values[i]);
    far += error > Exact(frame_error_units * 0x1p-53) * max(Exact(1), abs(exact.values[i]));
    outside += !double_bounds.values[i].contains(found);
    outside += !contains(double_bounds.values[i], exact.values[i]);
    outside += !float_bounds.values[i].contains(in_float.radiance_double.values[i]);
    outside += !contains(float_bounds.values[i], exact.values[i]);
    loose += !(double_bounds.values[i].width() <= 0x1p-20); // [-inf, inf] would prove nothing
    loose += !(float_bounds.values[i].width() <= 1);
  }
  CHECK(far == 0);
  CHECK(outside == 0);
  // Bounds that are told of no visibility let a light with a shadow add anything from nothing on.
  if (!has_shadows(scene)) CHECK(loose <= exact.values.size() / 100);
}

/// The sample of each pixel anywhere in a box around its centre, as a device may place it: bounds over the box hold
/// what exact arithmetic makes of its corners, or of the first of them, and of its centre.
void check_samples_in_a_box(const Scene& scene, std::size_t corners) {
  constexpr double reach = 0.6; // subpixels: half of one, by snapping, and a little
  RenderOptions options;
  options.width = 64, options.height = 36;
  SampleRequest<InDouble> anywhere;
  anywhere.dx = anywhere.dy = {-reach, reach};
  const Image<InDouble> bounds = render_in<InDouble>(scene, options, anywhere);
  std::size_t outside = 0, moved = 0;
  const Image<Exact> centre = render_in<Exact>(scene, options);
  for (std::size_t i = 0; i < centre.values.size(); ++i) outside += !contains(bounds.values[i], centre.values[i]);
  constexpr std::array<std::pair<double, double>, 4> all_corners{
      {{-reach, -reach}, {reach, reach}, {reach, -reach}, {-reach, reach}}};
  for (std::size_t k = 0; k < corners; ++k) {
    SampleRequest<Exact> there;
    there.dx = Exact(all_corners[k].first), there.dy = Exact(all_corners[k].second);
    const Image<Exact> exact = render_in<Exact>(scene, options, there);
    for (std::size_t i = 0; i < exact.values.size(); ++i) {
      outside += !contains(bounds.values[i], exact.values[i]);
      moved += !(exact.values[i] == centre.values[i]);
    }
  }
  CHECK(outside == 0);
  CHECK(moved >= 250 * corners);
}

} // namespace

TEST_CASE("exact says what the slow path in long double says") {
  check_against_slow_path(quick_scenes(), 34);
}

TEST_CASE("so it does of a mesh of which only some triangles have texture coordinates, and bounds hold") {
  for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear}) {
    const Scene scene = half_textured(filter);
    CHECK(check_against_slow_path(scene, 17) >= 20);
    check_frame(scene, 1);
  }
}

TEST_CASE("double and float lie within their bounds, and double near exact, in every pixel of some scenes") {
  for (const std::string& path : quick_scenes()) {
    CAPTURE(path);
    check_frame(listed_scene(path), 1);
  }
}

TEST_CASE("bounds over a box of sample positions hold what exact makes of its corners") {
  check_samples_in_a_box(listed_scene(quick_scenes().front()), 4);
}

TEST_SUITE("slow") {
  TEST_CASE("exact says so in every scene of the gallery") {
    check_against_slow_path(listed_scenes(), 67);
  }

  TEST_CASE("double and float lie within their bounds, and double near exact, in every pixel of the gallery, small") {
    for (const std::string& path : listed_scenes()) {
      CAPTURE(path);
      check_frame(listed_scene(path), 1, 24, 14);
    }
  }
}

TEST_SUITE("long") {
  TEST_CASE("bounds over boxes hold what exact makes of all corners, in all these scenes") {
    for (const std::string& path : quick_scenes()) {
      CAPTURE(path);
      check_samples_in_a_box(listed_scene(path), 4);
    }
  }

  TEST_CASE("exact says what the slow path says at more pixels of the whole gallery") {
    check_against_slow_path(listed_scenes(), 17);
  }

  TEST_CASE("double and float lie within their bounds in every pixel of the whole gallery") {
    for (const std::string& path : listed_scenes()) {
      CAPTURE(path);
      check_frame(listed_scene(path), 1);
    }
  }

  TEST_CASE("so they do where a pixel has four samples") {
    for (const std::string& path : listed_scenes()) {
      CAPTURE(path);
      check_frame(listed_scene(path), 4);
    }
  }
}

} // namespace refraster
