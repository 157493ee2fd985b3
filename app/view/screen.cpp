#include "app/view/screen.h"

#include "app/options/wrap.h"
#include "app/view/draw/font.h"
#include "app/view/jobs.h"
#include "app/view/keys.h"

#include <cmath>
#include <limits>

namespace refraster {
namespace {

/// Characters in a line of a panel that is as wide as the window.
int columns_of_window(int width_pixels) {
  constexpr int both_borders = 2;
  return width_pixels / glyph_width - both_borders;
}

/// Each line of a text, in lines that fit into the window.
std::vector<std::string> fitted(const std::vector<std::string>& lines, int width_pixels) {
  constexpr int narrowest = 20;
  std::vector<std::string> all;
  for (const std::string& line : lines)
    for (std::string& part : wrapped(line, std::max(narrowest, columns_of_window(width_pixels))))
      all.push_back(std::move(part));
  return all;
}

} // namespace

void Screen::say(const std::string& text, double until_seconds) {
  message_ = text, message_end_ = until_seconds, changed = true;
}

void Screen::forget(double now_seconds) {
  if (message_.empty() || now_seconds < message_end_) return;
  message_.clear(), changed = true;
}

double Screen::next_change() const {
  return message_.empty() ? std::numeric_limits<double>::infinity() : message_end_;
}

void Screen::switch_help() {
  if (help_) help_.reset();
  else help_ = OpenPanel{{.lines = {}}}; // which depend on the window's width
  changed = true;
}

void Screen::show_story(std::vector<std::string> lines, int window_width) {
  const bool is_left = marked && marked->first < window_width / 2;
  story_ = OpenPanel{{.lines = std::move(lines), .corner = is_left ? Corner::top_right : Corner::top_left}};
  changed = true;
}

void Screen::show_fault(const std::string& consequence, const std::string& text) {
  Panel panel{.lines = lines_of(text), .corner = Corner::bottom_left, .kind = PanelKind::fault};
  panel.lines.insert(panel.lines.begin(), consequence);
  fault_ = OpenPanel{std::move(panel)};
  message_.clear(), changed = true;
}

void Screen::clear_fault() {
  changed = changed || fault_;
  fault_.reset();
}

bool Screen::close_last() {
  for (std::optional<OpenPanel>* const open : {&help_, &story_, &fault_}) {
    if (!*open) continue;
    if (open == &story_) marked.reset();
    open->reset();
    return changed = true;
  }
  return false;
}

bool Screen::close_at(int x, int y) {
  for (std::optional<OpenPanel>* const open : {&help_, &story_, &fault_}) {
    if (!*open || !(*open)->area.contains(x, y)) continue;
    if (open == &story_) marked.reset();
    open->reset();
    return changed = true;
  }
  return false;
}

bool Screen::scroll(int x, int y, double notches) {
  constexpr double lines_a_notch = 3;
  for (std::optional<OpenPanel>* const open : {&help_, &story_, &fault_}) {
    if (!*open || !(*open)->area.contains(x, y)) continue;
    (*open)->panel.first_line -= static_cast<int>(std::lround(notches * lines_a_notch));
    return changed = true;
  }
  return false;
}

void Screen::draw(const Canvas& canvas) {
  if (marked) draw_cross(canvas, marked->first, marked->second);
  if (help_) { // over a story, neither could be read
    help_->panel.lines = key_table(columns_of_window(canvas.width));
    help_->area = draw_panel(canvas, help_->panel);
    if (story_) story_->area = {};
  } else if (story_) {
    story_->area = draw_panel(canvas, story_->panel);
  }
  if (fault_) {
    Panel shown = fault_->panel;
    shown.lines = fitted(shown.lines, canvas.width);
    fault_->area = draw_panel(canvas, shown);
    fault_->panel.first_line = shown.first_line;
    return;
  }
  Panel below{.lines = {}, .corner = Corner::bottom_left};
  for (const std::string* const line : {&legend, &message_})
    if (!line->empty()) below.lines.push_back(*line);
  below.lines = fitted(below.lines, canvas.width);
  if (!below.lines.empty()) draw_panel(canvas, below);
}

} // namespace refraster
