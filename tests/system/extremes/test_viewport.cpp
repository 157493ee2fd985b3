// The extremes (docs/extremes.md), rows V11 to V15: the guard band, the viewport, many triangles.

#include <refraster/files.h>
#include <refraster/notes.h>

#include "tests/support/for_all.h"
#include "tests/support/raster/oracle.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <boost/multiprecision/cpp_int.hpp>

using namespace refraster;
using namespace refraster::test;

namespace {

// A window point as clip coordinates in an image of `side` pixels, with w = 1. Exact.
Double4 clip_at(std::int64_t x_subpixel, std::int64_t y_subpixel, int side) {
  const double half = 128.0 * side;
  return {static_cast<double>(x_subpixel) / half - 1, 1 - static_cast<double>(y_subpixel) / half, 0, 1};
}

} // namespace

TEST_CASE("V11: coverage is exact at the limits of the guard band and beyond, whichever integers compute it") {
  using Wide = boost::multiprecision::int1024_t;
  constexpr std::int64_t limits[] = {1 << 15, (1 << 16) - 1, 1 << 16, (1 << 16) + 1, 1 << 22, 1 << 29};
  constexpr int side = 64;
  for (const std::int64_t limit : limits)
    for_all(30, [&](Random& random) {
      CAPTURE(limit);
      // Corners at +-limit pixels, or within 3 subpixels of it, and one near the view.
      std::array<LatticePoint, 3> corner;
      for (LatticePoint& p : corner) {
        const auto far_away = [&] {
          return static_cast<std::int64_t>(random.sign()) * limit * subpixels + random.below(7) - 3;
        };
        p = {far_away(), far_away()};
      }
      corner[0] = {random.below(side * 256), random.below(side * 256)};
      std::array<Double4, 3> clip;
      for (std::size_t k = 0; k < 3; ++k) clip[k] = clip_at(corner[k].x, corner[k].y, side);
      const auto t = set_up(clip, side, side);
      if (!t) return;
      const bool within = std::max(std::abs(corner[1].x), std::abs(corner[1].y)) <= guard_band &&
                          std::max(std::abs(corner[2].x), std::abs(corner[2].y)) <= guard_band;
      CHECK(std::holds_alternative<SnappedTriangle>(t->set_up) == within);
      std::array<WindowVertex, 3> v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = window_vertex(clip[k], side, side);
      const auto wide = set_up_projective(v, clip, {side, side, 1});
      REQUIRE(wide);
      const AnyTriangle projective{*wide};
      for (int y = 128; y < side * 256; y += 256)
        for (int x = 128; x < side * 256; x += 256) {
          const bool expected = oracle_covers<Wide, 40>(corner, {x, y});
          REQUIRE(t->covers(x, y) == expected);
          REQUIRE(projective.covers(x, y) == expected);
        }
    });
}

TEST_CASE("V12: a pixel of the largest image is the same alone; images of one pixel and of odd sizes") {
  constexpr int side = 16384;
  WindowScene window(side);
  // Corners at whole pixels: x + y < 16381 in the first triangle, the rest in the second; what a pixel centre may show
  // is known. The shared edge runs through pixel corners.
  window.add({window.place(0, 0, 1), window.place(side, 0, 1), window.place(0, side, 1)}, {1, 0, 0});
  window.add({window.place(side, side, 1), window.place(side, 0, 1), window.place(0, side, 1)}, {0, 1, 0});
  const auto crop = [&](const PixelRect& c) {
    RenderOptions options = window.options({Aov::object, Aov::position});
    options.crop = c;
    return render(window.scene, options);
  };
  for (const auto& [x, y] :
       {std::pair(0, 0), std::pair(8190, 8190), std::pair(16381, 0), std::pair(0, 16376), std::pair(16376, 16376)}) {
    const Frame block = crop({x, y, 3, 8});
    for (int dy = 0; dy < 8; ++dy)
      for (int dx = 0; dx < 3; ++dx) {
        const Frame pixel = crop({x + dx, y + dy, 1, 1});
        for (std::size_t aov = 0; aov < 2; ++aov)
          for (int c = 0; c < block.aovs[aov].channels; ++c)
            REQUIRE(pixel.aovs[aov].at(0, 0)[c] == block.aovs[aov].at(dx, dy)[c]);
        // On the diagonal (x + y + 1 == side) the centre lies on the shared edge: bottom right of the first triangle,
        // left of the second, which owns it.
        REQUIRE(*pixel.aovs[0].at(0, 0) == (x + dx + y + dy + 1 < side ? 1 : 2));
        const Mpfr seen_at = exact(Rational(2 * (x + dx) + 1 - side, side));
        REQUIRE(abs(Mpfr(pixel.aovs[1].at(0, 0)[0]) - seen_at) <=
                half_float_ulp(seen_at) + interpolation_bound(Mpfr(1)));
      }
  }
  for (const auto& [w, h] : {std::pair(1, 1), std::pair(7, 3), std::pair(1, 16384)}) {
    RenderOptions options;
    options.width = w, options.height = h;
    options.threads = 1;
    WindowScene wall(1);
    wall.add({{-1e8f, -1e8f, -1}, {1e8f, -1e8f, -1}, {0, 1e8f, -1}});
    CHECK(render(wall.scene, options).counts.shaded == static_cast<std::uint64_t>(w) * static_cast<std::uint64_t>(h));
  }
}

TEST_CASE("V13: moving a triangle by whole pixels moves its fragments and changes none") {
  for_all(200, [](Random& random) {
    std::array<Double4, 3> clip;
    std::array<std::int64_t, 3> x{}, y{};
    constexpr int side = 64;
    for (std::size_t k = 0; k < 3; ++k) x[k] = random.below(32 * 256), y[k] = random.below(32 * 256);
    const auto placed = [&](std::int64_t dx, std::int64_t dy) {
      for (std::size_t k = 0; k < 3; ++k) {
        clip[k] = clip_at(x[k] + dx * 256, y[k] + dy * 256, side);
        clip[k].z = static_cast<double>(k) / 4 - 0.5;
      }
      return set_up(clip, side, side);
    };
    const int dx = random.below(33), dy = random.below(33);
    const auto here = placed(0, 0), there = placed(dx, dy);
    REQUIRE(here.has_value() == there.has_value());
    if (!here) return;
    const auto &a = std::get<SnappedTriangle>(here->set_up), &b = std::get<SnappedTriangle>(there->set_up);
    for (int py = 128; py < 32 * 256; py += 256)
      for (int px = 128; px < 32 * 256; px += 256) {
        REQUIRE(here->covers(px, py) == there->covers(px + dx * 256, py + dy * 256));
        REQUIRE(here->depth(px, py) == there->depth(px + dx * 256, py + dy * 256));
        for (std::size_t k = 0; k < 3; ++k) REQUIRE(a.edge[k].at(px, py) == b.edge[k].at(px + dx * 256, py + dy * 256));
      }
  });
}

namespace {

// A hundred thousand or ten million triangles that all cover the same pixels, of colours and depths in some order.
void check_pile(std::uint32_t triangles) {
  WindowScene window(4);
  auto mesh = std::make_shared<Mesh>();
  for (const double w : {2.0, 1.0, 1.0})
    for (const auto& [x, y] : {std::pair(-4, -4), std::pair(12, -4), std::pair(-4, 12)}) {
      mesh->positions.push_back(window.place(x, y, w));
      mesh->normals.emplace_back(0, 0, 1);
    }
  // Far, far, ... near, then the same near ones again: the first of the nearest is seen.
  for (std::uint32_t i = 0; i < triangles; ++i)
    mesh->triangles.push_back(i < triangles / 2 ? std::array<std::uint32_t, 3>{0, 1, 2}
                                                : std::array<std::uint32_t, 3>{3, 4, 5});
  window.add({});
  window.scene.objects[0].mesh = mesh;
  const Frame frame = window.frame({Aov::triangle});
  CHECK(frame.counts.drawn == triangles);
  CHECK(frame.counts.fragments == 16);
  for (const float seen : frame.aovs[0].values) CHECK(seen == static_cast<float>(triangles / 2 + 1));
}

} // namespace

TEST_CASE("V14: wrong indices are an error, repeated ones no fragment; a pile shows the first of the nearest") {
  const std::string path = (std::filesystem::temp_directory_path() / "refraster_v14.obj").string();
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n";
  CHECK_THROWS_AS(read_obj(path), InputError);
  std::remove(path.c_str());

  WindowScene window(8);
  window.scene.background = {0.25, 0.5, 0.75};
  const Frame empty = window.frame();
  CHECK(empty.counts.shaded == 0);
  for (int i = 0; i < 64; ++i) {
    CHECK(empty.radiance.at(i % 8, i / 8)[0] == 0.25f);
    CHECK(empty.radiance.at(i % 8, i / 8)[2] == 0.75f);
  }
  const Float3 a = window.place(1, 1, 1), b = window.place(7, 2, 1);
  window.add({a, a, b, a, b, a, b, b, b});
  const Frame repeated = window.frame();
  CHECK(repeated.counts.degenerate == 3);
  CHECK(repeated.counts.shaded == 0);
  check_pile(100'000);
}

TEST_CASE("V15: all of (x, y, z, w) times a power of two is the same image") {
  for_all(300, [](Random& random) {
    std::array<Double4, 3> clip;
    for (Double4& c : clip)
      c = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-1, 1),
           random.below(4) ? random.log_uniform(0.1, 10) : -random.log_uniform(1e-9, 10)};
    const auto here = set_up(clip, 32, 32);
    for (const int power : {-900, -30, 1, 64, 900}) {
      std::array<Double4, 3> scaled;
      for (std::size_t k = 0; k < 3; ++k)
        for (int c = 0; c < 4; ++c) scaled[k][c] = std::ldexp(clip[k][c], power);
      const auto there = set_up(scaled, 32, 32, std::ldexp(0x1p-120, power));
      REQUIRE(here.has_value() == there.has_value());
      if (!here) continue;
      for (int y = 128; y < 32 * 256; y += 256)
        for (int x = 128; x < 32 * 256; x += 256) {
          REQUIRE(here->covers(x, y) == there->covers(x, y));
          if (here->covers(x, y)) REQUIRE(here->depth(x, y) == there->depth(x, y));
        }
    }
  });
  // The whole scene, with its camera: every byte of depth, and every position times that power.
  const auto frame_of = [](float scale) {
    WindowScene window(32, 0.5 * static_cast<double>(scale), 64 * static_cast<double>(scale));
    window.add({scale * Float3(-3, -2, -4), scale * Float3(2, -1.5f, -3), scale * Float3(0.5f, 1.5f, -5),
                scale * Float3(-3, -1, -4), scale * Float3(2, -1, 4), scale * Float3(0.5f, -1, -1e5f)});
    return window.frame({Aov::depth, Aov::position});
  };
  const Frame plain = frame_of(1);
  for (const float scale : {0x1p-60f, 0x1p-1f, 0x1p60f}) {
    const Frame scaled = frame_of(scale);
    CHECK(scaled.rgb8.values == plain.rgb8.values);
    CHECK(scaled.aovs[0].values == plain.aovs[0].values);
    for (std::size_t i = 0; i < plain.aovs[1].values.size(); ++i)
      REQUIRE(scaled.aovs[1].values[i] == plain.aovs[1].values[i] * scale);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("V14: ten million triangles in one place") {
    check_pile(10'000'000);
  }
}
