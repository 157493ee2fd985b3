#pragma once
// A window of the desktop. Its source is chosen by the build: with SDL2 (sdl_window.cpp), or without (no_window.cpp).

#include <refraster/image.h>

#include "app/arguments.h"
#include "app/view/draw/overlay.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace refraster {

/// There is no window to be had: this build has none, or this machine has no display. what() says which.
class NoWindow : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// What the user did.
struct WindowEvent {
  enum class Kind {
    close,       // the window's own button
    key_down,    // `key`; once, however long it is held
    key_up,      // `key`
    button_down, // the left one, at x, y
    button_up,   // likewise
    mouse,       // moved to x, y
    wheel,       // `notches` away from the user, at x, y
    resized,     // or uncovered: what it shows is to be shown again
    focus_lost   // keys that are held are let up without a word
  };
  Kind kind = Kind::close;
  std::string key = {}; // by SDL's name: app/view/keys.h
  int x = 0, y = 0;     // pixels from the top left
  double notches = 0;
};

class Window {
public:
  /// Connects to the display. Throws NoWindow.
  Window();
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Opens it, once: in this size, or in a smaller one of the same shape where the display has no room for it. Throws
  /// NoWindow.
  void open(const std::string& title, Size size);
  /// Takes it from the display, for good.
  void close();
  Size size() const;
  void set_title(const std::string& title);

  /// Shows a picture of 3 channels, in the window's size as it is, else stretched; and what is drawn over it.
  void show(const Image<std::uint8_t>& picture, const std::function<void(const Canvas&)>& draw_over);

  /// The next event; none if there is none within so many milliseconds.
  std::optional<WindowEvent> wait(int milliseconds);

private:
  struct Display;
  std::unique_ptr<Display> display_;
};

} // namespace refraster
