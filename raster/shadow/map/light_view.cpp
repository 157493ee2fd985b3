#include "raster/shadow/map/light_view.h"

#include "raster/parallel.h"
#include "raster/vertex/transform.h"
#include "raster/vertex/vertex_stage.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace refraster {
namespace {

/// Of a point light's near plane: the farthest distance over this, or half of the nearest one where that is more. A
/// float depth d = f / (f - n) (1 - n / z) then resolves z^2 / n 2^-24: at the far plane 2^-16 of its distance, a
/// sixteenth of a texel of 4096 on a face.
constexpr double far_over_near = 256;

/// Where a scene has no extent.
constexpr double no_extent = 1;

/// What is seen in the map leaves a texel free on each side, and so much before and behind it: more than rounding in
/// float moves a vertex, so that none is cut off by the depth planes.
constexpr double free_texels = 2;

Double3 axis(int number, int sign) {
  Double3 result(0);
  result[number] = sign;
  return result;
}

/// Of a direction: up is as far from it as an axis of the world can be, of those equally far the first.
MapAxes axes_along(const Double3& direction) {
  MapAxes axes;
  axes.ahead = normalize(direction);
  const Double3 a = abs(axes.ahead);
  const int least = a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2;
  axes.right = normalize(cross(axes.ahead, axis(least, 1)));
  axes.up = cross(axes.right, axes.ahead);
  return axes;
}

/// Half of the extent of a box along a unit vector.
double half_along(const Double3& half, const Double3& axis) {
  return abs(axis.x) * half.x + abs(axis.y) * half.y + abs(axis.z) * half.z;
}

MapConstants map_constants(const LightView& view) {
  const double size = view.map.size, depth = view.far - view.near;
  if (view.kind == LightPlace::Kind::point)
    return {size / 2, size / 2, 2 / size, view.far / depth, view.near * (view.far / depth)};
  return {size / (2 * view.half), size / 2, 2 * view.half / size, 1 / depth, 0};
}

double positive_or(double x, double otherwise) {
  return x > 0 ? x : otherwise;
}

} // namespace

void WorldBox::add(const Double3& p) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) return;
  for (int c = 0; c < 3; ++c) low[c] = std::min(low[c], p[c]), high[c] = std::max(high[c], p[c]);
}

WorldBox world_box(const Scene& scene, int threads) {
  constexpr std::size_t piece = 1 << 14;
  WorldBox box;
  for (const Object& object : scene.objects) {
    const Double4x4 world = object_transform(object, Double4x4(1)).world_from_object;
    const std::vector<Float3>& positions = object.mesh->positions;
    std::vector<WorldBox> pieces((positions.size() + piece - 1) / piece);
    parallel_for(threads, pieces.size(), [&](std::size_t p, int) {
      for (std::size_t i = p * piece; i < std::min(positions.size(), (p + 1) * piece); ++i)
        if (const Double3 at(positions[i]); std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z))
          pieces[p].add(world_position<double>(world, at));
    });
    for (const WorldBox& part : pieces) box.add(part.low), box.add(part.high);
  }
  return box;
}

Scene casters_of(const Scene& scene) {
  Scene casters;
  casters.camera = scene.camera;
  for (const Object& object : scene.objects) {
    Object& caster = casters.objects.emplace_back();
    caster.mesh = object.mesh;
    caster.position = object.position, caster.rotate_degrees = object.rotate_degrees, caster.scale = object.scale;
  }
  return casters;
}

MapAxes LightView::axes_of(std::size_t face) const {
  if (kind == LightPlace::Kind::direction) return axes;
  const CubeFace& f = cube_face_axes[face];
  return {axis(f.right, f.right_sign), axis(f.up, f.up_sign), axis(f.ahead, f.ahead_sign)};
}

Viewpoint LightView::viewpoint(std::size_t face) const {
  const MapAxes of = axes_of(face);
  const Double4 x(of.right, -dot(of.right, origin)), y(of.up, -dot(of.up, origin)), z(of.ahead, -dot(of.ahead, origin));
  std::array<Double4, 4> rows;
  if (kind == LightPlace::Kind::point)
    rows = {x, y, z * ((far + near) / (far - near)) - Double4(0, 0, 0, 2 * far * near / (far - near)), z};
  else
    rows = {x * (1 / half), y * (1 / half), z * (2 / (far - near)) - Double4(0, 0, 0, (far + near) / (far - near)),
            Double4(0, 0, 0, 1)};
  Viewpoint result;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      result.clip_from_world[column][row] = rows[static_cast<std::size_t>(row)][column];
  result.near = kind == LightPlace::Kind::point ? near : 1;
  return result;
}

LightView light_view(const PointLight& light, const WorldBox& box) {
  LightView view;
  view.kind = LightPlace::Kind::point;
  view.map = light.shadow.map;
  view.origin = light.position;
  double farthest = 0, nearest = 0; // along an axis of the world, as depth is
  for (int c = 0; c < 3 && !box.is_empty(); ++c) {
    const double below = box.low[c] - light.position[c], above = box.high[c] - light.position[c];
    farthest = std::max({farthest, -below, above});
    nearest = std::max({nearest, below, -above});
  }
  const double last = positive_or(farthest, no_extent) * (1 + free_texels / view.map.size);
  const double first = view.map.near > 0 ? view.map.near : std::max(last / far_over_near, nearest / 2);
  constexpr double largest = 0x1p500; // products of the two stay finite
  view.near = std::min(std::max(first, std::numeric_limits<double>::min()), largest);
  view.far = std::max(std::min(last, 2 * largest), 2 * view.near);
  view.constants = map_constants(view);
  return view;
}

LightView light_view(const DirectionLight& light, const WorldBox& box) {
  LightView view;
  view.map = light.shadow.map;
  view.axes = axes_along(light.direction);
  const Double3 half = box.is_empty() ? Double3(0) : box.high * 0.5 - box.low * 0.5;
  if (!box.is_empty()) view.origin = box.low * 0.5 + box.high * 0.5;
  const double across =
      positive_or(std::max(half_along(half, view.axes.right), half_along(half, view.axes.up)), no_extent);
  const double size = view.map.size;
  view.half = across * size / (size - free_texels);
  const double deep = half_along(half, view.axes.ahead) + free_texels * view.half / size;
  view.near = -deep, view.far = deep;
  view.constants = map_constants(view);
  return view;
}

std::vector<LightView> light_views(const Scene& scene, int threads) {
  std::vector<LightView> views;
  if (!has_shadows(scene, Shadow::map)) return views;
  const WorldBox box = world_box(scene, threads);
  for_each_light_list(scene, [&](const auto& lights) {
    for (const auto& light : lights)
      if (light.shadow == Shadow::map) views.push_back(light_view(light, box));
  });
  return views;
}

} // namespace refraster
