// refraster_shadow_cost [MAX_TRIANGLES [THREADS]]: how long it takes to build the tree of exact shadows, and to ask it.
// For 10^3 triangles and ten times as many each time: a hilly ground, of which points are asked for a lamp and a low
// sun; and as many loose triangles in a box, among which nothing is far from everything. A line each: triangles; ms to
// build with so many threads, and seconds of a processor a million triangles; of a processor ns a ray; how many rays
// are in shadow; triangles looked at, and left to integers, a ray. Each time the least of three: a processor's time
// needs no quiet machine.

#include "raster/shadow/triangle_tree.h"
#include "raster/stopwatch.h"
#include "tests/support/random.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace refraster {
namespace {

/// Hills over a square from -1 to 1.
WorldMesh hills(std::size_t triangles) {
  const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 2));
  WorldMesh mesh;
  mesh.position.resize_uninitialized((side + 1) * (side + 1));
  mesh.triangle.resize_uninitialized(2 * std::size_t{side} * side);
  for (std::uint32_t i = 0; i <= side; ++i)
    for (std::uint32_t j = 0; j <= side; ++j) {
      const double x = 2.0 * i / side - 1, z = 2.0 * j / side - 1;
      double y = 0;
      for (int octave = 1; octave <= 64; octave *= 2)
        y += 0.1 / octave * std::sin(7 * octave * x + octave) * std::cos(5 * octave * z - 2 * octave);
      mesh.position[i * (side + 1) + j] = {x, y, z};
    }
  std::size_t next = 0;
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t j = 0; j < side; ++j) {
      const std::uint32_t at = i * (side + 1) + j;
      mesh.triangle[next++] = {at, at + 1, at + side + 1};
      mesh.triangle[next++] = {at + 1, at + side + 2, at + side + 1};
    }
  return mesh;
}

/// As large as the distance between them, so that the box is as full for any number.
WorldMesh loose(std::size_t triangles) {
  Random random(1);
  WorldMesh mesh;
  mesh.position.resize_uninitialized(3 * triangles), mesh.triangle.resize_uninitialized(triangles);
  const double size = 1 / std::sqrt(static_cast<double>(triangles));
  const auto place = [&](double reach) {
    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach),
                 z = random.uniform(-reach, reach);
    return Double3(x, y, z);
  };
  for (std::size_t i = 0; i < triangles; ++i) {
    const Double3 centre = place(1);
    for (std::size_t k = 0; k < 3; ++k) {
      mesh.position[3 * i + k] = centre + place(size);
      mesh.triangle[i][k] = static_cast<std::uint32_t>(3 * i + k);
    }
  }
  return mesh;
}

struct Ray {
  SurfacePoint point;
  LightPlace light;
  std::uint32_t own;
};

/// Neighbours among them, as those of a frame's tiles are.
std::vector<Ray> rays_of(const WorldMesh& mesh, std::size_t count) {
  Random random(2);
  std::vector<Ray> rays;
  std::uint32_t own = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 64 == 0) own = static_cast<std::uint32_t>(random.below(static_cast<int>(mesh.triangle.size())));
    else own = std::min<std::uint32_t>(own + 1, static_cast<std::uint32_t>(mesh.triangle.size()) - 1);
    const double a = random.uniform(0.01, 1), b = random.uniform(0.01, 1), c = random.uniform(0.01, 1);
    const LightPlace light = i / 64 % 2 == 0 ? LightPlace{LightPlace::Kind::point, {0.3, 0.9, -0.4}}
                                             : LightPlace{LightPlace::Kind::direction, {1, 0.35, 0.4}};
    rays.push_back({{mesh.at(own), {a, b, c}}, light, own});
  }
  return rays;
}

void measure(const char* name, const WorldMesh& mesh, int threads) {
  TriangleTree tree;
  double build = 1e300, build_cpu = 1e300;
  for (int i = 0; i < 3; ++i) {
    const Stopwatch wall;
    tree.build(mesh, threads);
    build = std::min(build, wall.seconds());
    const Stopwatch cpu(TimeOf::thread);
    tree.build(mesh, 1);
    build_cpu = std::min(build_cpu, cpu.seconds());
  }
  const std::vector<Ray> rays = rays_of(mesh, 1 << 17);
  double ask = 1e300;
  std::size_t shadowed = 0;
  for (int i = 0; i < 3; ++i) {
    const Stopwatch stopwatch(TimeOf::thread);
    shadowed = 0;
    for (const Ray& ray : rays) shadowed += tree.any_crosses(mesh, ShadowRay(ray.point, ray.light), ray.own);
    ask = std::min(ask, stopwatch.seconds());
  }
  std::size_t looked_at = 0, uncertain = 0;
  for (const Ray& r : rays) {
    const ShadowRay ray(r.point, r.light);
    tree.visit(ray, [&](std::uint32_t number) {
      if (number == r.own) return false;
      ++looked_at;
      const std::optional<bool> certain = ray.crosses_certainly(mesh.at(number));
      uncertain += !certain;
      return certain.value_or(ray.crosses(mesh.at(number)));
    });
  }
  const auto count = static_cast<double>(mesh.triangle.size()), asked = static_cast<double>(rays.size());
  std::printf("| %s | %.0f | %.1f | %.2f | %.0f | %.0f %% | %.1f | %.6f |\n", name, count, build * 1e3,
              build_cpu * 1e6 / count, ask * 1e9 / asked, 100 * static_cast<double>(shadowed) / asked,
              static_cast<double>(looked_at) / asked, static_cast<double>(uncertain) / asked);
  std::fflush(stdout);
}

} // namespace
} // namespace refraster

int main(int count, char** words) {
  const double most = count > 1 ? std::atof(words[1]) : 1e7;
  const int threads = count > 2 ? std::atoi(words[2]) : 2;
  std::puts(
      "| scene | triangles | build, ms | CPU s a million | ns a ray | in shadow | looked at | left to integers |");
  std::puts("|---|---|---|---|---|---|---|---|");
  for (double triangles = 1e3; triangles <= most; triangles *= 10) {
    refraster::measure("hills", refraster::hills(static_cast<std::size_t>(triangles)), threads);
    refraster::measure("loose", refraster::loose(static_cast<std::size_t>(triangles)), threads);
  }
}
