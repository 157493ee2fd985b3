#include "gl/probe/planes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace refraster {
namespace {

constexpr int side = 1024;
constexpr double u = 0x1p-24;

struct Corner {
  double x, y, z;      // in the window, from the lower left; z from 0 to 1
  double inverse_w, f; // of the clip position, and a varying
};
using Triangle = std::array<Corner, 3>;

/// A plane through three values over the window.
class Plane {
public:
  template <class Value>
  Plane(const Triangle& corners, const Value& value) : corners_(corners) {
    for (std::size_t i = 0; i < 3; ++i) p_[i] = value(corners[i]);
    const auto [a, b, c] = corners;
    twice_area_ = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    along_x_ = ((p_[1] - p_[0]) * (c.y - a.y) - (p_[2] - p_[0]) * (b.y - a.y)) / twice_area_;
    along_y_ = ((p_[2] - p_[0]) * (b.x - a.x) - (p_[1] - p_[0]) * (c.x - a.x)) / twice_area_;
  }

  double at(double x, double y) const {
    return p_[0] + along_x_ * (x - corners_[0].x) + along_y_ * (y - corners_[0].y);
  }

  /// What the value is summed from at most, whichever corner is the first: starting at the origin, with slopes of
  /// differences of values; or at a corner, with slopes of the values themselves.
  double from_origin(double x, double y) const {
    return greatest([&](const Corner& a, const Corner& b, const Corner& c, std::size_t i) {
      const double ab = std::abs(p_[(i + 1) % 3] - p_[i]), ac = std::abs(p_[(i + 2) % 3] - p_[i]);
      return (ab * std::abs(c.y - a.y) + ac * std::abs(b.y - a.y)) * std::abs(x) +
             (ac * std::abs(b.x - a.x) + ab * std::abs(c.x - a.x)) * std::abs(y);
    });
  }
  double from_corner(double x, double y) const {
    double in_x = 0, in_y = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Corner &b = corners_[(i + 1) % 3], &c = corners_[(i + 2) % 3];
      in_x += std::abs(p_[i] * (b.y - c.y)), in_y += std::abs(p_[i] * (c.x - b.x));
    }
    return greatest([&](const Corner& a, const Corner&, const Corner&, std::size_t) {
      return in_x * std::abs(x - a.x) + in_y * std::abs(y - a.y);
    });
  }

private:
  template <class Sum>
  double greatest(const Sum& sum) const {
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
      most = std::max(most, sum(corners_[i], corners_[(i + 1) % 3], corners_[(i + 2) % 3], i));
    return most / std::abs(twice_area_) + std::max({std::abs(p_[0]), std::abs(p_[1]), std::abs(p_[2])});
  }

  Triangle corners_;
  std::array<double, 3> p_{};
  double twice_area_, along_x_, along_y_;
};

/// One triangle a square cell of the target, `columns` x `columns` of them from (x, y) on; corners may lie so many
/// pixels outside.
struct Cells {
  int x, y, size, columns, outside;
};

std::vector<Triangle> random_triangles(const Cells& cells, std::mt19937& random) {
  std::vector<Triangle> triangles;
  const auto up_to = [&](unsigned n) { return static_cast<int>(random() % n); };
  for (int i = 0; i < cells.columns * cells.columns; ++i) {
    const int left = cells.x + i % cells.columns * cells.size, low = cells.y + i / cells.columns * cells.size;
    Triangle triangle{};
    double area = 0;
    while (area < 1e-4 * cells.size * cells.size) { // some are needles
      for (Corner& corner : triangle) {
        // Exact in float through clip space and viewport: multiples of 2^-14 pixel inside the window, times a power of
        // two, and of 2^-13 within three times its size.
        const int bits = cells.outside == 0 ? 14 : 13;
        const auto inside = [&] {
          const auto steps = static_cast<unsigned>(cells.size + 2 * cells.outside) << bits;
          return std::ldexp(up_to(steps), -bits) - cells.outside;
        };
        corner = {left + inside(), low + inside(), up_to(1U << 20) * 0x1p-20, std::ldexp(1.0, up_to(7) - 3),
                  (up_to(1U << 21) - (1 << 20)) * 0x1p-20};
      }
      const auto [a, b, c] = triangle;
      area = std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2;
    }
    triangles.push_back(triangle);
  }
  return triangles;
}

ProbeVertex vertex(const Corner& corner) {
  const auto w = static_cast<float>(1 / corner.inverse_w);
  const auto clip = [&](double place) { return static_cast<float>(place * 2 - 1) * w; };
  return {{clip(corner.x / side), clip(corner.y / side), clip(corner.z), w},
          {static_cast<float>(corner.f), 1.0f / 3, 0, 0}};
}

Triangle snapped(Triangle triangle, double lattice) {
  if (lattice > 0)
    for (Corner& corner : triangle)
      corner.x = std::nearbyint(corner.x / lattice) * lattice, corner.y = std::nearbyint(corner.y / lattice) * lattice;
  return triangle;
}

/// What one pixel shows.
struct Seen {
  double f, constant, inverse_w, z, depth;
};

/// Of the planes through these corners.
struct Planes {
  explicit Planes(const Triangle& t)
      : f_by_w(t, [](const Corner& c) { return c.f * c.inverse_w; }),
        inverse_w(t, [](const Corner& c) { return c.inverse_w; }), z(t, [](const Corner& c) { return c.z; }) {}

  void compare(double x, double y, const Seen& seen, double& varyings_from_corner, double& varyings_from_origin,
               double& depth_from_corner, double& depth_from_origin) const {
    const double q = inverse_w.at(x, y), f = f_by_w.at(x, y) / q, depth = z.at(x, y);
    const double wrong_f = std::abs(seen.f - f) * q / u, wrong_q = std::abs(seen.inverse_w - q) / u;
    const double wrong_z = std::max(std::abs(seen.z - depth), std::abs(seen.depth - depth)) / u;
    const auto note = [&](double& varyings, double& depths, double of_f, double of_q, double of_z) {
      varyings = std::max({varyings, wrong_f / (of_f + std::abs(f) * of_q), wrong_q / of_q});
      depths = std::max(depths, wrong_z / of_z);
    };
    note(varyings_from_corner, depth_from_corner, f_by_w.from_corner(x, y), inverse_w.from_corner(x, y),
         z.from_corner(x, y));
    note(varyings_from_origin, depth_from_origin, f_by_w.from_origin(x, y), inverse_w.from_origin(x, y),
         z.from_origin(x, y));
  }

  Plane f_by_w, inverse_w, z;
};

void look_at(ProbeCanvas& canvas, GLuint program, const Cells& cells, double lattice, std::mt19937& random,
             PlaneFacts& facts) {
  const std::vector<Triangle> triangles = random_triangles(cells, random);
  std::vector<ProbeVertex> vertices;
  for (const Triangle& triangle : triangles)
    for (const Corner& corner : triangle) vertices.push_back(vertex(corner));
  canvas.clear(-1);
  canvas.draw(program, vertices);
  const std::vector<float> values = canvas.read_floats(), depths = canvas.read_depth();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Planes exact(triangles[i]), on_lattice(snapped(triangles[i], lattice));
    const int left = cells.x + static_cast<int>(i) % cells.columns * cells.size,
              low = cells.y + static_cast<int>(i) / cells.columns * cells.size;
    for (int y = low; y < low + cells.size; ++y)
      for (int x = left; x < left + cells.size; ++x) {
        const auto pixel = static_cast<std::size_t>(y * side + x);
        const float* const at = &values[4 * pixel];
        if (at[3] < 0) continue;
        const auto value = [&](std::size_t k) { return static_cast<double>(at[k]); };
        const Seen seen{value(0), value(1), value(2), value(3), static_cast<double>(depths[pixel])};
        const auto compare = [&](const Planes& planes, double PlaneErrors::*corner, double PlaneErrors::*origin) {
          planes.compare(x + 0.5, y + 0.5, seen, facts.varyings.*corner, facts.varyings.*origin, facts.depth.*corner,
                         facts.depth.*origin);
        };
        compare(exact, &PlaneErrors::exact_from_corner, &PlaneErrors::exact_from_origin);
        compare(on_lattice, &PlaneErrors::snapped_from_corner, &PlaneErrors::snapped_from_origin);
        constexpr auto third = static_cast<double>(1.0f / 3);
        facts.constant = std::max(facts.constant, std::abs(seen.constant / third - 1) / u);
        facts.samples += 1;
      }
  }
}

} // namespace

PlaneFacts probe_planes(ProbeCanvas& canvas, double lattice) {
  canvas.set_target(GL_RGBA32F, side, side);
  canvas.gl().Enable(GL_DEPTH_TEST);
  canvas.gl().DepthFunc(GL_ALWAYS);
  const GLuint program = canvas.program("    result = vec4(v.xy, gl_FragCoord.w, gl_FragCoord.z);\n");
  std::mt19937 random(1);
  PlaneFacts facts;
  for (const int place : {0, 448, 896}) look_at(canvas, program, {place, place, 8, 16, 0}, lattice, random, facts);
  look_at(canvas, program, {0, 0, 32, 32, 0}, lattice, random, facts);
  for (int i = 0; i < 4; ++i) look_at(canvas, program, {0, 0, 341, 3, 0}, lattice, random, facts);
  for (int i = 0; i < 8; ++i) look_at(canvas, program, {0, 0, side, 1, side}, lattice, random, facts); // cut, or not
  canvas.gl().Disable(GL_DEPTH_TEST);
  check_probe(canvas, "varyings and depth");
  return facts;
}

} // namespace refraster
