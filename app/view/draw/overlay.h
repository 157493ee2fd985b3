#pragma once
// What is written over the picture.

#include <cstdint>
#include <string>
#include <vector>

namespace refraster {

/// Pixels of a window, as 0x00RRGGBB, row 0 at the top.
struct Canvas {
  std::uint32_t* pixels = nullptr;
  int width = 0, height = 0;
  int stride = 0; // pixels from one row to the next
};

/// A rectangle of the window.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;
  bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

/// Where a text stands.
enum class Corner { top_left, top_right, bottom_left };

/// What it is: a fault has a red edge.
enum class PanelKind { plain, fault };

struct Panel {
  std::vector<std::string> lines; // UTF-8
  Corner corner = Corner::top_left;
  PanelKind kind = PanelKind::plain;
  int first_line = 0; // shown: the ones before are scrolled away
};

/// Lines of text on a dark ground through which the picture is seen, as large as they need and as the window has room
/// for: of lines that are too long or too many, the ends are cut off. first_line is brought into its range: no further
/// than that the last line is at the bottom. Gives what it covers.
Area draw_panel(const Canvas& canvas, Panel& panel);

/// A cross around a pixel, which stays as it is.
void draw_cross(const Canvas& canvas, int x, int y);

/// A line along the lower edge, as long as the fraction done says.
void draw_progress(const Canvas& canvas, double fraction);

} // namespace refraster
