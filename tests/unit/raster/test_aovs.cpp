// AOVs over several samples, numbers of materials, and images without a background.

#include <refraster/render.h>

#include "raster/levels.h"
#include "tests/support/precisions.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr int side = 8;

/// Two triangles over the columns from x0 to x1, all rows, at a distance.
Object& add_strip(WindowScene& window, double x0, double x1, double distance, const Double3& colour) {
  const Float3 a = window.place(x0, 0, distance), b = window.place(x1, 0, distance),
               c = window.place(x1, side, distance), d = window.place(x0, side, distance);
  return window.add({a, b, c, a, c, d}, colour);
}

/// Of the four samples of a pixel two lie left of its middle, the first among them.
constexpr double middle_of_column_4 = 4.5;

} // namespace

TEST_CASE("alpha is the fraction of samples that see a surface") {
  WindowScene window(side);
  add_strip(window, 0, middle_of_column_4, 2, Double3(0.5));
  for (const AovFilter filter : {AovFilter::nearest, AovFilter::resolve}) {
    RenderOptions options = window.options({Aov::alpha}, 4);
    options.aov_filter = filter;
    const Frame frame = render(window.scene, options);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) CHECK(*frame.aovs[0].at(x, y) == (x < 4 ? 1.0f : x == 4 ? 0.5f : 0.0f));
  }
}

TEST_CASE("a transparent image has the mean of the samples that see a surface, and is black where none does") {
  const Double3 colour(0.3, 0.6, 0.9), background(1, 0.5, 0.25);
  for (const Precision precision : every_precision)
    for (const int samples : {1, 2, 4, 8, 16}) {
      CAPTURE(samples);
      WindowScene window(side);
      window.scene.background = background;
      add_strip(window, 0, 4.375, 2, colour);
      RenderOptions options = window.options({Aov::alpha}, samples);
      options.precision = precision, options.want_rgb8 = true;
      const Frame blended = render(window.scene, options);
      options.background = Background::transparent;
      const Frame frame = render(window.scene, options);
      for (int x = 0; x < side; ++x)
        for (int c = 0; c < 3; ++c) {
          const float alpha = *frame.aovs[0].at(x, 3);
          // One colour: whatever the weights, it is the same, bit for bit.
          CHECK(frame.radiance.at(x, 3)[c] == (alpha > 0 ? frame.radiance.at(0, 3)[c] : 0.0f));
          CHECK(frame.rgb8.at(x, 3)[c] == (alpha > 0 ? frame.rgb8.at(0, 3)[c] : 0));
          CHECK(frame.radiance.at(0, 3)[c] == blended.radiance.at(0, 3)[c]);
          const float over = frame.radiance.at(x, 3)[c] * alpha + static_cast<float>(background[c]) * (1 - alpha);
          CHECK(blended.radiance.at(x, 3)[c] == doctest::Approx(static_cast<double>(over)).epsilon(1e-6));
        }
    }
}

TEST_CASE("distance is along the axis of the view, in units of the scene, and 0 where there is no surface") {
  WindowScene window(side);
  add_strip(window, 0, 4, 3, Double3(1));
  const Frame frame = window.frame({Aov::distance, Aov::position, Aov::depth});
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      CHECK(*frame.aovs[0].at(x, y) == (x < 4 ? doctest::Approx(3) : doctest::Approx(0)));
      CHECK(frame.aovs[1].at(x, y)[2] == -*frame.aovs[0].at(x, y));
    }
  CHECK(*frame.aovs[2].at(5, 5) == 1); // depth is not distance
}

TEST_CASE("resolved, an AOV is the mean over the samples that see a surface; a number is that of the first") {
  WindowScene window(side);
  add_strip(window, 0, middle_of_column_4, 2, Double3(1));
  add_strip(window, middle_of_column_4, 6, 4, Double3(1));
  RenderOptions options = window.options({Aov::distance, Aov::object, Aov::depth, Aov::position, Aov::normal}, 4);
  const Frame nearest = render(window.scene, options);
  options.aov_filter = AovFilter::resolve;
  const Frame resolved = render(window.scene, options);
  CHECK(*nearest.aovs[0].at(4, 2) == doctest::Approx(2));
  CHECK(*resolved.aovs[0].at(4, 2) == doctest::Approx(3));
  CHECK(resolved.aovs[3].at(4, 2)[2] == doctest::Approx(-3));
  CHECK(resolved.aovs[4].at(4, 2)[2] == 1); // of equal normals
  CHECK(*nearest.aovs[1].at(4, 2) == 1);
  CHECK(*resolved.aovs[1].at(4, 2) == 1);
  const float near_depth = *nearest.aovs[2].at(0, 2), far_depth = *nearest.aovs[2].at(5, 2);
  CHECK(*resolved.aovs[2].at(4, 2) == doctest::Approx(static_cast<double>(near_depth + far_depth) / 2));
  // Where one surface is seen, both are the same.
  for (std::size_t i = 0; i < resolved.aovs.size(); ++i)
    for (const int x : {0, 5, 7})
      for (int c = 0; c < kind_of(options.aovs[i]).channels; ++c)
        CHECK(resolved.aovs[i].at(x, 2)[c] ==
              doctest::Approx(static_cast<double>(nearest.aovs[i].at(x, 2)[c])).epsilon(1e-6));
}

TEST_CASE("resolved AOVs are the same for every number of threads and tile size") {
  WindowScene window(64);
  for (int i = 0; i < 12; ++i) {
    const double x = 3.3 + 4.7 * i;
    window.add({window.place(x, 2, 2 + i), window.place(64 - x, 60.5, 3), window.place(x / 2, 61, 9 - 0.5 * i)});
  }
  std::vector<Aov> aovs;
  for (int i = 0; i < static_cast<int>(Aov::count_); ++i) aovs.push_back(static_cast<Aov>(i));
  RenderOptions options = window.options(aovs, 8);
  options.aov_filter = AovFilter::resolve;
  const Frame reference = render(window.scene, options);
  for (const int tile_size : all_tile_sizes) {
    options.tile_size = tile_size, options.threads = 3;
    const Frame frame = render(window.scene, options);
    for (std::size_t i = 0; i < aovs.size(); ++i) CHECK(frame.aovs[i].values == reference.aovs[i].values);
  }
}

TEST_CASE("materials of a file count from 1; the object's own comes after them, or is the only one") {
  WindowScene window(side);
  Object& alone = add_strip(window, 0, 2, 2, Double3(1));
  CHECK(alone.materials.empty());
  Object& many = add_strip(window, 2, side, 2, Double3(1));
  auto mesh = std::make_shared<Mesh>(*many.mesh);
  mesh->material_runs = {{0, 1}, {1, no_material}};
  many.mesh = mesh;
  many.materials.assign(2, many.material);
  const Frame frame = window.frame({Aov::material});
  CHECK(*frame.aovs[0].at(0, 0) == 1);
  CHECK(*frame.aovs[0].at(side - 1, 0) == 2); // the second of the file
  CHECK(*frame.aovs[0].at(2, side - 1) == 3); // the object's own
}

TEST_CASE("16 bits: clamped, 65535 times, rounded half to even; by the curve where that is asked for") {
  const std::vector<double> values = {0,           1,           0.5, -1, 2, std::numeric_limits<double>::quiet_NaN(),
                                      0.5 / 65535, 1.5 / 65535, 0.25};
  // 0.5 / 65535 times 65535 is 0.5 and 1.5 / 65535 times it 1.5, each exactly.
  std::vector<std::uint16_t> levels(values.size());
  levels16(values.data(), values.size(), Transfer::linear, levels.data());
  CHECK(levels == std::vector<std::uint16_t>{0, 65535, 32768, 0, 65535, 0, 0, 2, 16384});
  const double encoded = 1.055 * std::pow(0.25, 1 / 2.4) - 0.055;
  levels16(values.data(), values.size(), Transfer::srgb, levels.data());
  CHECK(levels[8] == std::lround(65535 * encoded));
}
