// The vertex stage in lanes: what each lane holds is what the vertex alone would get.

#include "math/precisions.h"
#include "raster/vertex/transform.h"
#include "raster/vertex/vertex_stage.h"
#include "tests/support/random.h"
#include "tests/support/raster/window_vertex.h"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// The places at which something is decided: clip planes, the eye plane, the guard band, the ends of double.
double special(Random& random) {
  constexpr double values[] = {0,          -0.0,    1,        -1,    2,        0.5,       0x1p-1022, 0x1p-1030,
                               -0x1p-1074, 0x1p300, -0x1p600, 1e308, infinity, -infinity, nan,       0x1p17,
                               -0x1p16,    65536,   131071,   3,     -7,       0x1p-40};
  return values[random.below(std::size(values))];
}

double coordinate(Random& random) {
  switch (random.below(4)) {
  case 0:
    return special(random);
  case 1:
    return random.uniform(-2, 2);
  case 2:
    return random.uniform(-2e5, 2e5);
  default:
    return random.below(64) / 8.0 - 2;
  }
}

// In words of its own, by the rules of docs/conventions.md.
WindowVertex expected(const Double4& clip, int width, int height) {
  WindowVertex v;
  for (int c = 0; c < 4; ++c)
    if (!std::isfinite(clip[c])) {
      v.outcode = outcode::not_finite;
      return v;
    }
  const double w = clip.w;
  for (int axis = 0; axis < 3; ++axis) {
    if (clip[axis] < -w) v.outcode |= static_cast<std::uint8_t>(1 << 2 * axis);
    if (clip[axis] > w) v.outcode |= static_cast<std::uint8_t>(2 << 2 * axis);
  }
  const double x = clip.x / w * (128.0 * width) + 128.0 * width, y = 128.0 * height - clip.y / w * (128.0 * height);
  if (!std::isnormal(w) || w < 0 || !(std::fabs(x) <= 16777216) || !(std::fabs(y) <= 16777216)) {
    v.outcode |= outcode::unsnapped;
    return v;
  }
  v.x = static_cast<std::int32_t>(std::nearbyint(x)), v.y = static_cast<std::int32_t>(std::nearbyint(y));
  v.z = clip.z / w, v.inverse_w = 1 / w;
  return v;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const WindowVertex& a, const WindowVertex& b) {
  return a.x == b.x && a.y == b.y && same_bits(a.z, b.z) && same_bits(a.inverse_w, b.inverse_w) &&
         a.outcode == b.outcode;
}

template <class T>
long lanes_unlike_scalars(Random& random, int trials) {
  constexpr int lanes = NumberTraits<T>::lanes;
  long wrong = 0;
  for (int trial = 0; trial < trials; ++trial) {
    std::array<Double4, lanes> clip;
    Vec4<T> together;
    for (int lane = 0; lane < lanes; ++lane)
      for (int c = 0; c < 4; ++c) {
        const double value = coordinate(random);
        clip[static_cast<std::size_t>(lane)][c] = value;
        together[c].set(lane, value);
      }
    const WindowLanes<T> got = window_lanes(together, 1920, 1080);
    for (int lane = 0; lane < lanes; ++lane) {
      const WindowVertex alone = window_vertex(clip[static_cast<std::size_t>(lane)], 1920, 1080);
      const int code = static_cast<int>(got.sides[lane] + 64 * got.not_finite[lane] + 128 * got.unsnapped[lane]);
      const WindowVertex in_lane{static_cast<std::int32_t>(got.x[lane]), static_cast<std::int32_t>(got.y[lane]),
                                 got.z[lane], got.inverse_w[lane], static_cast<std::uint8_t>(code)};
      wrong += !same(in_lane, alone) || !same(alone, expected(clip[static_cast<std::size_t>(lane)], 1920, 1080));
    }
  }
  return wrong;
}

} // namespace

TEST_CASE("a vertex has the same window place in a lane as alone, wherever it lies") {
  Random random(11);
  CHECK(lanes_unlike_scalars<Wide<double, 2>>(random, 20'000) == 0);
  CHECK(lanes_unlike_scalars<Wide<double, 4>>(random, 20'000) == 0);
  CHECK(lanes_unlike_scalars<Wide<double, 8>>(random, 20'000) == 0);
}

TEST_CASE("a vertex as it is kept for set-up is the vertex") {
  Random random(12);
  for (int trial = 0; trial < 10'000; ++trial) {
    const auto place = [&] { return static_cast<std::int32_t>(random.below(2 * guard_band + 1)) - guard_band; };
    WindowVertex v{place(), place(), random.uniform(-1, 1), random.uniform(0, 1),
                   static_cast<std::uint8_t>(random.below(256))};
    if (trial == 0) v.x = guard_band, v.y = -guard_band;
    if (trial == 1) v.x = -guard_band, v.y = guard_band;
    WindowVertices stored;
    store({&v, 1}, stored);
    REQUIRE(same(stored[0], v));
  }
}

TEST_CASE("every vertex of a frame is transformed, whatever the sizes of its meshes") {
  Random random(13);
  Scene scene;
  for (int o = 0; o < 60; ++o) {
    Object object;
    object.rotate_degrees = {random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180)};
    object.scale = {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)};
    auto mesh = std::make_shared<Mesh>();
    const auto vertices = o == 30 ? 5000 : random.below(20);
    const auto float3 = [&] {
      const auto c = [&] { return static_cast<float>(random.below(5) == 0 ? special(random) : random.uniform(-9, 9)); };
      const float x = c(), y = c(), z = c();
      return Float3(x, y, z);
    };
    for (int v = 0; v < vertices; ++v) {
      mesh->positions.push_back(float3());
      mesh->normals.push_back(float3());
    }
    object.mesh = mesh;
    scene.objects.push_back(object);
  }
  const Double4x4 camera = clip_from_world(scene.camera, 640.0 / 360);
  Geometry geometry;
  for (const int threads : {1, 2, 5}) {
    RenderOptions options;
    options.width = 640, options.height = 360, options.threads = threads;
    transform({scene, options}, geometry);
    long wrong = 0;
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
      const Mesh& mesh = *scene.objects[o].mesh;
      const ObjectTransform matrices = object_transform(scene.objects[o], camera);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const std::size_t i = geometry.first_vertex[o] + v;
        const Float3 &p = mesh.positions[v], &n = mesh.normals[v];
        wrong += !same(geometry.window[i], window_vertex(clip_position(matrices, p), 640, 360));
        const WorldVertex world{Double3(matrices.world_from_object * Double4(p.x, p.y, p.z, 1)),
                                matrices.world_from_normal * Double3(n.x, n.y, n.z)};
        for (int c = 0; c < 3; ++c) { // a NaN is a NaN
          const auto alike = [](double a, double b) { return same_bits(a, b) || (a != a && b != b); };
          const double kept = min(max(world.position[c], -0x1p1022), 0x1p1022);
          wrong += !same_bits(geometry.world[i].position[c], kept);
          wrong += !alike(geometry.world[i].normal[c], world.normal[c]);
        }
      }
    }
    CHECK(wrong == 0);
  }
}
