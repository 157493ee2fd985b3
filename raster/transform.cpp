#include "raster/transform.h"

#include "math/elementary.h"
#include "raster/parallel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace refraster {

namespace {

// A rotation by `degrees` in the plane of axes i and j, turning i toward j.
Double3x3 rotation(double degrees, int i, int j) {
  Double3x3 m(1);
  const double c = cos_degrees(degrees), s = sin_degrees(degrees);
  m[i][i] = c, m[i][j] = s; // m[column][row]
  m[j][i] = -s, m[j][j] = c;
  return m;
}

Double3x3 linear_part(const Object& object) {
  const Double3& r = object.rotate_degrees;
  const Double3x3 rotated = rotation(r.x, 1, 2) * rotation(r.y, 2, 0) * rotation(r.z, 0, 1);
  return {rotated[0] * object.scale.x, rotated[1] * object.scale.y, rotated[2] * object.scale.z};
}

// The inverse transpose is cofactors / determinant; normals need only its direction, so the division, which a flattened
// scale would make impossible, is left out and the sign kept. det = 0 counts as positive.
Double3x3 normal_matrix(const Double3x3& m) {
  // A common factor changes no direction, and a power of two no digit. With columns m_k = u_k / s_k, each u_k of about
  // unit size, the cofactors (u_i x u_j) / (s_i s_j) are s_k (u_i x u_j) times a common factor: no product leaves the
  // range of double, whatever the scales.
  constexpr double below_one = 0.25; // so that s_k (u_i x u_j) stays finite for the largest s_k
  const auto size = [&](int k) { return below_one * reciprocal_binade(m[k]); };
  const Double3 u0 = m[0] * size(0), u1 = m[1] * size(1), u2 = m[2] * size(2);
  const Double3x3 cofactors(cross(u1, u2) * size(0), cross(u2, u0) * size(1), cross(u0, u1) * size(2));
  const double sign = dot(u0, cofactors[0]) < 0 ? -1 : 1;
  double most = 0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) most = maximum(magnitude(cofactors[column][row]), most);
  return cofactors * (sign * reciprocal_binade(most));
}

} // namespace

Double4x4 view_from_world(const Camera& camera) {
  const Double3 back = normalize(camera.position - camera.target);
  const Double3 right = normalize(cross(camera.up, back));
  const Double3 up = cross(back, right);
  const Double3& eye = camera.position;
  Double4x4 view(1);
  for (int axis = 0; axis < 3; ++axis) {
    view[axis][0] = right[axis];
    view[axis][1] = up[axis];
    view[axis][2] = back[axis];
  }
  view[3] = {-dot(right, eye), -dot(up, eye), -dot(back, eye), 1};
  return view;
}

Double4x4 clip_from_view(const Camera& camera, double aspect) {
  const double cotangent = 1 / tan_degrees(camera.fov_y_degrees / 2);
  const double depth = camera.near - camera.far;
  Double4x4 projection(0);
  projection[0][0] = cotangent / aspect;
  projection[1][1] = cotangent;
  projection[2][2] = (camera.far + camera.near) / depth;
  projection[2][3] = -1;
  projection[3][2] = 2 * camera.far * camera.near / depth;
  return projection;
}

Double4x4 clip_from_world(const Camera& camera, double aspect) {
  return clip_from_view(camera, aspect) * view_from_world(camera);
}

ObjectTransform object_transform(const Object& object, const Double4x4& clip_from_world) {
  const Double3x3 linear = linear_part(object);
  Double4x4 model(linear);
  model[3] = {object.position.x, object.position.y, object.position.z, 1};
  return {clip_from_world * model, model, normal_matrix(linear)};
}

Double4 clip_position(const ObjectTransform& transform, const Float3& position) {
  return transform.clip_from_object * Double4(position.x, position.y, position.z, 1.0);
}

WindowVertex window_vertex(const Double4& clip, int width, int height) {
  const auto finite = [](double x) { return magnitude(x) <= std::numeric_limits<double>::max(); };
  WindowVertex vertex;
  if (!(finite(clip.x) && finite(clip.y) && finite(clip.z) && finite(clip.w))) {
    vertex.outcode = outcode::not_finite;
    return vertex;
  }
  const double w = clip.w;
  std::uint8_t code = 0;
  if (clip.x < -w) code |= outcode::left;
  if (clip.x > w) code |= outcode::right;
  if (clip.y < -w) code |= outcode::bottom;
  if (clip.y > w) code |= outcode::top;
  if (clip.z < -w) code |= outcode::near;
  if (clip.z > w) code |= outcode::far;

  const double half_width = subpixels / 2 * width, half_height = subpixels / 2 * height;
  const double x = clip.x / w * half_width + half_width;
  const double y = half_height - clip.y / w * half_height;
  // Below the smallest normal number 1 / w would overflow: such a vertex is as good as on the eye plane.
  const bool on_lattice =
      w >= std::numeric_limits<double>::min() && magnitude(x) <= guard_band && magnitude(y) <= guard_band;
  if (!on_lattice) {
    vertex.outcode = code | outcode::unsnapped;
    return vertex;
  }
  vertex.x = static_cast<std::int32_t>(std::nearbyint(x)); // half to even, as Direct3D 11.3 §3.4.1 has it
  vertex.y = static_cast<std::int32_t>(std::nearbyint(y));
  vertex.z = clip.z / w;
  vertex.inverse_w = 1 / w;
  vertex.outcode = code;
  return vertex;
}

void transform(const Scene& scene, int width, int height, int threads, Geometry& geometry) {
  const Double4x4 view_projection = clip_from_world(scene.camera, static_cast<double>(width) / height);
  geometry.transforms.clear();
  geometry.first_vertex.assign(1, 0);
  geometry.first_triangle.assign(1, 0);
  for (const Object& object : scene.objects) {
    geometry.transforms.push_back(object_transform(object, view_projection));
    geometry.first_vertex.push_back(geometry.first_vertex.back() +
                                    static_cast<std::uint32_t>(object.mesh->positions.size()));
    geometry.first_triangle.push_back(geometry.first_triangle.back() +
                                      static_cast<std::uint32_t>(object.mesh->triangles.size()));
  }
  geometry.window.resize_uninitialized(geometry.first_vertex.back());
  geometry.world.resize_uninitialized(geometry.first_vertex.back());
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Mesh& mesh = *scene.objects[o].mesh;
    const ObjectTransform& matrices = geometry.transforms[o];
    const std::size_t first = geometry.first_vertex[o];
    const std::size_t count = mesh.positions.size(), chunk = 4096;
    parallel_for(threads, (count + chunk - 1) / chunk, [&](std::size_t index, int) {
      for (std::size_t v = index * chunk; v < std::min(count, (index + 1) * chunk); ++v) {
        const Float3& p = mesh.positions[v];
        const Float3& n = mesh.normals[v];
        geometry.window[first + v] = window_vertex(clip_position(matrices, p), width, height);
        geometry.world[first + v] = {Double3(matrices.world_from_object * Double4(p.x, p.y, p.z, 1.0)),
                                     matrices.world_from_normal * Double3(n.x, n.y, n.z)};
      }
    });
  }
}

TriangleRef triangle_ref(const Scene& scene, const Geometry& geometry, std::uint32_t triangle) {
  const auto after = std::upper_bound(geometry.first_triangle.begin(), geometry.first_triangle.end(), triangle);
  TriangleRef ref;
  ref.object = static_cast<std::uint32_t>(after - geometry.first_triangle.begin()) - 1;
  ref.triangle = triangle - geometry.first_triangle[ref.object];
  const auto& corners = scene.objects[ref.object].mesh->triangles[ref.triangle];
  for (std::size_t k = 0; k < 3; ++k) ref.vertex[k] = geometry.first_vertex[ref.object] + corners[k];
  return ref;
}

} // namespace refraster
