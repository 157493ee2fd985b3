// How keys and the mouse move the camera.

#include "app/view/camera_control.h"
#include "app/view/camera_motion.h"
#include "math/vec.h"
#include "tests/support/random.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace refraster;

namespace {

/// At the origin, looking along -z.
Camera ahead() {
  return {.position = {0, 0, 0}, .target = {0, 0, -4}, .up = {0, 1, 0}};
}

/// Vectors here are worked out by hand, up to the rounding of sines and a few products of numbers of about 10.
void check_near(const Double3& found, const Double3& expected) {
  INFO(found.x << " " << found.y << " " << found.z);
  CHECK(length(found - expected) <= 64 * 0x1p-52 * 10);
}

double degrees_to_up(const Camera& camera) {
  const Double3 view = normalize(camera.target - camera.position);
  return std::acos(dot(view, normalize(camera.up))) * 180 / std::numbers::pi;
}

} // namespace

TEST_CASE("who walks goes along the view, across it and along up, as fast as the scene says") {
  const MotionRates rates{.speed = 3};
  const Camera forward = pushed(ahead(), Motion::walk, {.forward = 1}, 0.5, rates);
  check_near(forward.position, {0, 0, -1.5});
  check_near(forward.target, {0, 0, -5.5});
  check_near(pushed(ahead(), Motion::walk, {.right = 1}, 2, rates).position, {6, 0, 0});
  check_near(pushed(ahead(), Motion::walk, {.up = -1}, 1, rates).position, {0, -3, 0});
}

TEST_CASE("the mouse turns the head to the right and down, and the eye stays") {
  const MotionRates rates{.look_degrees = 0.5};
  const Camera right = dragged(ahead(), Motion::walk, 180, 0, rates); // a right angle
  check_near(right.position, {0, 0, 0});
  check_near(right.target, {4, 0, 0});
  const Camera down = dragged(ahead(), Motion::walk, 0, 60, rates); // 30 degrees
  check_near(down.target, {0, -2, -4 * std::cos(std::numbers::pi / 6)});
}

TEST_CASE("around a target the thing follows the mouse, and the distance stays") {
  const MotionRates rates{.turn_degrees = 1};
  const Camera camera{.position = {0, 0, 4}, .target = {0, 0, 0}, .up = {0, 1, 0}};
  check_near(dragged(camera, Motion::orbit, 90, 0, rates).position, {-4, 0, 0}); // its front goes to the right
  check_near(dragged(camera, Motion::orbit, 0, 30, rates).position, {0, 2, 4 * std::cos(std::numbers::pi / 6)});
  check_near(pushed(camera, Motion::orbit, {.forward = 1}, 2, rates).position, {0, 0, 2}); // halved in two seconds
}

TEST_CASE("no drag takes the view nearer to up than a degree, nor turns it over") {
  Random random(3);
  for (const Motion motion : {Motion::walk, Motion::orbit}) {
    Camera camera{.position = {1, 2, 5}, .target = {0, 0.5, 0}, .up = {0.2, 3, 0.1}};
    const double distance = length(camera.position - camera.target);
    for (int i = 0; i < 2000; ++i) {
      const double pixels = random.below(2) == 0 ? 3000 : 40;
      camera = dragged(camera, motion, (random.below(2001) / 1000.0 - 1) * pixels,
                       (random.below(2001) / 1000.0 - 1) * pixels, {});
      const double degrees = degrees_to_up(camera);
      CHECK(degrees >= 1 - 1e-6); // acos near 1 has half of the digits
      CHECK(degrees <= 179 + 1e-6);
      // A rotation's rounding, a few ulps, adds up over all of them.
      CHECK(std::abs(length(camera.position - camera.target) / distance - 1) <= 2000 * 16 * 0x1p-52);
    }
  }
}

TEST_CASE("the field of view narrows with the wheel, and comes back") {
  Camera camera = ahead();
  camera.fov_y_degrees = 40;
  CHECK(zoomed(camera, 1).fov_y_degrees == doctest::Approx(38));
  CHECK(zoomed(zoomed(camera, 3), -3).fov_y_degrees == doctest::Approx(40));
  CHECK(zoomed(camera, 1000).fov_y_degrees == 1);
  CHECK(zoomed(camera, -1000).fov_y_degrees == 170);
  camera.fov_y_degrees = 0.5;
  CHECK(zoomed(camera, 1).fov_y_degrees == 0.5); // a scene may be beyond, and is not pulled back
}

TEST_CASE("the planes hold the ball, from wherever it is seen") {
  Random random(5);
  const Ball ball{{1, 2, 3}, 2};
  for (int i = 0; i < 1000; ++i) {
    const auto coordinate = [&] { return random.below(2001) / 100.0 - 10; };
    Camera camera{.position = {coordinate(), coordinate(), coordinate()},
                  .target = {coordinate(), coordinate(), coordinate() + 0.001}};
    place_planes(camera, ball);
    CHECK(camera.near > 0);
    CHECK(camera.far > camera.near);
    const double depth = dot(ball.centre - camera.position, normalize(camera.target - camera.position));
    CHECK(camera.far >= depth + ball.radius);
    CHECK((camera.near <= std::max(depth - ball.radius, 0.0) || camera.near == camera.far * 0x1p-10));
  }
}

TEST_CASE("a press and a release is a click, with a tremor of the hand as well, but a drag is none") {
  CameraControl control;
  auto loaded = std::make_shared<LoadedScene>();
  loaded->source.scene.camera = ahead();
  control.set(loaded, {640, 480});
  control.press_button(100, 100);
  CHECK_FALSE(control.move_mouse(102, 99));
  CHECK(control.release_button());
  CHECK_FALSE(control.moved());
  control.press_button(100, 100);
  CHECK(control.move_mouse(104, 100));
  CHECK_FALSE(control.release_button());
  CHECK(control.moved());
  CHECK_FALSE(control.move_mouse(300, 100)); // no button
  control.go_home();
  CHECK_FALSE(control.moved());
}

TEST_CASE("keys push for as long as they are held, however often one looks") {
  const auto loaded = std::make_shared<LoadedScene>();
  loaded->source.scene.camera = ahead();
  loaded->source.view.handling.movement_speed = 2;
  const auto after = [&](int steps) {
    CameraControl control;
    control.set(loaded, {640, 480});
    control.hold(KeyAction::forward, 10);
    for (int i = 1; i <= steps; ++i) control.step(10 + 0.125 * i / steps);
    control.release(KeyAction::forward);
    CHECK_FALSE(control.is_pushed());
    return control.moved()->position;
  };
  check_near(after(1), {0, 0, -0.25});
  check_near(after(8), {0, 0, -0.25});
}
