// Where a camera with a fit stands, and lights that move with it.

#include "raster/vertex/scene_view.h"

#include "math/vec.h"
#include "raster/vertex/transform.h"
#include "tests/support/random.h"

#include <doctest/doctest.h>
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace refraster::test {
namespace {

std::shared_ptr<Mesh> mesh_of(const std::vector<Float3>& points) {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = points;
  mesh->normals.assign(points.size(), Float3(0, 0, 1));
  for (std::uint32_t i = 0; i < points.size(); ++i) mesh->triangles.push_back({i, i, i});
  return mesh;
}

/// A scene, and from where it is seen.
struct Viewed {
  Scene scene;
  SceneView view;

  Viewed(const std::vector<Float3>& points, const CameraFit& fit) {
    view.fit = fit;
    scene.objects.emplace_back().mesh = mesh_of(points);
  }
  Camera camera(int width, int height) const { return placed(width, height).camera; }
  Scene placed(int width, int height) const {
    Scene copy = scene;
    place(copy, view, width, height);
    return copy;
  }
};

/// What an image of the scene's vertices spans, 1 being its edges; and how far rounding may move that.
struct Seen {
  double left = 2, right = -2, bottom = 2, top = -2;
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  double extent = 0; // of the vertices, along the axes of the view
  double rounding = 0;
};

Seen seen_by(const Scene& scene, double aspect) {
  Seen seen;
  const Camera& camera = scene.camera;
  const Double4x4 view = view_from_world(camera), projection = clip_from_view(camera, aspect);
  double greatest = length(camera.position);
  Double3 least(std::numeric_limits<double>::infinity()), most = -least;
  for (const Object& object : scene.objects) {
    const Double4x4 world = object_transform(object, Double4x4(1)).world_from_object;
    for (const Float3& point : object.mesh->positions) {
      const Double4 p = world * Double4(Double3(point), 1);
      const Double4 clip = projection * (view * p);
      least = glm::min(least, Double3(view * p)), most = glm::max(most, Double3(view * p));
      seen.left = std::min(seen.left, clip.x / clip.w), seen.right = std::max(seen.right, clip.x / clip.w);
      seen.bottom = std::min(seen.bottom, clip.y / clip.w), seen.top = std::max(seen.top, clip.y / clip.w);
      seen.nearest = std::min(seen.nearest, clip.w), seen.farthest = std::max(seen.farthest, clip.w);
      greatest = std::max(greatest, length(Double3(p)));
    }
  }
  seen.extent = std::max({most.x - least.x, most.y - least.y, most.z - least.z});
  // Each coordinate along an axis of the view is made of sums of products of at most the greatest length, here and in
  // what is tested, the axes of which have an error too: no more than 64 roundings of that length in all. In the image
  // that is divided by the distance, and times the cotangent.
  const double cotangent = std::max(projection[0][0], projection[1][1]);
  seen.rounding = 64 * 0x1p-53 * (greatest / seen.nearest) * std::max(cotangent, 1.0);
  return seen;
}

/// Some points of any size, far from the origin or not.
std::vector<Float3> random_points(Random& random) {
  const double size = random.log_uniform(1e-30, 1e30), away = size * random.uniform(0, 100);
  const Double3 flat(random.below(4) > 0, random.below(4) > 0, random.below(4) > 0);
  std::vector<Float3> points;
  for (int i = 2 + random.below(40); i > 0; --i) {
    const Double3 p(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    points.emplace_back(p * flat * size + Double3(away, -away / 3, away / 7));
  }
  return points;
}

CameraFit random_fit(Random& random) {
  CameraFit fit;
  fit.azimuth_degrees = random.uniform(-400, 400), fit.elevation_degrees = random.uniform(-90, 90);
  if (random.below(4) == 0) fit.elevation_degrees = 90 * random.sign();
  fit.margin = random.below(3) == 0 ? 0 : random.uniform(0, 0.4);
  return fit;
}

} // namespace

TEST_CASE("a camera with a fit sees every vertex, as near as it may stand, and in the middle") {
  int touching = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    CAPTURE(seed);
    Random random(seed);
    const std::vector<Float3> points = random_points(random);
    const CameraFit fit = random_fit(random);
    Viewed viewed(points, fit);
    viewed.scene.camera.fov_y_degrees = random.uniform(5, 150);
    viewed.scene.camera.up = Double3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    Object& object = viewed.scene.objects.front();
    object.rotate_degrees = Double3(random.uniform(0, 360), random.uniform(0, 360), 0);
    object.scale = Double3(random.uniform(-3, 3), random.uniform(-3, 3), 1);
    const int width = 1 + random.below(2000), height = 1 + random.below(2000);
    const Scene scene = viewed.placed(width, height);
    CHECK(validate(scene).empty());

    const Seen seen = seen_by(scene, static_cast<double>(width) / height);
    const double most = 1 - 2 * fit.margin;
    CHECK(seen.right <= most + seen.rounding);
    CHECK(seen.top <= most + seen.rounding);
    CHECK(std::abs(seen.left + seen.right) <= 2 * seen.rounding);
    CHECK(std::abs(seen.bottom + seen.top) <= 2 * seen.rounding);
    CHECK(scene.camera.near < seen.nearest);
    CHECK(scene.camera.far > seen.farthest);
    // What comes near in a point is held off by it, at a tenth of the extent.
    const bool touches = std::max(seen.right, seen.top) >= most - seen.rounding;
    const double held_off = 0.1 * seen.extent * (1 + seen.rounding);
    CHECK_MESSAGE((touches || seen.nearest <= held_off || seen.extent == 0), seen.right, " ", seen.top, " ", most);
    touching += touches;
  }
  CHECK(touching > 1500);
}

TEST_CASE("a camera with a fit sees a square from its front as near as the sides of the image let it") {
  // tan(45 degrees) = 1: at a margin of 0 the square of half side 1 is seen from a distance of 1, above depth 0.
  CameraFit fit;
  fit.azimuth_degrees = fit.elevation_degrees = fit.margin = 0;
  Viewed square({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, fit);
  square.scene.camera.fov_y_degrees = 90;
  const Camera wide = square.camera(200, 100);
  CHECK(length(wide.position - Double3(0, 0, 1)) < 1e-15);
  CHECK(length(wide.target) < 1e-15);
  CHECK(wide.near == doctest::Approx(0.99));
  CHECK(wide.far == doctest::Approx(1.01));
  CHECK(square.camera(100, 200).position.z == doctest::Approx(2));
  Viewed free = square, right = square, above = square, z_up = square;
  free.view.fit->margin = 0.25;
  CHECK(free.camera(100, 100).position.z == doctest::Approx(2));
  right.view.fit->azimuth_degrees = 90; // along the square: 1 in front of it, and 1 above its nearest edge
  CHECK(right.camera(100, 100).position.x == doctest::Approx(2));
  above.view.fit->elevation_degrees = 90;
  CHECK(above.camera(100, 100).position.y == doctest::Approx(2));
  CHECK(dot(above.camera(100, 100).up, Double3(0, 0, -1)) == doctest::Approx(1));
  z_up.scene.camera.up = Double3(0, 0, 2); // whose front is -y
  CHECK(z_up.camera(100, 100).position.y == doctest::Approx(-2));
  CHECK(dot(z_up.camera(100, 100).up, Double3(0, 0, 1)) == doctest::Approx(1));
}

TEST_CASE("a target stays in the middle of the image, and a distance is what was asked for") {
  CameraFit fit;
  fit.target = Double3(5, 0, 0);
  const Viewed viewed({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, fit);
  const Scene scene = viewed.placed(640, 480);
  CHECK(length(scene.camera.target - Double3(5, 0, 0)) < 1e-14);
  CHECK(seen_by(scene, 640.0 / 480).left == doctest::Approx(-0.9));
  Viewed far = viewed, inside = viewed, planes = viewed;
  far.view.fit->distance = 100;
  CHECK(length(far.camera(640, 480).position - far.camera(640, 480).target) == doctest::Approx(100));
  CHECK(validate(far.placed(640, 480)).empty());
  inside.view.fit->target.reset(), inside.view.fit->distance = 0.01; // in the midst of the square
  CHECK(validate(inside.placed(640, 480)).empty());
  planes.view.fit->near = 1, planes.view.fit->far = 2;
  CHECK(planes.camera(640, 480).near == 1);
  CHECK(planes.camera(640, 480).far == 2);
}

TEST_CASE("models of no extent, of any size and of no vertices are seen from a camera that can be drawn with") {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const std::vector<std::vector<Float3>> models = {
      {},
      {{0, 0, 0}},
      {{1e30f, -1e30f, 3}},
      {{1e-30f, 0, 0}},
      {{1e-45f, 0, 0}, {0, 1e-45f, 0}},
      {{3e38f, 0, 0}, {-3e38f, 3e38f, 3e38f}},
      {{0, 0, -1}, {0, 0, 1}}, // along the view
      {{0, 0, 0}, {infinity, 0, 0}, {0, std::nanf(""), 0}, {1, 1, 1}},
  };
  for (std::size_t i = 0; i < models.size(); ++i) {
    CAPTURE(i);
    CameraFit fit;
    fit.azimuth_degrees = fit.elevation_degrees = 0;
    const Scene scene = Viewed(models[i], fit).placed(640, 480);
    for (const SceneFault& fault : validate(scene)) CHECK(fault.effect == SceneFault::Effect::drawn);
    CHECK(length(scene.camera.position - scene.camera.target) > 0);
    for (const Float3& point : models[i]) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      const Double4 clip = clip_from_world(scene.camera, 640.0 / 480) * Double4(Double3(point), 1);
      CHECK(std::abs(clip.x) < clip.w);
      CHECK(std::abs(clip.y) < clip.w);
      CHECK(std::abs(clip.z) < clip.w);
    }
  }
}

TEST_CASE("lights of camera space keep their place in the image, wherever the camera is; others stay") {
  Viewed viewed({{-1, -1, 0}, {1, 1, 1}}, {});
  viewed.scene.direction_lights = {{Double3(0, -1, 0), Double3(1)}, {Double3(1, 2, -3), Double3(1)}};
  viewed.view.moving_direction_lights = {1};
  PointLight lamp;
  lamp.position = Double3(0.5, -1, -2);
  viewed.scene.point_lights = {lamp};
  viewed.view.moving_point_lights = {0};
  for (const double azimuth : {-70.0, 10.0}) {
    viewed.view.fit->azimuth_degrees = azimuth;
    const Scene scene = viewed.placed(300, 200);
    const Double4x4 view = view_from_world(scene.camera);
    CHECK(scene.direction_lights[0].direction == Double3(0, -1, 0));
    CHECK(length(Double3(view * Double4(scene.direction_lights[1].direction, 0)) - Double3(1, 2, -3)) < 1e-14);
    CHECK(length(Double3(view * Double4(scene.point_lights[0].position, 1)) - lamp.position) < 1e-13);
  }
  // Also beside a camera that stands where it says.
  viewed.view.fit.reset();
  viewed.scene.camera.target = Double3(1, 0, 0);
  CHECK(length(viewed.placed(9, 9).point_lights[0].position - Double3(2, -1, 0.5)) < 1e-15);
}

} // namespace refraster::test
