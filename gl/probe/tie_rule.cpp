#include "gl/probe/tie_rule.h"

#include <array>
#include <utility>
#include <vector>

namespace refraster {
namespace {

constexpr int side = 16, hub = 8, reach = 6;
constexpr std::array<std::pair<int, int>, 9> rim = {
    {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}}};

using Point = std::pair<int, int>; // a pixel, whose centre it stands for
enum class Winding { counter_clockwise, clockwise };

/// Counter-clockwise.
std::array<Point, 3> triangle(std::size_t i) {
  const auto on_rim = [](const std::pair<int, int>& way) {
    return Point(hub + reach * way.first, hub + reach * way.second);
  };
  return {Point(hub, hub), on_rim(rim[i]), on_rim(rim[i + 1])};
}

/// Whether a sample on the edge that runs this way, the triangle being on its left, belongs to it.
bool holds_edge(TieRule rule, int x, int y) {
  const bool left = y<0, right = y> 0, top = x < 0;
  switch (rule) {
  case TieRule::top_left:
    return left || (!right && top);
  case TieRule::top_right:
    return right || (!left && top);
  case TieRule::bottom_left:
    return left || (!right && !top);
  case TieRule::bottom_right:
    return right || (!left && !top);
  case TieRule::other:
    break;
  }
  return false;
}

bool covers(const std::array<Point, 3>& corners, const Point& at, TieRule rule) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point a = corners[k], b = corners[(k + 1) % 3];
    const int x = b.first - a.first, y = b.second - a.second;
    const int inside = x * (at.second - a.second) - y * (at.first - a.first);
    if (inside < 0 || (inside == 0 && !holds_edge(rule, x, y))) return false;
  }
  return true;
}

/// What a rule shows of the eight triangles, or a device: bit i of a pixel is triangle i.
using Shown = std::vector<unsigned>;

Shown shown_by(TieRule rule) {
  Shown shown(side * side);
  for (std::size_t i = 0; i < 8; ++i)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        if (covers(triangle(i), Point(x, y), rule)) shown[static_cast<std::size_t>(y * side + x)] |= 1U << i;
  return shown;
}

Shown shown_by(ProbeCanvas& canvas, GLuint white, Winding winding) {
  Shown shown(side * side);
  for (std::size_t i = 0; i < 8; ++i) {
    std::vector<ProbeVertex> vertices;
    for (const Point& corner : triangle(i)) {
      const auto clip = [](int place) { return (static_cast<float>(place) + 0.5f) * 2 / side - 1; };
      vertices.push_back({{clip(corner.first), clip(corner.second), 0, 1}});
    }
    if (winding == Winding::clockwise) std::swap(vertices[1], vertices[2]);
    canvas.clear(0);
    canvas.draw(white, vertices);
    const std::vector<float> values = canvas.read_floats();
    for (std::size_t p = 0; p < shown.size(); ++p)
      if (values[4 * p] > 0) shown[p] |= 1U << i;
  }
  return shown;
}

} // namespace

TieFacts probe_tie_rule(ProbeCanvas& canvas) {
  canvas.set_target(GL_RGBA32F, side, side);
  const GLuint white = canvas.program("    result = vec4(1.0);\n");
  const Shown turned[] = {shown_by(canvas, white, Winding::counter_clockwise),
                          shown_by(canvas, white, Winding::clockwise)};
  check_probe(canvas, "samples on edges");
  TieFacts facts;
  for (const auto& [rule, name] : EnumNames<TieRule>::names)
    if (turned[0] == shown_by(rule) && turned[1] == turned[0]) facts.rule = rule;
  facts.shared_edges_drawn_once = true;
  for (const Shown& shown : turned)
    for (int y = hub - reach + 1; y < hub + reach; ++y)
      for (int x = hub - reach + 1; x < hub + reach; ++x) {
        const unsigned by = shown[static_cast<std::size_t>(y * side + x)];
        facts.shared_edges_drawn_once &= by != 0 && (by & (by - 1)) == 0;
      }
  return facts;
}

} // namespace refraster
