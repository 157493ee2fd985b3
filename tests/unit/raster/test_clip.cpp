// Clipping changes no value: what a triangle shows that reaches behind the eye, past a depth plane or beyond the guard
// band is what its plane shows.

#include "tests/support/for_all.h"
#include "tests/support/raster/triangles.h"
#include "tests/support/raster/window_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace refraster;
using namespace refraster::test;

namespace {

struct CutTriangle {
  std::string name;
  std::array<Float3, 3> corner;
  bool on_lattice = true; // every corner in front of the eye: snapping moves nothing
};

constexpr int side = 32;
constexpr double near_plane = 0.5, far_plane = 8;

WindowScene empty_window() {
  return WindowScene(side, near_plane, far_plane);
}

std::vector<CutTriangle> cut_triangles() {
  const WindowScene window = empty_window();
  return {
      {"in view", {window.place(3, 5, 1), window.place(20.5, 30, 4), window.place(29, 2.25, 2)}},
      {"beside the view", {window.place(-40, 5, 1), window.place(20.5, 80, 4), window.place(60, -70, 2)}},
      {"of a thousand pixels a side",
       {window.place(-600, -300, 1), window.place(500, -450, 4), window.place(10, 800, 2)}},
      {"one corner nearer than the near plane",
       {window.place(3, 5, 0.125), window.place(20.5, 30, 4), window.place(29, 2, 2)}},
      {"two corners nearer than the near plane",
       {window.place(3, 5, 0.125), window.place(20.5, 30, 0.25), window.place(29, 2, 2)}},
      {"one corner beyond the far plane", {window.place(3, 5, 1), window.place(20.5, 30, 64), window.place(29, 2, 2)}},
      {"between before the near and beyond the far plane",
       {window.place(-3, 40, 0.25), window.place(35, 30, 0.25), window.place(16, 2, 256)}},
      {"one corner behind the eye", {window.place(3, 5, 1), window.place(29, 2, 2), Float3(0.3f, -0.7f, 2)}},
      {"two corners behind the eye", {Float3(-1, -2, 3), Float3(0.5f, -1, 1), window.place(16, 4, 4)}},
      {"one corner on the eye plane", {window.place(3, 30, 1), window.place(29, 28, 2), Float3(0.25f, 1, 0)}},
      {"one corner beyond the guard band",
       {window.place(3, 30, 1), window.place(29, 28, 2), window.place(1 << 20, -(1 << 19), 2)}},
      {"all corners beyond the guard band",
       {window.place(-(1 << 20), 1 << 20, 4), window.place(1 << 21, 1 << 20, 1), window.place(3, -(1 << 22), 2)}},
      {"a wall from far behind the eye to far beyond the far plane",
       {Float3(-1, -1e6f, 1e6f), Float3(-1, 1e6f, 1e6f), Float3(-1, 3, -1e6f)},
       false},
      {"a ground whose corner in front is snapped onto the horizon",
       {Float3(-3e5f, -1, 1e5f), Float3(3e5f, -1, 1e5f), Float3(7, -1, -1e5f)},
       false},
      {"a ground whose two corners in front are snapped onto the horizon",
       {Float3(-1e6f, -1, -1e6f), Float3(1e6f, -1, -1.1e6f), Float3(10, -1, 1e6f)},
       false},
      {"a leaning wall beside the eye", {Float3(-2, -90, 70), Float3(-1, 80, 60), Float3(-3, 1, -100)}, false},
  };
}

std::vector<Float3> list(const std::array<Float3, 3>& c) {
  return {c[0], c[1], c[2]};
}

Mpfr largest_coordinate(const std::array<Float3, 3>& corners) {
  float most = 0;
  for (const Float3& p : corners)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(p[c]));
  return Mpfr(most);
}

// A line with an end off the lattice is cut to 61 bits: at samples, which lie below 2^22, its value is off by less than
// 2^23 of a slope that is at least 2^60 (or by less, where the constant is the large number). This is as if the line,
// or the sample, were moved by 2^-37 of a subpixel; three lines take part.
const Rational line_shift(3 * 0x1p-45); // pixels

// What the triangle's plane shows at a pixel: at its centre, and as far around it as snapping may move the triangle. It
// moves a corner by half a subpixel at most, and what lies between corners by no more.
struct Plane {
  const WindowScene& window;
  std::array<RationalVec3, 3> corner;
  Rational shift;

  Plane(const WindowScene& scene, const std::array<Float3, 3>& corners, bool on_lattice)
      : window(scene), corner{rational(corners[0]), rational(corners[1]), rational(corners[2])},
        shift(on_lattice ? line_shift : Rational(line_shift + Rational(1, 512))) {}

  std::optional<RayHit> at(int x, int y, int shift_x, int shift_y) const {
    const Rational px(2 * x + 1, 2), py(2 * y + 1, 2);
    return ray_hit(window.ray(px + shift_x * shift, py + shift_y * shift), corner[0], corner[1], corner[2]);
  }
  /// Whether the triangle is met, if that is so or not for all of these places; and how near and far.
  struct Meeting {
    bool sure = true, inside = false;
    Rational w_min, w_max;
  };
  Meeting meeting(int x, int y) const {
    Meeting result;
    std::size_t inside = 0;
    for (const auto& [sx, sy] : places) {
      const auto hit = at(x, y, sx, sy);
      inside += hit && hit->how == Meets::inside;
      if (!hit) continue;
      const Rational w = -hit->point[2];
      result.w_min = result.w_min == 0 ? w : std::min(w, result.w_min);
      result.w_max = std::max(w, result.w_max);
      result.sure = result.sure && hit->how != Meets::border;
    }
    result.inside = inside == std::size(places);
    result.sure = result.sure && (result.inside || inside == 0);
    return result;
  }
  /// How far `value` of what is seen may move.
  template <class Value>
  Mpfr moved(int x, int y, const Value& value) const {
    const Mpfr middle = value(*at(x, y, 0, 0));
    Mpfr most = 0;
    for (const auto& [sx, sy] : places)
      if (const auto hit = at(x, y, sx, sy)) most = std::max(most, Mpfr(abs(value(*hit) - middle)));
    return most;
  }

private:
  static constexpr std::pair<int, int> places[] = {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
};

} // namespace

TEST_CASE("a cut triangle covers the pixels whose rays meet it between the depth planes, at the points they meet") {
  Mpfr worst = 0;
  for (const CutTriangle& triangle : cut_triangles()) {
    CAPTURE(triangle.name);
    WindowScene window = empty_window();
    window.add(list(triangle.corner));
    const Plane plane(window, triangle.corner, triangle.on_lattice);
    const Mpfr most = largest_coordinate(triangle.corner);
    const Frame frame = window.frame({Aov::object, Aov::position});
    CHECK(frame.counts.drawn == 1);
    int shown = 0, wrong = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const Plane::Meeting meeting = plane.meeting(x, y);
        const bool kept = meeting.inside && meeting.w_min >= near_plane && meeting.w_max <= far_plane;
        const bool cut = !meeting.inside || meeting.w_max < near_plane || meeting.w_min > far_plane;
        if (!meeting.sure || kept == cut) continue;
        wrong += is_drawn(frame, x, y) != kept;
        if (!kept || !is_drawn(frame, x, y)) continue;
        ++shown;
        for (std::size_t c = 0; c < 3; ++c) {
          const auto coordinate = [c](const RayHit& hit) { return exact(hit.point[c]); };
          const Mpfr exactly = coordinate(*plane.at(x, y, 0, 0));
          const Mpfr bound = half_float_ulp(exactly) + interpolation_bound(most) + plane.moved(x, y, coordinate);
          const Mpfr error = abs(Mpfr(frame.aovs[1].at(x, y)[c]) - exactly);
          worst = std::max(worst, Mpfr(error / bound));
          REQUIRE(error <= bound);
        }
      }
    CHECK(wrong == 0);
    CHECK(shown > 20);
  }
  MESSAGE("largest error of a position: " << worst.convert_to<double>() << " of its bound");
}

TEST_CASE("the depth of a cut triangle is that of its plane") {
  double worst = 0;
  for (const CutTriangle& triangle : cut_triangles()) {
    CAPTURE(triangle.name);
    WindowScene window = empty_window();
    window.add(list(triangle.corner));
    const Plane plane(window, triangle.corner, triangle.on_lattice);
    const Frame frame = window.frame({Aov::object, Aov::depth});
    std::array<Double4, 3> clip;
    for (std::size_t k = 0; k < 3; ++k) clip[k] = window.clip(triangle.corner[k]);
    const auto triangle_set_up = set_up(clip, side, side, near_plane);
    REQUIRE(triangle_set_up);
    // z / w = a - b / w at distance w. In units of 2^-53, the corners' z is good to 8 of a |w| + b, and what is
    // interpolated to 32 of the largest depth at a vertex: those of a piece lie beyond half the near plane.
    const Mpfr near(near_plane), far(far_plane), a = (far + near) / (far - near), b = 2 * far * near / (far - near);
    const auto depth_of = [&](const RayHit& hit) -> Mpfr { return a + b / exact(hit.point[2]); };
    Mpfr largest_depth = a + 2 * b / near;
    for (const Double4& c : clip)
      if (c.w > 0) largest_depth = std::max(largest_depth, Mpfr(a + b / Mpfr(c.w)));
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        if (!is_drawn(frame, x, y) || !plane.meeting(x, y).sure) continue;
        const RayHit hit = *plane.at(x, y, 0, 0);
        const Mpfr distance = -exact(hit.point[2]);
        const Mpfr corners = 8 * Mpfr(0x1p-53) * (a * largest_coordinate(triangle.corner) + b) / distance;
        const Mpfr bound = interpolation_bound(largest_depth) + corners + plane.moved(x, y, depth_of);
        const double depth = triangle_set_up->depth(x * 256 + 128, y * 256 + 128);
        const Mpfr error = abs(Mpfr(depth) - depth_of(hit));
        REQUIRE(error <= bound);
        worst = std::max(worst, Mpfr(error / bound).convert_to<double>());
        CHECK(*frame.aovs[1].at(x, y) == static_cast<float>(depth * 0.5 + 0.5));
      }
  }
  MESSAGE("largest error of a depth: " << worst << " of its bound");
}

TEST_CASE("a cut triangle and an uncut one of the same plane show the same points, depths and coordinates") {
  // The plane y = -1. At window row y it is seen at w = 16 / (y - 16): exact for the corners below.
  WindowScene window(side, 0.5, 64);
  const auto on_plane = [&](double x, double y) { return window.place(x, y, 16 / (y - 16)); };
  const std::array<Float3, 3> whole{on_plane(2, 32), on_plane(30, 32), on_plane(16, 18)};
  const std::array<Float3, 3> cut[] = {
      {Float3(-64, -1, 64), Float3(64, -1, 64), Float3(0, -1, -1000)},     // through the eye plane and the far plane
      {Float3(-1e5f, -1, -2), Float3(1e5f, -1, -1), Float3(0, -1, -1e5f)}, // beyond the guard band
      {Float3(-3, -1, 0), Float3(3, -1, 0), Float3(0, -1, -64)},           // from the eye plane
      {Float3(-2, -1, -0.125f), Float3(2, -1, -0.25f), Float3(0, -1, -64)} // through the near plane
  };
  const auto with_uv = [&](const std::array<Float3, 3>& corners) {
    WindowScene one = window;
    std::vector<Float2> uvs;
    for (const Float3& p : corners) uvs.emplace_back(p.x, p.z);
    one.add(list(corners), Double3(1), uvs);
    return one.frame({Aov::object, Aov::depth, Aov::position, Aov::uv});
  };
  const Frame uncut_frame = with_uv(whole);
  CHECK(uncut_frame.counts.clipped == 0);
  for (const auto& corners : cut) {
    CAPTURE(corners[0].x);
    const Frame cut_frame = with_uv(corners);
    CHECK(cut_frame.counts.clipped == 1);
    const Mpfr most = largest_coordinate(corners);
    const Plane plane(window, corners, false);
    int compared = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        if (!is_drawn(uncut_frame, x, y) || !is_drawn(cut_frame, x, y)) continue;
        ++compared;
        const auto compare = [&](std::size_t aov, int channel, const Mpfr& double_error) {
          const Mpfr a(uncut_frame.aovs[aov].at(x, y)[channel]), b(cut_frame.aovs[aov].at(x, y)[channel]);
          REQUIRE(abs(a - b) <= 2 * half_float_ulp(a) + double_error);
        };
        // Both are within their bounds of the plane's exact value. Depth: z / w is a + b / w with |a| + |b| < 3, and w
        // is at least 1 here.
        const Mpfr bound = interpolation_bound(most) + interpolation_bound(Mpfr(64));
        const auto seen = [&](std::size_t c) -> Mpfr {
          return bound + plane.moved(x, y, [c](const RayHit& hit) { return exact(hit.point[c]); });
        };
        for (int c = 0; c < 3; ++c) compare(2, c, seen(static_cast<std::size_t>(c)));
        compare(3, 0, seen(0));
        compare(3, 1, seen(2));
        compare(1, 0, 3 * seen(2));
      }
    CHECK(compared > 50);
  }
}

TEST_CASE("the depth planes cut where they stand, for triangles of any place") {
  // In units of 2^-53: the planes' own coefficients are good to 4 and z to 8 of |z| + |w| <= 4 far; the depth to 32
  // more. A change of z / w by e moves the cut by e w^2 (far - near) / (2 near far) < e w far.
  long tested = 0, near_cut = 0, far_cut = 0, too_close = 0, wrong = 0;
  for_all(20, [&](Random& random) {
    const double near = random.log_uniform(1e-3, 1), far = near * random.log_uniform(2, 1e4);
    WindowScene window(side, near, far);
    std::array<Float3, 3> corners;
    for (Float3& p : corners)
      p = {static_cast<float>(random.uniform(-far, far)), static_cast<float>(random.uniform(-far, far)),
           static_cast<float>(random.uniform(-1.5 * far, 0.5 * far))};
    window.add(list(corners));
    const Frame frame = window.frame({Aov::object});
    const Plane plane(window, corners, false);
    const Rational n(near), f(far);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        const Plane::Meeting meeting = plane.meeting(x, y);
        if (!meeting.sure) continue;
        const Rational slack = meeting.w_max * f / n * Rational(64 * 0x1p-53);
        const bool surely_kept = meeting.inside && meeting.w_min - slack > n && meeting.w_max + slack < f;
        const bool surely_cut = !meeting.inside || meeting.w_max + slack < n || meeting.w_min - slack > f;
        if (!surely_kept && !surely_cut) {
          ++too_close;
          continue;
        }
        ++tested;
        near_cut += meeting.inside && meeting.w_max < n, far_cut += meeting.inside && meeting.w_min > f;
        wrong += is_drawn(frame, x, y) != surely_kept;
      }
  });
  MESSAGE("pixels: " << tested << ", cut off by the near plane: " << near_cut << ", by the far plane: " << far_cut
                     << ", within the bound of a plane: " << too_close << ", wrong: " << wrong);
  CHECK(wrong == 0);
  CHECK(near_cut > 50);
  CHECK(far_cut > 10);
  CHECK(too_close < tested / 100);
}
