#pragma once
// The texts over the picture: help, a pixel's story, faults, messages.

#include "app/view/draw/overlay.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace refraster {

class Screen {
public:
  bool changed = true;                       // what is drawn is another than before
  std::optional<std::pair<int, int>> marked; // the pixel whose story is shown, while it is that of the picture
  std::string legend;                        // of the picture's colours

  /// A line that goes away by itself, at a time of any clock.
  void say(const std::string& text, double until_seconds);
  void forget(double now_seconds);
  /// When forget() will have something to do; infinity if never.
  double next_change() const;

  void switch_help();
  /// Of the pixel that is marked, and beside it.
  void show_story(std::vector<std::string> lines, int window_width);
  /// Text of a fault, line by line, below what it means for the picture.
  void show_fault(const std::string& consequence, const std::string& text);
  void clear_fault();

  /// Closes what was opened last; false if nothing is open.
  bool close_last();
  /// Closes what stands there; false if nothing does.
  bool close_at(int x, int y);
  /// Scrolls what stands there; false if nothing does.
  bool scroll(int x, int y, double notches);

  void draw(const Canvas& canvas);

private:
  struct OpenPanel {
    Panel panel;
    Area area = {};
  };
  std::optional<OpenPanel> help_, story_, fault_;
  std::string message_;
  double message_end_ = 0;
};

} // namespace refraster
