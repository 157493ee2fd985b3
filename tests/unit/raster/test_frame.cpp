// Whole frames: the same bytes however they are computed, which surface a pixel shows, what is counted.

#include "tests/support/raster/window_scene.h"
#include "tests/support/scenes/hashed_scenes.h"

#include "tests/support/for_all.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

using namespace refraster;
using namespace refraster::test;

namespace {

const std::vector<Aov> every_aov = {Aov::depth,  Aov::normal,   Aov::position, Aov::uv,
                                    Aov::albedo, Aov::triangle, Aov::object, Aov::distance,
                                    Aov::alpha,  Aov::material};

RenderOptions everything(Precision precision, int samples) {
  RenderOptions options;
  options.width = hashed_width, options.height = hashed_height;
  options.precision = precision, options.samples = samples;
  options.threads = 1;
  options.want_radiance = true;
  options.want_radiance_double = true;
  options.aovs = every_aov;
  return options;
}

// Bytes, so that a NaN equals itself and -0 is not 0.
template <class Value>
bool same_rows(const Image<Value>& part, const Image<Value>& whole, const PixelRect& crop) {
  if (part.width != crop.width || part.height != crop.height || part.channels != whole.channels) return false;
  const auto row_bytes = static_cast<std::size_t>(crop.width * whole.channels) * sizeof(Value);
  for (int y = 0; y < crop.height; ++y)
    if (std::memcmp(part.at(0, y), whole.at(crop.x, crop.y + y), row_bytes) != 0) return false;
  return true;
}

bool same_images(const Frame& part, const Frame& whole, const PixelRect& crop) {
  bool same = same_rows(part.rgb8, whole.rgb8, crop) && same_rows(part.radiance, whole.radiance, crop) &&
              same_rows(part.radiance_double, whole.radiance_double, crop);
  for (std::size_t i = 0; i < whole.aovs.size(); ++i) same = same && same_rows(part.aovs[i], whole.aovs[i], crop);
  return same;
}

constexpr PixelRect whole_image{0, 0, hashed_width, hashed_height};

bool same_counts(const FrameCounts& a, const FrameCounts& b) {
  return a.triangles == b.triangles && a.not_finite == b.not_finite && a.outside == b.outside &&
         a.degenerate == b.degenerate && a.culled == b.culled && a.between_samples == b.between_samples &&
         a.clipped == b.clipped && a.drawn == b.drawn && a.pixels == b.pixels && a.shaded == b.shaded &&
         a.fragments == b.fragments && a.undefined.counts == b.undefined.counts;
}

/// body(scene, options) for each of the hashed scenes, in the precision double with one sample and in float with
/// 4.
template <class Body>
void for_each_rendering(Body&& body) {
  for (const HashedScene& hashed : hashed_scenes())
    for (const auto& way : {std::pair(Precision::double_, 1), std::pair(Precision::float_, 4)}) {
      const Precision precision = way.first;
      const int samples = way.second;
      INFO(hashed.name, " ", name_of(precision), ", samples: ", samples);
      body(hashed.scene, everything(precision, samples));
    }
}

} // namespace

TEST_CASE("the radiance in double, rounded once, is the radiance; in the float precision they are equal") {
  for_each_rendering([](const Scene& scene, const RenderOptions& options) {
    const Frame frame = render(scene, options);
    std::size_t differ = 0, only_double = 0;
    for (std::size_t i = 0; i < frame.radiance.values.size(); ++i) {
      const double most = static_cast<double>(std::numeric_limits<float>::max());
      const double value = std::clamp(frame.radiance_double.values[i], -most, most);
      differ += static_cast<float>(value) != frame.radiance.values[i];
      only_double += value != static_cast<double>(frame.radiance.values[i]);
    }
    CHECK(differ == 0);
    CHECK((only_double > 0) == (options.precision == Precision::double_));
  });
}

TEST_CASE("threads, tile sizes and crops change no byte, threads and tile sizes no count") {
  struct Way {
    int threads, tile_size;
  };
  for_each_rendering([](const Scene& scene, RenderOptions options) {
    const Frame reference = render(scene, options);
    for (const Way& way : {Way{2, 8}, Way{3, 128}, Way{7, 16}}) { // more: ctest determinism
      CAPTURE(way.threads);
      options.threads = way.threads, options.tile_size = way.tile_size;
      const Frame frame = render(scene, options);
      CHECK(same_images(frame, reference, whole_image));
      CHECK(same_counts(frame.counts, reference.counts));
    }
    options.threads = 2, options.tile_size = 64;
    for (const PixelRect& crop : {PixelRect{hashed_width - 1, hashed_height - 1, 1, 1}, PixelRect{13, 7, 101, 53}}) {
      CAPTURE(crop.x);
      options.crop = crop;
      CHECK(same_images(render(scene, options), reference, crop));
    }
  });
}

TEST_CASE("an AOV is the same alone and among others, whatever the precision of the colours") {
  for_each_rendering([](const Scene& scene, RenderOptions options) {
    const Frame together = render(scene, options);
    for (const Precision precision : {Precision::double_, Precision::float_})
      for (std::size_t i = 0; i < every_aov.size(); ++i) {
        CAPTURE(name_of(precision));
        CAPTURE(kind_of(every_aov[i]).name);
        options.precision = precision;
        options.aovs = {every_aov[i]};
        const Frame alone = render(scene, options);
        REQUIRE(same_rows(alone.aovs[0], together.aovs[i], whole_image));
      }
  });
}

TEST_CASE("the nearer surface is seen, and of equal depths the first drawn") {
  const Double3 red(1, 0, 0), green(0, 1, 0);
  for (const double second : {1.0, 2.0, 4.0}) {
    WindowScene window(16);
    const auto wall = [&](double w) -> std::vector<Float3> {
      return {window.place(-20, -20, w), window.place(60, -20, w), window.place(-20, 60, w)};
    };
    window.add(wall(2), red);
    window.add(wall(second), green);
    const Double3 expected = second < 2 ? green : red;
    const Frame frame = window.frame();
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        for (int c = 0; c < 3; ++c) REQUIRE(static_cast<double>(frame.radiance.at(x, y)[c]) == expected[c]);
  }
}

TEST_CASE("of equal depths the first drawn is seen, also among more triangles than one thread bins at a time") {
  // Copies of three triangles, one of a pixel, one of a tile's part, one that reaches behind the eye.
  WindowScene window(32);
  const std::vector<Float3> three = {window.place(2, 2, 2),   window.place(2, 3.75, 2),  window.place(3.75, 2, 2), //
                                     window.place(8, 8, 2),   window.place(8, 30, 2),    window.place(30, 8, 2),   //
                                     window.place(20, 31, 2), window.place(31.5, 31, 2), Float3(0.5f, -0.9f, 1)};
  std::vector<Float3> corners;
  constexpr int copies = 10'000;
  for (int i = 0; i < copies; ++i) corners.insert(corners.end(), three.begin(), three.end());
  window.add(corners);
  RenderOptions options = window.options({Aov::triangle});
  for (const int threads : {1, 2, 3}) {
    CAPTURE(threads);
    options.threads = threads;
    const Frame frame = render(window.scene, options);
    std::array<int, 3> seen{};
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        const auto triangle = static_cast<std::size_t>(*frame.aovs[0].at(x, y)); // 1 is the first
        REQUIRE(triangle <= 3);
        if (triangle > 0) ++seen[triangle - 1];
      }
    CHECK(seen[0] > 0);
    CHECK(seen[1] > 100);
    CHECK(seen[2] > 0);
  }
}

TEST_CASE("of a surface whose corners are as far apart as numbers go, no image holds a NaN") {
  // Found by tests/long/soak: pixel centres beside the triangle, whose weights are negative, meet differences that
  // overflow.
  WindowScene window(40);
  Camera& camera = window.scene.camera;
  camera.position = {0.73701800461055722, -1.5416186214758993, 5}, camera.target = {0.48756509844324114, 0, 0};
  camera.fov_y_degrees = 48.896216872619483;
  camera.near = 0.76924873205049449, camera.far = 90.694002923653983;
  Object& object =
      window.add({Float3(0.661498427f, -1.43856215f, 0.613956213f), Float3(-0.21665673f, 0.889735758f, -0.379767269f),
                  Float3(-0.262764961f, 0.214748695f, -0.629956663f)});
  object.position = {-0.58637887779609588, -0.61289978878925822, 0};
  object.rotate_degrees = {2.0610886613102082, 1.8592016082788074, -1.6990684980691275};
  object.scale = {2.620440056260632, -0.62828743940903875, std::numeric_limits<double>::max()};
  RenderOptions options = window.options({Aov::object, Aov::position, Aov::normal, Aov::albedo, Aov::uv}, 2);
  options.height = 19;
  const Frame frame = render(window.scene, options);
  CHECK(frame.counts.shaded > 0);
  for (const Image<float>& image : frame.aovs)
    CHECK(std::none_of(image.values.begin(), image.values.end(), [](float v) { return std::isnan(v); }));
}

TEST_CASE("triangles are counted by what became of them") {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  WindowScene window(16, 1, 8);
  const auto counts_of = [&](const std::vector<Float3>& corners, Cull cull = Cull::none) {
    WindowScene one = window;
    one.add(corners).cull = cull;
    const Frame frame = one.frame();
    CHECK(frame.counts.triangles == corners.size() / 3);
    CHECK(frame.counts.pixels == 256);
    return frame.counts;
  };
  const Float3 a = window.place(2, 2, 2), b = window.place(2, 10, 2), c = window.place(10, 2, 2); // counter-clockwise
  CHECK(counts_of({a, b, {nan, 0, 0}}).not_finite == 1);
  CHECK(counts_of({window.place(17, 2, 2), window.place(20, 2, 2), window.place(17, 9, 2)}).outside == 1);
  CHECK(counts_of({window.place(2, 2, 0.5), window.place(9, 2, 0.5), window.place(2, 9, 0.5)}).outside == 1);
  CHECK(counts_of({window.place(2, 2, 9), window.place(9, 2, 9), window.place(2, 9, 9)}).outside == 1);
  CHECK(counts_of({a, b, b}).degenerate == 1);
  CHECK(counts_of({window.place(2, 2, 2), window.place(6, 6, 2), window.place(10, 10, 2)}).degenerate == 1);
  CHECK(counts_of({a, b, window.place(2 + 0x1p-12, 6, 2)}).degenerate == 1); // has no area once it is snapped
  CHECK(counts_of({a, c, b}, Cull::back).culled == 1);
  CHECK(counts_of({a, b, c}, Cull::back).drawn == 1);
  CHECK(counts_of({window.place(2.75, 2, 2), window.place(3.25, 2, 2), window.place(3.25, 9, 2)}).between_samples == 1);

  const FrameCounts plain = counts_of({a, b, c});
  CHECK(plain.drawn == 1);
  CHECK(plain.clipped == 0);
  // Corners (2, 2), (2, 10), (10, 2): centres with x + y + 1 < 12 in rows and columns from 2; the long edge faces right
  // and down, so that it owns none of the centres on it. 7 + 6 + ... + 1 of them.
  CHECK(plain.shaded == 28);
  CHECK(plain.fragments == 28);
  const FrameCounts through_near = counts_of({a, b, window.place(10, 2, 0.5)});
  CHECK(through_near.drawn == 1);
  CHECK(through_near.clipped == 1);
  CHECK(counts_of({a, b, window.place(1 << 20, 2, 2)}).clipped == 1); // beyond the guard band

  const FrameCounts two = counts_of({a, b, c, a, b, window.place(10, 2, 1)});
  CHECK(two.drawn == 2);
  CHECK(two.shaded == 28); // however many surfaces lie behind
  CHECK(two.fragments == 28);
}

TEST_CASE("counts of parts add up member by member, none forgotten") {
  using Members = std::array<std::uint64_t, sizeof(FrameCounts) / sizeof(std::uint64_t)>;
  Members one, other;
  for (std::size_t i = 0; i < one.size(); ++i) one[i] = i + 1, other[i] = 1000 * (i + 1);
  auto sum = std::bit_cast<FrameCounts>(one);
  sum += std::bit_cast<FrameCounts>(other);
  const auto members = std::bit_cast<Members>(sum);
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(members[i] == one[i] + other[i]);

  TileSeconds seconds{1, 2, 3, 4};
  seconds += {10, 20, 30, 40};
  CHECK(std::bit_cast<std::array<double, 4>>(seconds) == std::array<double, 4>{11, 22, 33, 44});
}

TEST_CASE("a pixel of one sample shows its surface where its centre's ray meets it") {
  // Without snapping there is no bound to speak of: corners stand on the lattice, exactly.
  Random random(1);
  Mpfr worst = 0;
  for (int trial = 0; trial < 20; ++trial) {
    WindowScene window(16);
    std::vector<Float3> corners;
    for (int k = 0; k < 3; ++k) {
      const auto coordinate = [&] { return random.below(24 * 256) / 256.0 - 4; };
      const double x = coordinate(), y = coordinate();
      corners.push_back(window.place(x, y, std::exp2(random.below(7) - 1)));
    }
    window.add(corners);
    const Frame frame = window.frame({Aov::object, Aov::position});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const auto hit =
            ray_hit(window.centre_ray(x, y), rational(corners[0]), rational(corners[1]), rational(corners[2]));
        if (!hit || hit->how == Meets::border) continue; // ties: tests/unit/raster/test_coverage.cpp
        REQUIRE(is_drawn(frame, x, y) == (hit->how == Meets::inside));
        if (hit->how == Meets::outside) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          const Mpfr expected = exact(hit->point[c]), got(frame.aovs[1].at(x, y)[c]);
          const Mpfr error = abs(got - expected), bound = half_float_ulp(expected) + interpolation_bound(Mpfr(64));
          REQUIRE(error <= bound);
          worst = std::max(worst, Mpfr(error / bound));
        }
      }
  }
  MESSAGE("largest error: " << worst.convert_to<double>() << " of its bound");
}

TEST_CASE("how far the eye is changes no highlight") {
  for (const double distance : {0.5, 1.0, 4.0, 512.0}) {
    CAPTURE(distance);
    WindowScene window(1);
    Object& wall =
        window.add({window.place(-9, -9, distance), window.place(-9, 19, distance), window.place(19, -9, distance)});
    auto& phong = std::get<Phong>(wall.material.fragment_function);
    phong.ka = Double3(0), phong.ks = Double3(1), phong.glossiness = 1;
    window.scene.direction_lights.push_back({.direction = {0, -3, -4}, .radiance = Double3(1)});
    // n = v = (0, 0, 1), l = (0, 3, 4) / 5: r = 2 (n.l) n - l = (0, -3, 4) / 5, and r.v = 0.8.
    CHECK(*window.frame().radiance.at(0, 0) == 0.8f);
  }
}

TEST_CASE("samples stand at the standard positions") {
  // Vulkan 1.3, "Multisampling", table of standard sample locations; in sixteenths of a pixel.
  const std::vector<std::vector<std::pair<int, int>>> standard = {
      {{8, 8}},
      {{12, 12}, {4, 4}},
      {{6, 2}, {14, 6}, {2, 10}, {10, 14}},
      {{9, 5}, {7, 11}, {13, 9}, {5, 3}, {3, 13}, {1, 7}, {11, 15}, {15, 1}},
      {{9, 9},
       {7, 5},
       {5, 10},
       {12, 7},
       {3, 6},
       {10, 13},
       {13, 11},
       {11, 3},
       {6, 14},
       {8, 1},
       {4, 2},
       {2, 12},
       {0, 8},
       {15, 4},
       {14, 15},
       {1, 0}}};
  for (const auto& positions : standard) {
    const int samples = static_cast<int>(positions.size());
    CAPTURE(samples);
    // A black half plane over white: how much of each pixel it covers, for an edge at every 32nd of a pixel.
    for (int step = 0; step <= 32; ++step)
      for (const bool upright : {true, false}) {
        WindowScene window(8);
        window.scene.background = Double3(1);
        const double edge = 3 + step / 32.0;
        const auto corner = [&](double along, double across) {
          return upright ? window.place(along, across, 1) : window.place(across, along, 1);
        };
        // Left of, or above, the edge: a right or a bottom edge, which owns no sample that lies on it.
        window.add({corner(edge, -50), corner(edge, 50), corner(-100, -50), corner(edge, 50), corner(-100, 50),
                    corner(-100, -50)},
                   Double3(0));
        const Frame frame = window.frame({}, samples);
        const auto covered = std::count_if(positions.begin(), positions.end(),
                                           [&](const auto& p) { return 2 * (upright ? p.first : p.second) < step; });
        const float* const pixel = upright ? frame.radiance.at(3, 5) : frame.radiance.at(5, 3);
        REQUIRE(static_cast<double>(pixel[0]) == static_cast<double>(samples - covered) / samples);
      }
  }
}

TEST_CASE("samples of equal colours resolve to that colour, bit for bit") {
  Random random(2);
  for (const int samples : {2, 4, 8, 16})
    for (int trial = 0; trial < 20; ++trial) {
      const Double3 colour(random.uniform(0, 1), random.uniform(0, 100), random.uniform(0, 1e-3));
      WindowScene window(8);
      window.scene.background = colour;
      for (int i = 0; i < 20; ++i) { // small triangles: most pixels see several of them, and the background
        const auto corner = [&] { return window.place(random.uniform(-2, 10), random.uniform(-2, 10), 1); };
        window.add({corner(), corner(), corner()}, colour);
      }
      const Frame frame = window.frame({}, samples);
      CHECK(frame.counts.fragments > 64);
      for (int i = 0; i < 64; ++i)
        for (int c = 0; c < 3; ++c) REQUIRE(frame.radiance.at(i % 8, i / 8)[c] == static_cast<float>(colour[c]));
    }
}

TEST_CASE("samples of the largest number and of 0 resolve to the fraction of it, neither less than 0 nor more") {
  constexpr float largest = std::numeric_limits<float>::max();
  // The second is beyond the float precision's numbers: there it is the largest of them.
  for (const double huge : {static_cast<double>(largest), 1e300})
    for (const bool is_bright : {false, true}) {
      WindowScene window(8);
      window.scene.background = Double3(is_bright ? 0 : huge);
      const auto at = [&](double x, double y) { return window.place(x, y, 1); };
      // All that is left of x = 4.5. Half of each pattern's samples are: the middle of an edge belongs to the right.
      window.add({at(-20, -20), at(-20, 40), at(4.5, 40), at(-20, -20), at(4.5, 40), at(4.5, -20)},
                 Double3(is_bright ? huge : 0));
      for (const Precision precision : {Precision::double_, Precision::float_, Precision::fast})
        for (const int samples : {2, 4, 8, 16}) {
          RenderOptions options = window.options({}, samples);
          options.precision = precision;
          const Frame frame = render(window.scene, options);
          CAPTURE(precision);
          CAPTURE(samples);
          CHECK(frame.radiance.at(3, 3)[0] == (is_bright ? largest : 0));
          CHECK(frame.radiance.at(5, 3)[0] == (is_bright ? 0 : largest));
          // The mean of 1e300 and 0 is as large as ever in double.
          CHECK(frame.radiance.at(4, 3)[0] ==
                (huge > 1e100 && precision == Precision::double_ ? largest : largest / 2));
        }
    }
}

TEST_CASE("a renderer's frames do not depend on the frames before") {
  Renderer renderer;
  Frame frame;
  for_each_rendering([&](const Scene& scene, RenderOptions options) {
    options.threads = 2;
    const Frame reference = render(scene, options);
    for (int repeat = 0; repeat < 2; ++repeat) {
      renderer.render(scene, options, frame);
      CHECK(same_images(frame, reference, whole_image));
      CHECK(same_counts(frame.counts, reference.counts));
    }
    // Another shape in between, and fewer images.
    options.crop = PixelRect{3, 5, 70, 40}, options.tile_size = 16, options.threads = 1;
    options.want_radiance = false, options.aovs = {Aov::depth};
    renderer.render(scene, options, frame);
    CHECK(frame.radiance.empty());
    REQUIRE(frame.aovs.size() == 1);
    CHECK(same_rows(frame.rgb8, reference.rgb8, *options.crop));
    CHECK(same_rows(frame.aovs[0], reference.aovs[0], *options.crop));
  });
}

TEST_CASE("what a progress function throws comes out, and the next frame is whole") {
  const std::vector<HashedScene> scenes = hashed_scenes();
  Renderer renderer;
  Frame frame;
  for (const int threads : {1, 2, 3}) {
    RenderOptions options = everything(Precision::double_, 1);
    options.threads = threads, options.tile_size = 16;
    const Frame reference = render(scenes[0].scene, options);
    options.progress = [](double) { throw std::runtime_error("enough"); };
    CHECK_THROWS_WITH_AS(renderer.render(scenes[0].scene, options, frame), "enough", std::runtime_error);
    options.progress = nullptr;
    renderer.render(scenes[0].scene, options, frame);
    CHECK(same_images(frame, reference, whole_image));
  }
}
