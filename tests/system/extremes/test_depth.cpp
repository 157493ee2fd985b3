// The extremes (docs/extremes.md), rows Z: depth.

#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace refraster;
using namespace refraster::test;

namespace {

const Double3 first_colour(1, 0, 0), second_colour(0, 1, 0);

// A wall across the whole view at distance w.
std::vector<Float3> wall(const WindowScene& window, double w) {
  const double s = window.side;
  return {window.place(-s, -s, w), window.place(3 * s, -s, w), window.place(-s, 3 * s, w)};
}

// Which of two objects each pixel shows: how many show the second.
long second_shown(const WindowScene& window) {
  const Frame frame = window.frame({Aov::object});
  long count = 0;
  for (const float object : frame.aovs[0].values) {
    REQUIRE(object != 0);
    count += object == 2;
  }
  return count;
}

// z / w for distance w, exactly: (far + near) / (far - near) - 2 far near / ((far - near) w).
Rational exact_depth(double near, double far, const Rational& w) {
  const Rational n(near), f(far);
  return (f + n) / (f - n) - 2 * f * n / ((f - n) * w);
}

} // namespace

TEST_CASE(
    "Z1: with near / far = 1e-9, surfaces are told apart as finely as z / w in double can, and ties go to the first") {
  // Depth is z / w in double: near 1 its neighbours are 2^-53 apart, and z, w and the quotient are good to 8 of those
  // in all. A step of s in w changes z / w by about 2 near s / w^2, so what is further apart than 8 2^-53 w^2 / near is
  // seen in order. At the far end that is 8.9e-7 of far; a 24-bit depth buffer ends at 1.7 % of far.
  const double near = 1, far = 1e9;
  for (const double fraction : {1e-8, 1e-4, 0.017, 0.1, 0.5, 0.9}) {
    CAPTURE(fraction);
    const float w = static_cast<float>(fraction * far);
    const double resolved = 8 * 0x1p-53 * static_cast<double>(w) * static_cast<double>(w) / near;
    float behind = std::nextafter(w, INFINITY);
    while (static_cast<double>(behind - w) < resolved) behind = std::nextafter(behind, INFINITY);
    for (const bool nearer_first : {true, false}) {
      WindowScene window(8, near, far);
      window.add(wall(window, static_cast<double>(nearer_first ? w : behind)), first_colour);
      window.add(wall(window, static_cast<double>(nearer_first ? behind : w)), second_colour);
      CHECK(second_shown(window) == (nearer_first ? 0 : 64));
    }
    WindowScene same(8, near, far);
    same.add(wall(same, static_cast<double>(w)));
    same.add(wall(same, static_cast<double>(w)));
    CHECK(second_shown(same) == 0);
  }
}

TEST_CASE("Z2: of coplanar duplicates the first is seen everywhere, in whatever order their corners come") {
  for_all(60, [](Random& random) {
    const WindowScene empty(16);
    std::vector<Float3> corner;
    for (int k = 0; k < 3; ++k) // in view, or through the near plane and the eye plane
      corner.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 1));
    for (int turn = 1; turn < 6; ++turn) {
      std::vector<Float3> turned = corner;
      std::rotate(turned.begin(), turned.begin() + turn % 3, turned.end());
      if (turn >= 3) std::swap(turned[1], turned[2]);
      WindowScene window = empty;
      window.add(corner, first_colour);
      window.add(turned, second_colour);
      const Frame frame = window.frame({Aov::object});
      for (const float object : frame.aovs[0].values) REQUIRE(object != 2);
    }
  });
}

TEST_CASE("Z3: of coplanar surfaces in different triangles the first is seen, or the same one in every run") {
  // Facing the eye, all corners have one depth, and so has every sample.
  WindowScene window(16);
  const auto at = [&](double x, double y, double w) { return window.place(x, y, w); };
  window.add({at(0, 0, 2), at(16, 0, 2), at(0, 16, 2), at(16, 16, 2), at(16, 0, 2), at(0, 16, 2)}, first_colour);
  window.add({at(0, 0, 2), at(16, 16, 2), at(16, 0, 2), at(0, 0, 2), at(0, 16, 2), at(16, 16, 2)}, second_colour);
  CHECK(second_shown(window) == 0);

  // Sloped: both diagonals of the same trapezium. The corners' depths are rounded, so their planes are not quite one;
  // the bound of each depth holds for both.
  WindowScene sloped(16);
  const Float3 a = sloped.place(0, 16, 1), b = sloped.place(16, 16, 1), c = sloped.place(16, 0, 4),
               d = sloped.place(0, 0, 4);
  sloped.add({a, b, c, a, c, d}, first_colour);
  sloped.add({b, c, d, b, d, a}, second_colour);
  const Frame frame = sloped.frame({Aov::object});
  RenderOptions options = sloped.options({Aov::object});
  for (const int threads : all_threads)
    for (const int tile_size : all_tile_sizes) {
      options.threads = threads, options.tile_size = tile_size;
      CHECK(render(sloped.scene, options).aovs[0].values == frame.aovs[0].values);
    }
  const auto set_up_of = [&](const Float3& p, const Float3& q, const Float3& r) {
    return *set_up({sloped.clip(p), sloped.clip(q), sloped.clip(r)}, 16, 16);
  };
  const AnyTriangle first[] = {set_up_of(a, b, c), set_up_of(a, c, d)},
                    second[] = {set_up_of(b, c, d), set_up_of(b, d, a)};
  for (int y = 128; y < 16 * 256; y += 256)
    for (int x = 128; x < 16 * 256; x += 256)
      for (const AnyTriangle& t : first)
        for (const AnyTriangle& u : second)
          if (t.covers(x, y) && u.covers(x, y)) CHECK(std::abs(t.depth(x, y) - u.depth(x, y)) <= 2 * 0x1p-48);
}

TEST_CASE("Z4: intersecting surfaces meet at the analytic line") {
  for_all(40, [](Random& random) {
    // Two planes across the view, leaning at random; corners on the lattice, so that depths are those of the planes.
    WindowScene window(16, 0.25, 64);
    std::array<std::array<Float3, 3>, 2> corner;
    for (auto& triangle : corner) {
      triangle = {window.place(-16, -16, std::exp2(random.below(5))), window.place(48, -16, std::exp2(random.below(5))),
                  window.place(-16, 48, std::exp2(random.below(5)))};
      window.add({triangle[0], triangle[1], triangle[2]});
    }
    const Frame frame = window.frame({Aov::object});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        std::array<Rational, 2> w;
        for (std::size_t i = 0; i < 2; ++i) {
          const auto hit =
              ray_hit(window.centre_ray(x, y), rational(corner[i][0]), rational(corner[i][1]), rational(corner[i][2]));
          REQUIRE(hit);
          w[i] = -hit->point[2];
        }
        const Rational apart = exact_depth(0.25, 64, w[1]) - exact_depth(0.25, 64, w[0]);
        if (abs(apart) <= Rational(2 * 0x1p-48)) continue; // each depth within 2^-48, as interpolation_bound derives
        REQUIRE(*frame.aovs[0].at(x, y) == (apart > 0 ? 1 : 2));
      }
  });
}

TEST_CASE("Z5: depths 0 and 1 are drawn, depths outside are not, and 0 is +0") {
  // near 1, far 3: z / w is -1 and 1 exactly on the planes. The row's clamping mode (depth clamp) is not offered.
  const auto depth_at = [](double w) {
    WindowScene window(8, 1, 3);
    window.add(wall(window, w));
    return window.frame({Aov::depth, Aov::object});
  };
  const Frame near = depth_at(1), far = depth_at(3);
  CHECK(drawn_pixels(near, 1) == 64);
  CHECK(drawn_pixels(far, 1) == 64);
  for (int i = 0; i < 64; ++i) {
    const float at_near = *near.aovs[0].at(i % 8, i / 8);
    CHECK(at_near == 0);
    CHECK(!std::signbit(at_near));
    CHECK(*far.aovs[0].at(i % 8, i / 8) == 1);
  }
  // z / w = 2 - 3 / w: one float closer than near it is 1.8e-7 below -1, far more than double's rounding.
  CHECK(drawn_pixels(depth_at(static_cast<double>(std::nextafter(1.f, 0.f))), 1) == 0);
  CHECK(drawn_pixels(depth_at(static_cast<double>(std::nextafter(3.f, 4.f))), 1) == 0);
  CHECK(drawn_pixels(depth_at(static_cast<double>(std::nextafter(1.f, 2.f))), 1) == 64);
  CHECK(drawn_pixels(depth_at(static_cast<double>(std::nextafter(3.f, 0.f))), 1) == 64);
}

TEST_CASE("Z6: the depth image is the exact depth rounded to the nearest float, and monotone") {
  // Integer formats are not offered: the image holds floats of (z / w + 1) / 2.
  const double near = 0.5, far = 50;
  float before = -1;
  for (double w = 0.75; w < 50; w *= 1.0078125) {
    WindowScene window(8, near, far);
    const std::vector<Float3> corners = wall(window, w);
    window.add(corners);
    const Frame frame = window.frame({Aov::depth});
    const Rational exactly = (exact_depth(near, far, Rational(-corners[0].z)) + 1) / 2;
    for (const float depth : frame.aovs[0].values) {
      CHECK(abs(Mpfr(depth) - exact(exactly)) <= half_float_ulp(exact(exactly)) + interpolation_bound(Mpfr(1)));
      CHECK(depth == frame.aovs[0].values[0]);
    }
    CHECK(frame.aovs[0].values[0] >= before);
    before = frame.aovs[0].values[0];
  }
}

TEST_CASE("Z7: seen almost edge-on, depth stays between the corners' depths") {
  for_all(300, [](Random& random) {
    std::array<Double4, 3> clip;
    const double x = random.uniform(-0.9, 0.9), lean = random.log_uniform(1e-6, 1e-2);
    double z_min = 1, z_max = -1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double z = random.uniform(-1, 1);
      z_min = std::min(z_min, z), z_max = std::max(z_max, z);
      clip[k] = {x + lean * random.uniform(-1, 1), random.uniform(-1, 1), z, 1};
    }
    const auto t = set_up(clip, 64, 64);
    if (!t) return;
    for (int py = 0; py < 64; ++py)
      for (int px = 0; px < 64; ++px) {
        const int sx = px * 256 + 128, sy = py * 256 + 128;
        if (!t->covers(sx, sy)) continue;
        const double depth = t->depth(sx, sy);
        REQUIRE(depth >= z_min);
        REQUIRE(depth <= z_max);
      }
  });
  // And one that spans all depths within a subpixel: a slope of 512 a pixel.
  WindowScene window(8, 1, 3);
  window.add({window.place(4.5, -64, 1), window.place(4.5, 64, 1), window.place(4.5 + 1.0 / 256, 0, 3)});
  const Frame frame = window.frame({Aov::depth, Aov::object});
  CHECK(drawn_pixels(frame, 1) == 8);
  for (int y = 0; y < 8; ++y) CHECK(*frame.aovs[0].at(4, y) == 0); // its left edge, at the near plane
}
