// The vertex stage against the tests' own, which works in long double and shares no line with it.

#include "bench/precision/measure.h"

#include "raster/vertex/transform.h"
#include "tests/support/scenes/listed_scenes.h"
#include "tests/support/scenes/random_scene.h"
#include "tests/support/slow/slow_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

namespace refraster::precision {

namespace {

using slow::Real;
using slow::real;
using slow::Vec;

constexpr std::string_view stored_values[] = {"world position",       "world normal", "window x, y",
                                              "window x, y, snapped", "z / w",        "1 / w"};
constexpr Real unit_roundoff = 0x1p-53L;

Real largest(Vec a) {
  return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
}

/// Whether cofactors of the scales, and their products with the normals of a mesh, are normal numbers of double.
/// Beyond, digits of normals get lost.
bool keeps_normals(const Double3& scale) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (scale[axis] == 0) continue;
    least = std::min(least, std::abs(scale[axis])), most = std::max(most, std::abs(scale[axis]));
  }
  return least >= std::numeric_limits<double>::min() && most * 0x1p-800 <= least;
}

/// What window coordinates are made from, apart from the vertex.
struct CameraScale {
  double half_width, half_height; // of the image, subpixels
  Real eye, x, y, z, z_offset;    // a length; factors of the distance of a vertex; an offset

  CameraScale(const Camera& camera, int width, int height)
      : half_width(subpixels / 2.0 * width), half_height(subpixels / 2.0 * height) {
    const Vec sight = slow::unit(slow::vec(camera.position) - slow::vec(camera.target));
    // The axis to the right is a cross product: as much less certain as up is closer to the line of sight.
    const Real slant = 1 / slow::length(slow::cross(slow::unit(slow::vec(camera.up)), sight));
    const Double4x4 projection = clip_from_view(camera, half_width / half_height);
    eye = slow::length(slow::vec(camera.position));
    x = real(projection[0][0]) * slant, y = real(projection[1][1]) * slant;
    z = std::abs(real(projection[2][2])), z_offset = std::abs(real(projection[3][2]));
  }
};

class VertexErrors {
public:
  void add_scene(const std::string& name, const Scene& scene, int width, int height) {
    RenderOptions options;
    options.width = width, options.height = height, options.threads = 1;
    Geometry geometry;
    transform({scene, options}, geometry);
    const slow::Viewer viewer(scene.camera, width, height);
    const CameraScale scale(scene.camera, width, height);
    for (std::size_t index = 0; index < scene.objects.size(); ++index) {
      const Object& object = scene.objects[index];
      const std::vector<slow::Corner> exact = slow::corners_of(object, viewer);
      for (std::size_t i = 0; i < exact.size(); ++i) {
        const std::size_t number = geometry.first_vertex[index] + i;
        const auto describe = [&] {
          return name + ", object " + std::to_string(index) + ", vertex " + std::to_string(i);
        };
        const Float3& p = object.mesh->positions[i];
        const Vec scaled = slow::vec(object.scale) * slow::vec(p);
        add_world(geometry.world[number], exact[i], slow::vec(object.position), slow::length(scaled), object.scale,
                  describe);
        const WindowVertex window = geometry.window[number];
        if (window.outcode & (outcode::unsnapped | outcode::not_finite)) continue;
        const Real reach = scale.eye + slow::length(slow::vec(object.position)) + slow::length(scaled);
        add_window(window, clip_position(geometry.transforms[index], p), viewer, exact[i], scale, reach, describe);
      }
    }
  }

  std::vector<VertexRow> rows(std::string_view scenes) {
    std::vector<VertexRow> rows;
    for (std::size_t i = 0; i < std::size(stored_values); ++i) {
      VertexBound bound = {stored_values[i], scenes, {}};
      for (const VertexBound& listed : vertex_bounds)
        if (listed.stored == bound.stored && listed.scenes == scenes) bound = listed;
      rows.push_back({bound, errors_[i].summary()});
    }
    return rows;
  }

private:
  /// An error, and the sum of the magnitudes that it is judged by.
  void add(std::size_t row, Real error, Real magnitude, const auto& describe) {
    const Real unit = std::max(magnitude, real(std::numeric_limits<double>::min())) * unit_roundoff;
    errors_[row].add(static_cast<double>(error / unit), describe);
  }

  void add_world(const WorldVertex& stored, const slow::Corner& exact, Vec place, Real size, const Double3& scale,
                 const auto& describe) {
    // Beyond, the stage itself draws coordinates in.
    if (!(largest(exact.position) < 0x1p1022L)) return;
    const Vec position = slow::vec(stored.position);
    const Real errors[] = {position.x - exact.position.x, position.y - exact.position.y, position.z - exact.position.z};
    const Real places[] = {place.x, place.y, place.z};
    Real worst = 0, magnitude = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Real here = std::abs(places[axis]) + size;
      if (std::abs(errors[axis]) * magnitude <= worst * here) continue;
      worst = std::abs(errors[axis]), magnitude = here;
    }
    add(0, worst, magnitude, describe);
    if (!(slow::length(exact.normal) > 0) || !keeps_normals(scale)) return; // flattened to a line, or none at all
    add(1, slow::length(slow::unit(slow::vec(stored.normal)) - slow::unit(exact.normal)), 1, describe);
  }

  void add_window(const WindowVertex& stored, const Double4& clip, const slow::Viewer& viewer,
                  const slow::Corner& exact, const CameraScale& scale, Real reach, const auto& describe) {
    const Vec window = viewer.window_of(exact);
    const double half_width = scale.half_width, half_height = scale.half_height;
    // raster/vertex/vertex_stage.h, before it snaps.
    const double x = clip.x / clip.w * half_width + half_width, y = half_height - clip.y / clip.w * half_height;
    const Real w = exact.w, exact_x = window.x / w * subpixels, exact_y = window.y / w * subpixels;
    const Real x_size = real(half_width) * (1 + (scale.x + std::abs(exact.x / w)) * reach / w);
    const Real y_size = real(half_height) * (1 + (scale.y + std::abs(exact.y / w)) * reach / w);
    const auto worse = [&](std::size_t row, Real x_error, Real y_error) {
      if (x_error * y_size > y_error * x_size) add(row, x_error, x_size, describe);
      else add(row, y_error, y_size, describe);
    };
    worse(2, std::abs(real(x) - exact_x), std::abs(real(y) - exact_y));
    // Nothing if it is the nearest point of the lattice; else how much farther than half way the place is from it.
    const auto beyond = [](std::int32_t snapped, Real place) {
      return std::max(std::abs(real(snapped) - place) - Real(0.5), Real(0));
    };
    worse(3, beyond(stored.x, exact_x), beyond(stored.y, exact_y));
    const Real depth = exact.z / w;
    add(4, std::abs(real(stored.z) - depth),
        std::abs(depth) + (scale.z * reach + scale.z_offset + std::abs(depth) * reach) / w, describe);
    add(5, std::abs(real(stored.inverse_w) - 1 / w), (1 + reach / w) / w, describe);
  }

  std::array<Errors, std::size(stored_values)> errors_;
};

} // namespace

std::vector<VertexRow> measure_gallery_vertices(const std::vector<std::string>& paths) {
  VertexErrors errors;
  for (const std::string& path : paths)
    errors.add_scene(std::filesystem::path(path).filename(), listed_scene(path), 1280, 720);
  return errors.rows("gallery");
}

std::vector<VertexRow> measure_random_vertices(int scenes) {
  VertexErrors errors;
  for (int seed = 0; seed < scenes; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    errors.add_scene("scene " + std::to_string(seed), test::random_scene(random), 64, 48);
  }
  return errors.rows("random scenes");
}

} // namespace refraster::precision
