#include "app/view/camera_control.h"

#include <algorithm>
#include <cstdlib>

namespace refraster {
namespace {

/// A button that is pressed and released within so many pixels is a click.
constexpr int click_pixels = 3;
/// A slow frame is no reason to jump through a wall.
constexpr double longest_step_seconds = 0.2;

} // namespace

void CameraControl::set(std::shared_ptr<const LoadedScene> loaded, Size size) {
  loaded_ = std::move(loaded), size_ = size;
}

template <class Change>
void CameraControl::move(const Change& change) {
  moved_ = change(moved_ ? *moved_ : movable(*loaded_, seen(*loaded_, {}, {}, size_).camera));
  follow(*loaded_, *moved_);
}

Push CameraControl::push() const {
  const auto along = [&](KeyAction plus, KeyAction minus) {
    return static_cast<double>(held_.contains(plus)) - static_cast<double>(held_.contains(minus));
  };
  return {along(KeyAction::forward, KeyAction::back), along(KeyAction::right, KeyAction::left),
          along(KeyAction::up, KeyAction::down)};
}

void CameraControl::hold(KeyAction action, double now_seconds) {
  if (held_.empty()) last_step_seconds_ = now_seconds;
  held_.insert(action);
}

void CameraControl::step(double now_seconds) {
  const double seconds = std::min(now_seconds - last_step_seconds_, longest_step_seconds);
  last_step_seconds_ = now_seconds;
  move([&](const Camera& camera) { return pushed(camera, motion, push(), seconds, rates_of(*loaded_, size_)); });
}

void CameraControl::press_button(int x, int y) {
  pressed_ = true, dragging_ = false, x_ = x, y_ = y;
}

bool CameraControl::release_button() {
  const bool click = pressed_ && !dragging_;
  pressed_ = false;
  return click;
}

bool CameraControl::move_mouse(int x, int y) {
  if (!pressed_) return false;
  const int right = x - x_, down = y - y_;
  if (!dragging_ && std::abs(right) <= click_pixels && std::abs(down) <= click_pixels) return false;
  dragging_ = true, x_ = x, y_ = y;
  move([&](const Camera& camera) { return dragged(camera, motion, right, down, rates_of(*loaded_, size_)); });
  return true;
}

void CameraControl::zoom(double notches) {
  move([&](const Camera& camera) { return zoomed(camera, notches); });
}

} // namespace refraster
