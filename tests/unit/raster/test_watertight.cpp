#include <refraster/mesh.h>

#include "tests/support/raster/oracle.h"
#include "tests/support/raster/triangles.h"

#include <doctest/doctest.h>

#include <random>

using namespace refraster;
using namespace refraster::test;

namespace {

constexpr int width = 960, height = 540;

// How often triangles cover each sample of an image: seen from the front counted up, from behind counted down.
struct SignedCoverage {
  std::vector<int> front, back;
  SignedCoverage() : front(width * height, 0), back(width * height, 0) {}

  void add(const AnyTriangle& triangle, SamplePosition sample) {
    triangle.for_each_part([&](const auto& lines, Facing facing) {
      auto& count = facing == Facing::front ? front : back;
      constexpr int tile = 12; // divides both sides
      for (int ty = 0; ty < height; ty += tile)
        for (int tx = 0; tx < width; tx += tile) {
          const auto place = [&](int pixel, int offset) { return pixel * subpixels + offset; };
          bool misses = false;
          for (const auto& line : lines)
            misses |= line.max_over(place(tx, sample.x), place(ty, sample.y), place(tx + tile - 1, sample.x),
                                    place(ty + tile - 1, sample.y)) < 0;
          if (misses) continue;
          for (int y = ty; y < ty + tile; ++y)
            for (int x = tx; x < tx + tile; ++x) {
              const std::int32_t sx = place(x, sample.x), sy = place(y, sample.y);
              if (lines[0].covers(sx, sy) && lines[1].covers(sx, sy) && lines[2].covers(sx, sy))
                ++count[static_cast<std::size_t>(y * width + x)];
            }
        }
    });
  }
};

struct View {
  std::string name;
  Double3 centre; // of the closed surface, seen from the origin along -z
  Double3 scale;
  Double3 turn{13, 37, 59}; // degrees
};

// Each crosses another plane of the view volume; the first two hold the eye inside.
const View outside_views[] = {
    {"in view", {0, 0, -4}, {1, 1.3, 0.8}},
    {"left and right", {0, 0, -4}, {9, 0.7, 0.8}},
    {"top and bottom", {0, 0, -4}, {0.8, 9, 0.7}},
    {"left only", {-3.3, 0.1, -4}, {1, 1, 1}},
    {"right only", {3.3, 0.1, -4}, {1, 1, 1}},
    {"top only", {0.2, 1.7, -4}, {1, 1, 1}},
    {"bottom only", {0.2, -1.7, -4}, {1, 1, 1}},
    {"near", {0.1, 0.05, -1.05}, {1, 1, 1}},
    {"far", {0, 0, -100}, {20, 20, 30}},
    {"beside the eye", {1.2, 0, 0}, {1.1, 1, 5}, {0, 0, 7}},
    {"behind the eye plane", {0.3, -1.3, 2}, {3, 1.1, 9}, {0, 0, 0}},
    {"behind the eye", {0, 0, 5}, {1, 1, 1}},
};
const View inside_views[] = {
    {"eye at the centre", {0, 0, 0}, {10, 10, 10}},
    {"eye near the wall", {0.9, 0.2, -0.3}, {1.1, 1.4, 1}},
    {"eye in a long tube", {0.01, 0.02, 50}, {0.05, 0.06, 90}, {0, 0, 20}},
    {"eye in a huge hall", {1e6, 3e6, 2e6}, {1e9, 2e9, 1e9}},
};

// Checks that front minus back is `sum` at every sample, and returns how many samples saw the surface.
long check_closed(const View& view, int samples, int sum) {
  CAPTURE(view.name);
  Camera camera;
  const Double4x4 clip = clip_from_world(camera, static_cast<double>(width) / height);
  Object object;
  object.mesh = std::make_shared<Mesh>(sphere_mesh(24, 12));
  object.position = view.centre;
  object.scale = view.scale;
  object.rotate_degrees = view.turn;
  const ObjectTransform matrices = object_transform(object, clip);
  long seen = 0, wrong = 0;
  for (const SamplePosition& sample : sample_pattern(samples)) {
    SignedCoverage coverage;
    for (const auto& t : object.mesh->triangles) {
      std::array<Double4, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = clip_position(matrices, object.mesh->positions[t[k]]);
      if (const auto triangle = set_up(corners, width, height)) coverage.add(*triangle, sample);
    }
    for (std::size_t i = 0; i < coverage.front.size(); ++i) {
      seen += coverage.front[i] + coverage.back[i] > 0;
      wrong += coverage.front[i] - coverage.back[i] != sum;
    }
  }
  CHECK(wrong == 0);
  return seen;
}

} // namespace

TEST_CASE("a closed surface has as many fronts as backs at every sample, whatever plane cuts it") {
  long seen = 0;
  for (const View& view : outside_views) seen += check_closed(view, 1, 0);
  MESSAGE("views: " << std::size(outside_views) << ", samples on the surface: " << seen);
}

TEST_CASE("from inside a closed surface every sample sees it exactly once") {
  long seen = 0;
  for (const View& view : inside_views) {
    const long here = check_closed(view, 1, -1);
    CHECK(here == width * height);
    seen += here;
  }
  MESSAGE("samples, each covered once: " << seen);
}

TEST_CASE("the triangles of a fan own each sample once, also one at the hub") {
  std::mt19937_64 random(7);
  for (int spokes = 3; spokes <= 12; ++spokes)
    for (int trial = 0; trial < 50; ++trial) {
      const LatticePoint hub = trial % 2 ? LatticePoint{2048 + 128, 2048 + 128}
                                         : LatticePoint{2000 + static_cast<std::int64_t>(random() % 200), 2000};
      std::vector<LatticePoint> rim;
      for (int i = 0; i < spokes;
           ++i) { // around the square with half side 1500..2000, in order: star-shaped about the hub
        const double turn = 6.283185307179586 * (i + static_cast<double>(random() % 1000) / 2000) / spokes;
        const double radius = 1200 + static_cast<double>(random() % 800);
        LatticePoint p{hub.x + static_cast<std::int64_t>(radius * std::cos(turn)),
                       hub.y + static_cast<std::int64_t>(radius * std::sin(turn))};
        if (random() % 3 == 0) p = {(p.x & ~255) + 128, (p.y & ~255) + 128};
        rim.push_back(p);
      }
      for (int y = 128; y < 16 * 256; y += 256)
        for (int x = 128; x < 16 * 256; x += 256) {
          int owners = 0;
          bool inside = false;
          for (std::size_t i = 0; i < rim.size(); ++i) {
            const std::array<LatticePoint, 3> c{hub, rim[i], rim[(i + 1) % rim.size()]};
            const auto vertex = [](LatticePoint p) {
              return lattice_vertex(static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y));
            };
            if (const auto t = set_up_on_lattice({vertex(c[0]), vertex(c[1]), vertex(c[2])})) owners += t->covers(x, y);
            inside ^= oracle_covers<Int128, 14>(c, {x, y}); // a polygon's parity is the sum of its triangles'
          }
          REQUIRE(owners == (inside ? 1 : 0));
        }
    }
}

TEST_CASE("a plane through the eye's side is covered on one side of its horizon and nowhere else") {
  // The ground y = -1 as two triangles that reach far behind the eye: rays that go down hit it, rays that go up do not.
  const Double4x4 clip = clip_from_world(Camera{}, 1);
  const double r = 1e7;
  const Double4 corner[4] = {clip * Double4(-r, -1, -r, 1), clip * Double4(r, -1, -r, 1), clip * Double4(r, -1, r, 1),
                             clip * Double4(-r, -1, r, 1)};
  const auto first = set_up({corner[0], corner[1], corner[2]}, 512, 512),
             second = set_up({corner[0], corner[2], corner[3]}, 512, 512);
  REQUIRE((first && second));
  int wrong = 0;
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x) {
      const int hits = first->covers(x * 256 + 128, y * 256 + 128) + second->covers(x * 256 + 128, y * 256 + 128);
      wrong += hits != (y >= 256 ? 1 : 0); // the horizon is 1e-7 of a unit below the middle row
    }
  CHECK(wrong == 0);
}

TEST_SUITE("slow") {
  TEST_CASE("closed surfaces are watertight at every sample of 2, 4, 8 and 16") {
    long seen = 0;
    for (const int samples : {2, 4, 8, 16}) {
      for (const View& view : outside_views) seen += check_closed(view, samples, 0);
      for (const View& view : inside_views) seen += check_closed(view, samples, -1);
    }
    MESSAGE("samples on the surface: " << seen);
    CHECK(seen > 5'000'000);
  }
}
