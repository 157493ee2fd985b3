#include "tests/support/slow/slow_vertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace refraster::slow {
namespace {

struct Axes {
  Vec x, y, z; // columns
};
Vec operator*(const Axes& m, Vec v) {
  return m.x * v.x + m.y * v.y + m.z * v.z;
}
Axes operator*(const Axes& m, const Axes& n) {
  return {m * n.x, m * n.y, m * n.z};
}

constexpr Real degree = std::numbers::pi_v<Real> / 180;

Axes rotation_scale(const Object& object) {
  const auto angle = [](double degrees) { return std::fmod(real(degrees), Real(360)) * degree; }; // fmod is exact
  const Real a = angle(object.rotate_degrees.x), b = angle(object.rotate_degrees.y), c = angle(object.rotate_degrees.z);
  const Axes rx = {{1, 0, 0}, {0, std::cos(a), std::sin(a)}, {0, -std::sin(a), std::cos(a)}};
  const Axes ry = {{std::cos(b), 0, -std::sin(b)}, {0, 1, 0}, {std::sin(b), 0, std::cos(b)}};
  const Axes rz = {{std::cos(c), std::sin(c), 0}, {-std::sin(c), std::cos(c), 0}, {0, 0, 1}};
  const Vec s = vec(object.scale);
  return rx * (ry * (rz * Axes{{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}}));
}

/// 1 / tan(fov / 2). Beyond a right angle by the other angle, which is exact where pi / 2 - x is not.
Real half_cotangent(double fov_y_degrees) {
  const Real half = real(fov_y_degrees) / 2;
  return half <= 45 ? 1 / std::tan(half * degree) : std::tan((90 - half) * degree);
}

/// The axes of a model that mirrors turn a right-handed frame into a left-handed one.
void set_tangent(const Mesh& mesh, std::size_t vertex, const Axes& model, Real sign, Corner& corner) {
  if (vertex >= mesh.tangents.size()) return;
  const Float4& tangent = mesh.tangents[vertex];
  const Vec direction = model * vec(tangent);
  if (length(direction) > 0) corner.tangent = unit(direction);
  corner.handedness = real(tangent.w) * sign;
}

} // namespace

Viewer::Viewer(const Camera& camera, int width, int height)
    : width_(width), height_(height), eye_(vec(camera.position)) {
  back_ = unit(eye_ - vec(camera.target));
  right_ = unit(cross(vec(camera.up), back_));
  up_ = cross(back_, right_);
  cotangent_ = half_cotangent(camera.fov_y_degrees);
  near_ = real(camera.near);
  const Real far = real(camera.far);
  z_scale_ = (far + near_) / (near_ - far);
  z_offset_ = 2 * far * near_ / (near_ - far);
}

void Viewer::place(Corner& corner) const {
  const Vec from_eye = corner.position - eye_;
  const Real depth = -dot(from_eye, back_);
  const Real x = cotangent_ * dot(from_eye, right_) * height_ / width_, y = cotangent_ * dot(from_eye, up_);
  corner.x = x, corner.y = y, corner.z = -z_scale_ * depth + z_offset_, corner.w = depth;
  corner.window = window_of(corner);
  if (depth <= 0) return;
  const Real subpixels = 256, band = 65536;
  const Real px = corner.window.x / depth, py = corner.window.y / depth;
  if (std::abs(px) > band || std::abs(py) > band) return;
  // std::nearbyint rounds half to even.
  corner.window = {std::nearbyint(px * subpixels) / subpixels, std::nearbyint(py * subpixels) / subpixels, 1};
  corner.factor = 1 / depth;
}

Corner Viewer::cut(const Corner& front, const Corner& back) const {
  const Real w = std::min(near_, front.w) / 2, s = (w - back.w) / (front.w - back.w), t = 1 - s;
  Corner corner;
  corner.x = front.x * s + back.x * t, corner.y = front.y * s + back.y * t;
  corner.z = front.z * s + back.z * t, corner.w = w;
  corner.position = front.position * s + back.position * t, corner.normal = front.normal * s + back.normal * t;
  corner.has_uv = front.has_uv && back.has_uv;
  corner.u = front.u * s + back.u * t, corner.v = front.v * s + back.v * t;
  corner.colour = front.colour * s + back.colour * t;
  corner.tangent = front.tangent * s + back.tangent * t;
  corner.handedness = front.handedness * s + back.handedness * t;
  corner.window = window_of(corner);
  return corner;
}

Vec Viewer::window_of(const Corner& c) const {
  return {(c.x + c.w) * width_ / 2, (c.w - c.y) * height_ / 2, c.w};
}

std::vector<Corner> corners_of(const Object& object, const Viewer& viewer) {
  const Axes model = rotation_scale(object);
  // The inverse transpose is the matrix of cofactors over the determinant, of which only the sign matters.
  const Vec cx = cross(model.y, model.z), cy = cross(model.z, model.x), cz = cross(model.x, model.y);
  const Real sign = dot(model.x, cx) < 0 ? -1 : 1;
  const Axes normals = {cx * sign, cy * sign, cz * sign};
  const Mesh& mesh = *object.mesh;
  std::vector<Corner> corners(mesh.positions.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Corner& corner = corners[i];
    corner.position = model * vec(mesh.positions[i]) + vec(object.position);
    corner.normal = normals * vec(mesh.normals[i]);
    corner.has_uv = i < mesh.uvs.size();
    if (corner.has_uv) corner.u = real(mesh.uvs[i].x), corner.v = real(mesh.uvs[i].y);
    if (i < mesh.colours.size()) corner.colour = vec(mesh.colours[i]);
    set_tangent(mesh, i, model, sign, corner);
    viewer.place(corner);
  }
  return corners;
}

std::vector<Corner> stored_corners(const Scene& scene, const Geometry& geometry, std::size_t index, int width,
                                   int height) {
  const Mesh& mesh = *scene.objects[index].mesh;
  const Double4x4& m = geometry.transforms[index].world_from_object;
  const Axes model{vec(m[0]), vec(m[1]), vec(m[2])};
  const Real sign = dot(model.x, cross(model.y, model.z)) < 0 ? -1 : 1;
  std::vector<Corner> corners(mesh.positions.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Corner& corner = corners[i];
    const std::size_t number = geometry.first_vertex[index] + i;
    const Double4 clip = clip_position(geometry.transforms[index], mesh.positions[i]);
    const WindowVertex window = geometry.window[number];
    corner.position = vec(geometry.world[number].position);
    corner.normal = vec(geometry.world[number].normal);
    corner.has_uv = i < mesh.uvs.size();
    if (corner.has_uv) corner.u = real(mesh.uvs[i].x), corner.v = real(mesh.uvs[i].y);
    if (i < mesh.colours.size()) corner.colour = vec(mesh.colours[i]);
    set_tangent(mesh, i, model, sign, corner);
    corner.x = real(clip.x), corner.y = real(clip.y), corner.z = real(clip.z), corner.w = real(clip.w);
    if (window.outcode & outcode::unsnapped) {
      corner.window = {(corner.x + corner.w) * width / 2, (corner.w - corner.y) * height / 2, corner.w};
    } else {
      corner.window = {real(window.x) / subpixels, real(window.y) / subpixels, 1};
      corner.factor = real(window.inverse_w);
    }
  }
  return corners;
}

} // namespace refraster::slow
