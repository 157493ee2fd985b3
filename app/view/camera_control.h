#pragma once
// The camera of the window, as keys and the mouse have moved it.

#include <refraster/scene.h>

#include "app/arguments.h"
#include "app/view/keys.h"
#include "app/view/loaded_scene.h"

#include <memory>
#include <optional>
#include <set>

namespace refraster {

/// Moves from the scene's own camera, as soon as anything moves it.
class CameraControl {
public:
  Motion motion = Motion::walk;

  /// Another scene, or size of the window: where the scene's own camera stands, and how fast it is.
  void set(std::shared_ptr<const LoadedScene> loaded, Size size);
  /// None: it is the scene's own.
  const std::optional<Camera>& moved() const { return moved_; }
  /// Back to that.
  void go_home() { moved_.reset(); }

  /// A key that pushes, until it is let up.
  void hold(KeyAction action, double now_seconds);
  void release(KeyAction action) { held_.erase(action); }
  void release_all() { held_.clear(); }
  bool is_pushed() const { return push().any(); }
  /// Moves it by what is held, since the last time.
  void step(double now_seconds);

  void press_button(int x, int y);
  /// Whether this ends a click: the mouse has not moved since, but for a hand's tremor.
  bool release_button();
  /// Whether it has moved the camera.
  bool move_mouse(int x, int y);
  void zoom(double notches);

private:
  Push push() const;
  template <class Change>
  void move(const Change& change);

  std::shared_ptr<const LoadedScene> loaded_;
  Size size_;
  std::optional<Camera> moved_;
  std::set<KeyAction> held_;
  double last_step_seconds_ = 0;
  bool pressed_ = false, dragging_ = false;
  int x_ = 0, y_ = 0; // of the mouse when the button was pressed, or was last dragged
};

} // namespace refraster
