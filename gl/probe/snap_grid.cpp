#include "gl/probe/snap_grid.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace refraster {
namespace {

constexpr int side = 1024, edges = side / 2;

enum class Axis { x, y };

/// How far along the axis each of the edges seems to be, in units; edge i was moved by i of them. Each has two columns
/// of pixels to itself, and covers the first of them up to the row where it crosses the centres of that column.
std::vector<int> seen_moves(ProbeCanvas& canvas, GLuint white, int viewport, double unit, Axis axis) {
  // Multiples of `unit` below the viewport's size, over half of it: exact in float, as is the window's place of them.
  const auto corner = [&](double along, double across) {
    const auto clip = [&](double place) { return static_cast<float>(place * 2 / viewport - 1); };
    const float a = clip(along), b = clip(across);
    return ProbeVertex{axis == Axis::x ? std::array<float, 4>{a, b, 0, 1} : std::array<float, 4>{b, a, 0, 1}};
  };
  std::vector<ProbeVertex> vertices;
  for (int i = 0; i < edges; ++i) {
    const double centre = 2 * i + 0.5, reach = edges * unit, moved = i * unit;
    const ProbeVertex low = corner(centre - reach + moved, 0), high = corner(centre + reach + moved, side),
                      beyond_low = corner(centre + 0.75, 0), beyond_high = corner(centre + 0.75, side);
    vertices.insert(vertices.end(), {low, beyond_low, beyond_high, low, beyond_high, high});
  }
  canvas.clear(0);
  canvas.draw(white, vertices);
  const std::vector<float> values = canvas.read_floats();
  std::vector<int> moves;
  for (std::size_t i = 0; i < edges; ++i) {
    int covered = 0;
    for (std::size_t row = 0; row < side; ++row) {
      const std::size_t pixel = axis == Axis::x ? row * side + 2 * i : 2 * i * side + row;
      covered += values[4 * pixel] > 0;
    }
    moves.push_back(edges - covered);
  }
  return moves;
}

/// What the staircase says.
void look_at(const std::vector<int>& moves, SnapGrid& grid) {
  const std::set<int> stairs(moves.begin(), moves.end());
  std::vector<int> steps;
  for (auto next = stairs.begin(), last = next++; next != stairs.end(); last = next++) steps.push_back(*next - *last);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  const int step = steps.empty() ? edges : steps[steps.size() / 2];
  if (step > 1) grid.step = std::max(grid.step, step * grid.resolution);
  for (std::size_t i = 0; i < moves.size(); ++i)
    grid.moved = std::max(grid.moved, std::abs(moves[i] - static_cast<int>(i)) * grid.resolution);
}

} // namespace

std::vector<SnapGrid> probe_snap_grid(ProbeCanvas& canvas) {
  canvas.set_target(GL_RGBA32F, side, side);
  const GLuint white = canvas.program("    result = vec4(1.0);\n");
  std::vector<SnapGrid> grids;
  // GCN's lattice depends on the viewport, and is 1/4096 pixel in the smallest: si_state_viewport.c of Mesa 23.3.
  for (const int viewport : {1024, 4096, 8192}) {
    canvas.gl().Viewport(0, 0, viewport, viewport);
    const auto look = [&](double resolution) {
      SnapGrid grid{viewport, 0, 0, resolution};
      for (const Axis axis : {Axis::x, Axis::y}) look_at(seen_moves(canvas, white, viewport, resolution, axis), grid);
      return grid;
    };
    // With 24 bits of a place; that look reaches no farther than 2^9 of its steps, and misses a coarser lattice.
    constexpr double coarse = 0x1p-11;
    const double fine = viewport * 0x1p-24;
    SnapGrid grid = look(coarse);
    if (fine < coarse && grid.step <= 0x1p-7) grid = look(fine);
    grids.push_back(grid);
  }
  check_probe(canvas, "the lattice of corners");
  return grids;
}

} // namespace refraster
