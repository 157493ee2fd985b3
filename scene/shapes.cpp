#include <refraster/mesh.h>

#include "math/elementary/degrees.h"

#include <stdexcept>

namespace refraster {
namespace {

void require(bool holds, const char* fault) {
  if (!holds) throw std::invalid_argument(fault);
}

/// Longitude 2 pi u, counted from -Z toward -X: cosine along -Z and sine along -X, as in the header.
Double3 outward(SineCosine longitude) {
  return {-longitude.sine, 0, -longitude.cosine};
}

std::uint32_t add_vertex(Mesh& mesh, const Double3& position, const Double3& normal, double u, double v) {
  mesh.positions.emplace_back(position + Double3(0)); // + 0 turns -0 into 0
  mesh.normals.emplace_back(normal + Double3(0));
  mesh.uvs.emplace_back(static_cast<float>(u), static_cast<float>(v));
  return static_cast<std::uint32_t>(mesh.positions.size() - 1);
}

/// Corners in the order (0,0) (1,0) (1,1) (0,1) of (u, v), with u to the right and v up seen from outside.
void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

/// Room for so many in all and no more: growing piece by piece takes up to three times as much for a while.
void reserve(Mesh& mesh, std::size_t vertices, std::size_t triangles) {
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.uvs.reserve(vertices);
  mesh.triangles.reserve(triangles);
}

/// A sheet of columns x rows quads; add(column, row) adds the vertex at u = column / columns, v = row / rows.
/// `more` triangles with a vertex of their own each are to follow.
template <class Add>
void add_grid(Mesh& mesh, int columns, int rows, const Add& add, std::size_t more = 0) {
  const std::uint32_t first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto across = static_cast<std::size_t>(columns), up = static_cast<std::size_t>(rows);
  reserve(mesh, first + (across + 1) * (up + 1) + more, mesh.triangles.size() + 2 * across * up + more);
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) add(column, row);
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t corner = first + row * stride + column;
      add_quad(mesh, corner, corner + 1, corner + stride + 1, corner + stride);
    }
  }
}

double fraction(int part, int whole) {
  return static_cast<double>(part) / whole;
}

} // namespace

Mesh sphere_mesh(int segments, int rings) {
  require(segments >= 3 && rings >= 2, "sphere_mesh: expected segments >= 3, rings >= 2");
  Mesh mesh;
  const auto point = [&](double longitude_part, SineCosine longitude, int ring) {
    const SineCosine latitude = sine_cosine_of_turn(ring, 2 * rings); // half a turn from pole to pole
    const Double3 p = latitude.sine * outward(longitude) - Double3{0, latitude.cosine, 0};
    return add_vertex(mesh, p, p, longitude_part, fraction(ring, rings));
  };
  add_grid(
      mesh, segments, rings - 2,
      [&](int segment, int row) {
        point(fraction(segment, segments), sine_cosine_of_turn(segment, segments), row + 1);
      },
      2 * static_cast<std::size_t>(segments)); // the caps

  const auto stride = static_cast<std::uint32_t>(segments) + 1;
  const std::uint32_t southmost = 0, northmost = static_cast<std::uint32_t>(rings - 2) * stride;
  for (int segment = 0; segment < segments; ++segment) {
    const double middle = (segment + 0.5) / segments;
    const std::uint32_t west = static_cast<std::uint32_t>(segment);
    const std::uint32_t south_pole = point(middle, {1, 0}, 0), north_pole = point(middle, {1, 0}, rings);
    mesh.triangles.push_back({south_pole, southmost + west + 1, southmost + west});
    mesh.triangles.push_back({northmost + west, northmost + west + 1, north_pole});
  }
  return mesh;
}

Mesh cube_mesh() {
  struct Face {
    Double3 normal, right, up; // seen from outside; right x up = normal
  };
  constexpr Face faces[] = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                            {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
                            {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}};
  Mesh mesh;
  for (const Face& face : faces) {
    add_grid(mesh, 1, 1, [&](int u, int v) {
      const Double3 corner = face.normal + (2.0 * u - 1) * face.right + (2.0 * v - 1) * face.up;
      add_vertex(mesh, corner, face.normal, u, v);
    });
  }
  return mesh;
}

Mesh plane_mesh(int segments) {
  require(segments >= 1, "plane_mesh: expected segments >= 1");
  Mesh mesh;
  add_grid(mesh, segments, segments, [&](int column, int row) {
    const double u = fraction(column, segments), v = fraction(row, segments);
    add_vertex(mesh, {2 * u - 1, 0, 1 - 2 * v}, {0, 1, 0}, u, v);
  });
  return mesh;
}

Mesh torus_mesh(int segments, int rings, double tube_radius) {
  require(segments >= 3 && rings >= 3 && tube_radius > 0,
          "torus_mesh: expected segments >= 3, rings >= 3, tube_radius > 0");
  Mesh mesh;
  add_grid(mesh, segments, rings, [&](int segment, int ring) {
    const Double3 out = outward(sine_cosine_of_turn(segment, segments));
    const SineCosine around = sine_cosine_of_turn(ring, rings);
    const Double3 normal = -around.cosine * out - Double3{0, around.sine, 0};
    add_vertex(mesh, out + tube_radius * normal, normal, fraction(segment, segments), fraction(ring, rings));
  });
  return mesh;
}

Mesh knot_mesh(int segments, int rings, double tube_radius) {
  require(segments >= 3 && rings >= 3 && tube_radius > 0,
          "knot_mesh: expected segments >= 3, rings >= 3, tube_radius > 0");
  constexpr double strand = 0.4; // from the unit circle to the knot
  const Double3 axis(0, 1, 0);
  Mesh mesh;
  add_grid(mesh, segments, rings, [&](int segment, int ring) {
    const Double3 out = outward(sine_cosine_of_turn(2 * segment % segments, segments)), east = cross(axis, out);
    const SineCosine winding = sine_cosine_of_turn(3 * segment % segments, segments);
    // The knot lies on a torus, whose normal is perpendicular to the knot at every point: a frame without a twist.
    const Double3 normal = winding.cosine * out - winding.sine * axis;
    const Double3 onward =
        2 * (1 + strand * winding.cosine) * east - 3 * strand * (winding.sine * out + winding.cosine * axis);
    const Double3 sideways = normalize(cross(normal, onward));
    const SineCosine around = sine_cosine_of_turn(ring, rings);
    const Double3 tube = around.cosine * normal + around.sine * sideways;
    add_vertex(mesh, out + strand * normal + tube_radius * tube, tube, fraction(segment, segments),
               fraction(ring, rings));
  });
  return mesh;
}

} // namespace refraster
