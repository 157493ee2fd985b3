// The extremes (docs/extremes.md), rows V1 to V10: vertices and clipping.

#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <limits>

#include <boost/multiprecision/cpp_int.hpp>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr float largest = std::numeric_limits<float>::max();

bool same_picture(const Frame& a, const Frame& b) {
  bool same = a.rgb8.values == b.rgb8.values && a.radiance.values == b.radiance.values;
  for (std::size_t i = 0; i < a.aovs.size(); ++i) same = same && a.aovs[i].values == b.aovs[i].values;
  return same;
}

// A triangle with one corner that is no place must leave its neighbours as they are.
void check_dropped(float bad) {
  for (int axis = 0; axis < 3; ++axis)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      WindowScene window(32);
      const std::vector<Float3> shared = {window.place(2, 2, 2), window.place(30, 2, 1), window.place(2, 30, 4)};
      WindowScene without = window;
      without.add(shared);
      std::vector<Float3> both = shared;
      both.insert(both.end(), {shared[1], window.place(30, 30, 1), shared[2]});
      both[3 + corner][axis] = bad;
      window.add(both);
      const Frame frame = window.frame({Aov::object, Aov::depth, Aov::position, Aov::normal});
      CHECK(frame.counts.not_finite == 1);
      CHECK(frame.counts.drawn == 1);
      CHECK(same_picture(frame, without.frame({Aov::object, Aov::depth, Aov::position, Aov::normal})));
    }
}

// A triangle of three corners seen at every pixel where its ray meets it between the depth planes, and nowhere else.
// Corners in view must stand on the lattice.
long check_rays(const WindowScene& empty, const std::array<Float3, 3>& corners) {
  WindowScene window = empty;
  window.add({corners[0], corners[1], corners[2]});
  const Frame frame = window.frame({Aov::object});
  long drawn = 0, wrong = 0;
  const Rational near(window.scene.camera.near), far(window.scene.camera.far);
  for (int y = 0; y < window.side; ++y)
    for (int x = 0; x < window.side; ++x) {
      const auto hit =
          ray_hit(window.centre_ray(x, y), rational(corners[0]), rational(corners[1]), rational(corners[2]));
      if (hit && hit->how == Meets::border) continue;
      const bool expected = hit && hit->how == Meets::inside && -hit->point[2] >= near && -hit->point[2] <= far;
      wrong += is_drawn(frame, x, y) != expected;
      drawn += expected;
    }
  CHECK(wrong == 0);
  return drawn;
}

} // namespace

TEST_CASE("V1: a triangle with a NaN vertex is dropped and counted, its neighbours are untouched") {
  check_dropped(not_a_number);
  for (int component = 0; component < 4; ++component) {
    Double4 clip(0.5, 0.25, 0, 1);
    clip[component] = std::numeric_limits<double>::quiet_NaN();
    CHECK((window_vertex(clip, 32, 32).outcode & outcode::not_finite) != 0);
  }
}

TEST_CASE("V2: a triangle with an infinite vertex is dropped and counted, its neighbours are untouched") {
  check_dropped(infinite);
  check_dropped(-infinite);
  for (int component = 0; component < 4; ++component)
    for (const double sign : {1, -1}) {
      Double4 clip(0.5, 0.25, 0, 1);
      clip[component] = sign * std::numeric_limits<double>::infinity();
      CHECK((window_vertex(clip, 32, 32).outcode & outcode::not_finite) != 0);
    }
}

TEST_CASE("V3: a triangle as large as the largest float covers the view that it contains") {
  for (const float size : {1e3f, 1e8f, 1e16f, 1e30f, largest}) {
    CAPTURE(size);
    WindowScene window(32);
    window.add({{-size, -size, -1}, {size, -size, -1}, {0, size, -1}});
    for (const Precision precision : {Precision::double_, Precision::float_}) {
      RenderOptions options = window.options({Aov::object, Aov::depth});
      options.precision = precision;
      const Frame frame = render(window.scene, options);
      CHECK(drawn_pixels(frame) == 1024);
      // z / w of every corner is a + b with a = (far + near) / (near - far), b = 2 far near / (near - far) at w = 1.
      const Rational near(0.25), far(1024);
      const Rational depth = ((far + near) / (far - near) - 2 * far * near / (far - near) + 1) / 2;
      for (int i = 0; i < 1024; ++i) {
        const Mpfr error = abs(Mpfr(*frame.aovs[1].at(i % 32, i / 32)) - exact(depth));
        REQUIRE(error <= half_float_ulp(exact(depth)) + interpolation_bound(Mpfr(1)));
        for (int c = 0; c < 3; ++c) REQUIRE(frame.radiance.at(i % 32, i / 32)[c] == 1);
      }
    }
  }
}

TEST_CASE("V4: denormal coordinates are drawn as their ratios say") {
  const auto denormal = [](double x) { return static_cast<float>(x * 0x1p-133); }; // 1e-40
  WindowScene window(32, 0x1p-140, 0x1p-120);
  const std::array<Float3, 3> small = {Float3(denormal(-1), denormal(-0.75), denormal(-1)),
                                       Float3(denormal(1), denormal(-0.75), denormal(-1.5)),
                                       Float3(denormal(0), denormal(0.75), denormal(-1))};
  CHECK(std::fpclassify(small[0].x) == FP_SUBNORMAL);
  CHECK(check_rays(window, small) > 100);

  // Denormal doubles, as clip coordinates: the same lines and depths as 2^1070 times as large.
  std::array<Double4, 3> clip = {Double4(-0.75, -0.5, 0.25, 1), Double4(0.5, -0.75, 0.125, 1),
                                 Double4(0.25, 0.75, 0.5, 1)};
  const auto expected = set_up(clip, 32, 32);
  for (Double4& c : clip) c = c * 0x1p-1070;
  CHECK(std::fpclassify(clip[0].w) == FP_SUBNORMAL);
  const auto tiny = set_up(clip, 32, 32);
  REQUIRE((expected && tiny));
  for (int y = 128; y < 32 * 256; y += 256)
    for (int x = 128; x < 32 * 256; x += 256) {
      REQUIRE(tiny->covers(x, y) == expected->covers(x, y));
      if (tiny->covers(x, y)) REQUIRE(std::abs(tiny->depth(x, y) - expected->depth(x, y)) <= 0x1p-48);
    }
}

TEST_CASE("V5: with a corner on the eye plane, the part in view of the triangle that reaches infinity is drawn") {
  const WindowScene window(32, 0.25, 8);
  CHECK(check_rays(window, {window.place(4, 30, 2), window.place(28, 29, 1), Float3(0, 1, 0)}) > 100);
  CHECK(check_rays(window, {window.place(4, 2, 2), window.place(28, 29, 1), Float3(-1, 0.5f, 0)}) > 50);
  CHECK(check_rays(window, {window.place(4, 20, 4), Float3(1, 0.25f, 0), Float3(-0.5f, 1, 0)}) > 50); // two of them
  CHECK(check_rays(window, {window.place(4, 2, 2), window.place(28, 29, 1), Float3(0, 0, 0)}) == 0);  // seen edge-on
}

TEST_CASE("V6: corners close to the eye plane and behind it change nothing in front of it") {
  const WindowScene window(32, 0x1p-110, 8);
  const float w = 1e-30f;
  CHECK(check_rays(window, {window.place(4, 30, 2), window.place(28, 29, 1), Float3(w / 2, w, -w)}) > 50);
  CHECK(check_rays(window, {window.place(4, 30, 2), Float3(w, -w, -w), Float3(w / 2, w, -w)}) > 20);

  const WindowScene near_one(32, 1, 8);
  const std::array<Float3, 3> cut[] = {
      {near_one.place(4, 30, 4), near_one.place(28, 29, 2), Float3(0.5f, 0.5f, 3)}, // one behind
      {near_one.place(14, 8, 8), Float3(-0.5f, -1, 0.5f), Float3(2, -1.5f, 3)},     // two
      {near_one.place(4, 30, 4), near_one.place(28, 29, 2), Float3(1, 1, -w)},
  };
  for (const auto& corners : cut) {
    CHECK(check_rays(near_one, corners) > 20);
    WindowScene drawn = near_one;
    drawn.add({corners[0], corners[1], corners[2]});
    const Frame frame = drawn.frame({Aov::object, Aov::position});
    // Where the ray meets the plane, to half an ulp of the image's float, and the error of double beside that.
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        if (!is_drawn(frame, x, y)) continue;
        const auto hit =
            ray_hit(near_one.centre_ray(x, y), rational(corners[0]), rational(corners[1]), rational(corners[2]));
        REQUIRE(hit);
        for (std::size_t c = 0; c < 3; ++c) {
          const Mpfr expected = exact(hit->point[c]);
          const Mpfr error = abs(Mpfr(frame.aovs[1].at(x, y)[c]) - expected);
          REQUIRE(error <= half_float_ulp(expected) + interpolation_bound(Mpfr(8)));
        }
      }
  }
}

TEST_CASE("V7: a triangle behind the eye is not drawn, nor its mirror image") {
  for_all(200, [](Random& random) {
    WindowScene window(16);
    std::vector<Float3> corners;
    for (int k = 0; k < 3; ++k)
      corners.emplace_back(random.uniform(-9, 9), random.uniform(-9, 9), random.log_uniform(1e-6, 100));
    window.add(corners);
    const Frame frame = window.frame({Aov::object});
    CHECK(drawn_pixels(frame) == 0);
    CHECK(frame.counts.outside == 1);
  });
}

TEST_CASE("V8: corners, edges and whole triangles in a clip plane are drawn, and neighbours own each sample once") {
  const double near = 1, far = 3; // z = -2 z_view - 3: exactly -w and +w on the planes
  for (const double w : {near, far}) {
    CAPTURE(w);
    WindowScene window(32, near, far);
    const auto at = [&](double x, double y, double distance) { return window.place(x, y, distance); };
    // All of the view, in the plane. Then, in two halves whose common edge lies in the plane.
    window.add({at(-32, -32, w), at(96, -32, w), at(-32, 96, w)});
    CHECK(drawn_pixels(window.frame({Aov::object})) == 1024);
    WindowScene roof(32, near, far);
    roof.add({at(16, -32, w), at(-32, 16, 2), at(16, 64, w), at(16, -32, w), at(16, 64, w), at(64, 16, 2)});
    CHECK(drawn_pixels(roof.frame({Aov::object})) == 1024);
  }
  // The square of the view itself: corners on two or three planes, edges in the side planes; as one ring of fans.
  WindowScene view(32, near, far);
  const Float3 centre = view.place(16, 16, 2);
  const std::vector<Float3> rim = {view.place(0, 0, near), view.place(32, 0, far), view.place(32, 32, near),
                                   view.place(0, 32, far)};
  std::vector<std::array<Double4, 3>> fan;
  for (std::size_t i = 0; i < 4; ++i)
    fan.push_back({view.clip(centre), view.clip(rim[i]), view.clip(rim[(i + 1) % 4])});
  for (int y = 128; y < 32 * 256; y += 256)
    for (int x = 128; x < 32 * 256; x += 256) {
      int owners = 0;
      for (const auto& clip : fan) owners += set_up(clip, 32, 32)->covers(x, y);
      REQUIRE(owners == 1);
    }
  for (std::size_t i = 0; i < 4; ++i) view.add({centre, rim[i], rim[(i + 1) % 4]});
  CHECK(drawn_pixels(view.frame({Aov::object})) == 1024);
}

TEST_CASE("V9: the edge of two triangles is the same line, whichever way each runs it and whatever cuts it") {
  int edges = 0;
  for_all(2000, [&](Random& random) {
    const auto corner = [&] {
      const double w = random.sign() * random.log_uniform(1e-3, 1e3);
      return Double4(random.sign() * random.log_uniform(1e-3, 1e12), random.sign() * random.log_uniform(1e-3, 1e12),
                     random.uniform(-2, 2), w);
    };
    const Double4 p = corner(), q = corner(), left = corner(), right = corner();
    // One of each triangle's lines is the other's, up to a factor: those of integers that fit without a cut may differ
    // by a power of two.
    const auto lines_of = [](const std::array<Double4, 3>& clip) {
      std::vector<ProjectiveEdge> lines;
      std::array<WindowVertex, 3> v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = window_vertex(clip[k], 64, 64);
      if (const auto t = set_up_projective(v, clip, {64, 64, 0x1p-20}))
        for (std::size_t i = 0; i < static_cast<std::size_t>(t->pieces); ++i)
          lines.insert(lines.end(), t->piece[i].edge.begin(), t->piece[i].edge.end());
      return lines;
    };
    const auto same = [](const ProjectiveEdge& one, const ProjectiveEdge& other) {
      using Wide = boost::multiprecision::cpp_int;
      return Wide(one.a) * other.b == Wide(one.b) * other.a && Wide(one.a) * Wide(other.c) == Wide(one.c) * other.a &&
             Wide(one.b) * Wide(other.c) == Wide(one.c) * other.b;
    };
    const auto lines = lines_of({p, q, left}), others = lines_of({q, right, p});
    if (p.w <= 0 && q.w <= 0) return; // the edge is not seen
    REQUIRE(!lines.empty());
    REQUIRE(!others.empty());
    bool shared = false;
    for (const ProjectiveEdge& one : lines)
      for (const ProjectiveEdge& other : others) shared |= same(one, other);
    CHECK(shared);
    edges += 1;
  });
  CHECK(edges > 1000);
}

TEST_CASE(
    "V10: cutting makes no T-junctions: a mesh through the eye plane and both depth planes owns each sample once") {
  // The plane y = -1 from behind the eye to beyond the far plane, in squares of all sizes; one sample a ray.
  WindowScene window(64, 0.5, 32);
  const float cuts[] = {-1e6f, -40, -7.3f, -0.9f, 0, 0.4f, 3, 1e5f};
  std::vector<std::array<Double4, 3>> triangles;
  const auto corner = [&](std::size_t i, std::size_t j) { return window.clip({cuts[i], -1, cuts[j]}); };
  for (std::size_t i = 0; i + 1 < std::size(cuts); ++i)
    for (std::size_t j = 0; j + 1 < std::size(cuts); ++j) {
      triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  std::vector<AnyTriangle> set_ups;
  for (const auto& clip : triangles)
    if (const auto t = set_up(clip, 64, 64)) set_ups.push_back(*t);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      int owners = 0;
      for (const AnyTriangle& t : set_ups) owners += t.covers(x * 256 + 128, y * 256 + 128);
      // Rows 0 to 31 look above the horizon. The lowest ray below it meets the plane at 64 / 1, within the mesh.
      REQUIRE(owners == (y < 32 ? 0 : 1));
    }
}
