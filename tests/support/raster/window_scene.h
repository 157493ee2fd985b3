#pragma once
// Scenes whose corners are placed by where they are seen.

#include <refraster/render.h>

#include "tests/support/raster/exact_triangle.h"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace refraster::test {

/// What a camera sees that stands at the origin and looks along -z over a square image, with a field of view of 90
/// degrees. Its cotangent is exactly 1, so that clip coordinates are (x, y, ., -z) exactly, and the ray through a point
/// of the window is rational.
struct WindowScene {
  int side;
  Scene scene;

  explicit WindowScene(int image_side, double near = 0.25, double far = 1024) : side(image_side) {
    scene.camera.fov_y_degrees = 90;
    scene.camera.near = near, scene.camera.far = far;
  }

  /// The point seen at window (x, y), in pixels, at distance w in front of the eye plane. Exact for powers of two, and
  /// for x and y in few bits; the window place of any other point is that of the rounded one.
  Float3 place(double x, double y, double w) const {
    const double half = side / 2.0;
    return {static_cast<float>((x - half) / half * w), static_cast<float>((half - y) / half * w),
            static_cast<float>(-w)};
  }

  /// Three corners a triangle. Shines in `colour` whatever the light.
  Object& add(const std::vector<Float3>& corners, Double3 colour = Double3(1), std::vector<Float2> uvs = {}) {
    auto mesh = std::make_shared<Mesh>();
    mesh->positions = corners;
    mesh->normals.assign(corners.size(), Float3(0, 0, 1));
    mesh->uvs = std::move(uvs);
    for (std::uint32_t i = 0; i < corners.size(); i += 3) mesh->triangles.push_back({i, i + 1, i + 2});
    Phong shining;
    shining.ka = colour, shining.kd = Double3(0), shining.ks = Double3(0);
    Object object;
    object.mesh = mesh;
    object.material.fragment_function = shining;
    scene.objects.push_back(object);
    return scene.objects.back();
  }

  RenderOptions options(std::vector<Aov> aovs = {}, int samples = 1) const {
    RenderOptions o;
    o.width = o.height = side;
    o.want_radiance = true;
    o.samples = samples;
    o.threads = 1;
    o.aovs = std::move(aovs);
    return o;
  }
  Frame frame(std::vector<Aov> aovs = {}, int samples = 1) const {
    return render(scene, options(std::move(aovs), samples));
  }

  /// From the eye through a point of the window, in pixels; of any length.
  RationalVec3 ray(const Rational& x, const Rational& y) const {
    const Rational half(side, 2);
    return {Rational((x - half) / half), Rational((half - y) / half), Rational(-1)};
  }
  RationalVec3 centre_ray(int x, int y) const { return ray(Rational(2 * x + 1, 2), Rational(2 * y + 1, 2)); }

  Double4 clip(const Float3& corner) const {
    return clip_position(object_transform(Object{}, clip_from_world(scene.camera, 1)), corner);
  }
  ExactTriangle exact_triangle(const Float3& a, const Float3& b, const Float3& c) const {
    return ExactTriangle({clip(a), clip(b), clip(c)}, side, side);
  }
};

/// Whether a pixel shows a surface, of a frame with Aov::object as its `index`-th AOV.
inline bool is_drawn(const Frame& frame, int x, int y, std::size_t index = 0) {
  return *frame.aovs[index].at(x, y) != 0;
}

inline long drawn_pixels(const Frame& frame, std::size_t index = 0) {
  long count = 0;
  for (const float object : frame.aovs[index].values) count += object != 0;
  return count;
}

/// Half the distance between floats at `exact`: what rounding an image's value to float may add to an error.
inline Mpfr half_float_ulp(const Mpfr& exact) {
  const float magnitude = std::abs(exact.convert_to<float>());
  return Mpfr(std::nextafter(magnitude, INFINITY) - magnitude) / 2;
}

/// What double arithmetic may do to an attribute whose value is at most `most` at every corner. In units of 2^-53: a
/// corner's weight is good to 2, times its line's exact value to 3, the sum of three to 5, so a share to 9, times a
/// difference of corners (at most 2 most, itself to 1) to 11; two of them and two sums are within 32 of `most`.
inline Mpfr interpolation_bound(const Mpfr& most) {
  return most * Mpfr(0x1p-48);
}

inline constexpr int all_threads[] = {1, 2, 3, 7};
inline constexpr int all_tile_sizes[] = {8, 16, 32, 64, 128};

} // namespace refraster::test
