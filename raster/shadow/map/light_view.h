#pragma once
// From where the depth map of a light is drawn, and where a surface lies in it. docs/shadow-maps.md has the formulas.

#include <refraster/scene.h>

#include "math/vec.h"
#include "raster/frame_context.h"
#include "raster/shadow/shadow_ray.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace refraster {

/// The smallest box along the axes of the world that holds some points; none if low > high.
struct WorldBox {
  Double3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return !(low.x <= high.x); }
  void add(const Double3& p);
};

/// Of all vertices of a scene that are finite, as the vertex stage places them in the world, in double.
WorldBox world_box(const Scene& scene, int threads);

/// What casts the shadows of a scene: its objects without their materials, both sides of each, and nothing cut out.
Scene casters_of(const Scene& scene);

/// Unit vectors of one image of a map: along its columns, along its rows, and away from the light. right x up is
/// against ahead, as for a camera.
struct MapAxes {
  Double3 right{1, 0, 0}, up{0, 1, 0}, ahead{0, 0, -1};
};

/// The six faces of a point light's map: those of OpenGL's cube map, in its order (OpenGL 4.6, table 8.19). A face's
/// columns run along sc, its rows along tc.
inline constexpr std::size_t cube_faces = 6;
struct CubeFace {
  int ahead, ahead_sign, right, right_sign, up, up_sign; // axes of the world, and which way along them
  const char* name;
};
inline constexpr std::array<CubeFace, cube_faces> cube_face_axes{{{0, 1, 2, -1, 1, -1, "+x"},
                                                                  {0, -1, 2, 1, 1, -1, "-x"},
                                                                  {1, 1, 0, 1, 2, 1, "+y"},
                                                                  {1, -1, 0, 1, 2, -1, "-y"},
                                                                  {2, 1, 0, 1, 1, -1, "+z"},
                                                                  {2, -1, 0, -1, 1, -1, "-z"}}};

/// The face that a direction from the light falls in: that of the axis along which it is longest; of axes along which
/// it is equally long x before y before z. The direction of length 0 falls in +x.
inline std::size_t cube_face_of(const Double3& d) {
  const Double3 a = abs(d);
  const std::size_t axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return 2 * axis + (d[static_cast<int>(axis)] < 0);
}

/// What lookups are computed with: uniforms of a shader.
struct MapConstants {
  double texels = 0;    // size / 2 for a point light, size / side for a direction light
  double half_size = 0; // of the map, in texels
  double texel = 0;     // its width: at distance 1 for a point light, anywhere for a direction light
  // Window depth is scale (z - near) for a direction light, scale - offset / z for a point light.
  double depth_scale = 0;
  double depth_offset = 0;
};

/// How many texels a filter compares along an axis.
constexpr int taps_across(ShadowFilter filter) {
  return filter == ShadowFilter::nearest ? 1 : filter == ShadowFilter::two_by_two ? 2 : 3;
}

/// Where one light's map is drawn from.
struct LightView {
  LightPlace::Kind kind = LightPlace::Kind::direction;
  ShadowMap map;
  Double3 origin{0};      // what positions are counted from: the light, or the middle of the scene's box
  MapAxes axes;           // of a direction light
  double half = 1;        // of a direction light: half of the map's side, in units of the world
  double near = 0;        // the depth planes' distances from the origin, along `ahead`
  double far = 1;         // > near
  MapConstants constants; // follow from all of these

  std::size_t faces() const { return kind == LightPlace::Kind::point ? cube_faces : 1; }
  MapAxes axes_of(std::size_t face) const;
  Viewpoint viewpoint(std::size_t face) const;
};

/// That of a light with a map over a scene that fills the box. Everything in double; the same on every machine.
LightView light_view(const PointLight& light, const WorldBox& box);
LightView light_view(const DirectionLight& light, const WorldBox& box);

/// Of every light of a scene with a map, in the order of the sum. Looks at no mesh where there is none.
std::vector<LightView> light_views(const Scene& scene, int threads);

/// Where a surface lies in an image of a map, in texels from its lower left corner, and the window depth that is
/// compared with what the map holds: that of the point moved to the light by the bias, and at most 1.
template <class T>
struct MapPlace {
  T u, v, depth;
};

/// x along an axis of the world, with that sign.
template <class T>
T along(const Vec3<T>& v, int axis, int sign) {
  return sign < 0 ? -v[axis] : v[axis];
}

/// What the slope is divided by is at least this: where the light only grazes a surface the slope is huge, and the
/// surface lit, as it is nearly there. Far below every cosine of float, and far above what overflows in it.
inline constexpr double min_run = 0x1p-80;

/// `position` and `normal`, of any length, in the world. The slope of a surface in the map, in texels of depth for each
/// texel across, is the greater of those along the map's columns and rows; 0 without a normal. Formulas of any Number.
template <class T>
MapPlace<T> map_place(const LightView& view, std::size_t face, const Vec3<T>& position, const Vec3<T>& normal) {
  const MapConstants& of = view.constants;
  const bool is_point = view.kind == LightPlace::Kind::point;
  const Vec3<T> d = position - as<T>(view.origin);
  const auto in_map = [&](const Vec3<T>& v) {
    if (is_point) {
      const CubeFace& f = cube_face_axes[face];
      return Vec3<T>(along(v, f.right, f.right_sign), along(v, f.up, f.up_sign), along(v, f.ahead, f.ahead_sign));
    }
    return Vec3<T>(dot(as<T>(view.axes.right), v), dot(as<T>(view.axes.up), v), dot(as<T>(view.axes.ahead), v));
  };
  const Vec3<T> at = in_map(d);
  T bias = as<T>(view.map.bias);
  if (view.map.slope_bias != 0) {
    const Vec3<T> n = in_map(normal);
    const T rise = is_point ? max(abs(n.x), abs(n.y)) * at.z : max(abs(n.x), abs(n.y));
    const T run = is_point ? abs(dot(n, at)) : abs(n.z);
    bias += as<T>(view.map.slope_bias) * (rise / max(run, T(min_run)));
  }
  const T texel = is_point ? as<T>(of.texel) * at.z : as<T>(of.texel);
  const T z = at.z - texel * bias;
  const T scale = as<T>(of.texels), middle = as<T>(of.half_size);
  if (is_point) {
    const T depth = as<T>(of.depth_scale) - as<T>(of.depth_offset) / max(z, as<T>(view.near));
    return {at.x / at.z * scale + middle, at.y / at.z * scale + middle, min(depth, T(1))};
  }
  return {at.x * scale + middle, at.y * scale + middle, min((z - as<T>(view.near)) * as<T>(of.depth_scale), T(1))};
}

} // namespace refraster
