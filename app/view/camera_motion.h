#pragma once
// How keys and the mouse move the camera.

#include <refraster/scene.h>

namespace refraster {

/// Walking, as in the lecture's framework: keys go along the view, the mouse turns the head. Or around what the camera
/// looks at, which stays where it is.
enum class Motion { walk, orbit };

/// A ball in world space that holds every vertex.
struct Ball {
  Double3 centre{0};
  double radius = 0; // world units
};

/// Of all vertices of a scene that are finite: about the middle of their box.
Ball ball_around(const Scene& scene);

/// How fast.
struct MotionRates {
  double speed = 1;                   // world units a second: "movement_speed" of a scene's camera
  double look_degrees = 0.1;          // a pixel of the mouse: "mouse_sensitivity"
  double turn_degrees = 360.0 / 1280; // a pixel of the mouse, around the target: the window's width is a whole turn
};

/// Which way keys that are held push, each from -1 to 1.
struct Push {
  double forward = 0, right = 0, up = 0;
  bool any() const { return forward != 0 || right != 0 || up != 0; }
};

// What a moved camera is. Its up vector stays; the line of sight comes no nearer to it than a degree. Of a walk,
// position and target move together; of an orbit, the target stays.

/// Whether the line of sight is no nearer to the up vector than that.
bool can_be_moved(const Camera& camera);

/// Pushed for so long. Around a target, the distance halves, or the camera goes once around, in two seconds.
Camera pushed(Camera camera, Motion motion, const Push& push, double seconds, const MotionRates& rates);

/// Dragged by so many pixels, to the right and down. Who walks turns the head to there; around a target, the thing
/// follows the mouse.
Camera dragged(Camera camera, Motion motion, double right_pixels, double down_pixels, const MotionRates& rates);

/// The wheel was turned by so many notches away from the user: the field of view narrows by a twentieth with each,
/// within 1 to 170 degrees.
Camera zoomed(Camera camera, double notches);

/// Puts the depth planes before and behind the ball.
void place_planes(Camera& camera, const Ball& ball);

bool same_camera(const Camera& a, const Camera& b);

} // namespace refraster
