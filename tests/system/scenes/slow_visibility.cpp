#include "tests/system/scenes/slow_visibility.h"

#include "raster/vertex/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>
#include <utility>

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

Axes rotation_scale(const Object& object) {
  const auto angle = [](double degrees) { return real(degrees) * std::numbers::pi_v<Real> / 180; };
  const Real a = angle(object.rotate_degrees.x), b = angle(object.rotate_degrees.y), c = angle(object.rotate_degrees.z);
  const Axes rx = {{1, 0, 0}, {0, std::cos(a), std::sin(a)}, {0, -std::sin(a), std::cos(a)}};
  const Axes ry = {{std::cos(b), 0, -std::sin(b)}, {0, 1, 0}, {std::sin(b), 0, std::cos(b)}};
  const Axes rz = {{std::cos(c), std::sin(c), 0}, {-std::sin(c), std::cos(c), 0}, {0, 0, 1}};
  const Vec s = vec(object.scale);
  return rx * (ry * (rz * Axes{{s.x, 0, 0}, {0, s.y, 0}, {0, 0, s.z}}));
}

/// A vertex: its homogeneous window point in pixels, y down, and the factor between that and its clip coordinates.
struct Corner {
  Vec window;      // x, y, w
  Real factor = 1; // clip = point * factor
  Real x = 0, y = 0, z = 0, w = 0;
  Vec position, normal;
  bool has_uv = false;
  Real u = 0, v = 0;
};

/// The order that makes pieces the same whatever corner of a triangle comes first.
bool before(const Corner& a, const Corner& b) {
  return std::tie(a.x, a.y, a.w, a.z) < std::tie(b.x, b.y, b.w, b.z);
}

class Viewer {
public:
  Viewer(const Camera& camera, int width, int height) : width_(width), height_(height), eye_(vec(camera.position)) {
    back_ = unit(eye_ - vec(camera.target));
    right_ = unit(cross(vec(camera.up), back_));
    up_ = cross(back_, right_);
    cotangent_ = 1 / std::tan(real(camera.fov_y_degrees) * std::numbers::pi_v<Real> / 360);
    near_ = real(camera.near);
    const Real far = real(camera.far);
    z_scale_ = (far + near_) / (near_ - far);
    z_offset_ = 2 * far * near_ / (near_ - far);
  }

  /// Fills what the position decides.
  void place(Corner& corner) const {
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

  /// Where the edge from a corner in front of the eye to one behind ends: at half the distance of the near plane, or of
  /// the corner, should that be nearer. Not snapped.
  Corner cut(const Corner& front, const Corner& back) const {
    const Real w = std::min(near_, front.w) / 2, s = (w - back.w) / (front.w - back.w), t = 1 - s;
    Corner corner;
    corner.x = front.x * s + back.x * t, corner.y = front.y * s + back.y * t;
    corner.z = front.z * s + back.z * t, corner.w = w;
    corner.position = front.position * s + back.position * t, corner.normal = front.normal * s + back.normal * t;
    corner.has_uv = front.has_uv && back.has_uv;
    corner.u = front.u * s + back.u * t, corner.v = front.v * s + back.v * t;
    corner.window = window_of(corner);
    return corner;
  }

private:
  Vec window_of(const Corner& c) const { return {(c.x + c.w) * width_ / 2, (c.w - c.y) * height_ / 2, c.w}; }

  Real width_, height_, near_, cotangent_, z_scale_, z_offset_;
  Vec eye_, back_, right_, up_;
};

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
    viewer.place(corner);
  }
  return corners;
}

/// The same from what raster/vertex/transform.h stores of object number `index`.
std::vector<Corner> stored_corners(const Scene& scene, const Geometry& geometry, std::size_t index, int width,
                                   int height) {
  const Mesh& mesh = *scene.objects[index].mesh;
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

/// A pixel centre p = sum of lambda_k (window point k): inside where no lambda is negative.
struct Planes {
  std::array<Vec, 3> lambda; // lambda_k(p) = dot(lambda[k], (x, y, 1))
};

/// What a pixel has met so far.
struct Candidate {
  Real depth = std::numeric_limits<Real>::infinity();
  bool doubtful = false;
  Seen seen;
};

// An edge through lattice points passes a pixel centre at no less than 2^-45 of the triangle, unless exactly.
constexpr Real edge_doubt = 0x1p-50L;
// Depths are computed in double from vertices that are good to a few 2^-53; triangles here are seen under angles at
// which the slope of depth does not cost more than 2^13 of that.
constexpr Real depth_doubt = 0x1p-38L;

void look(const Object& object, const std::array<const Corner*, 3>& c, const Planes& planes, Pixel pixel,
          Candidate& candidate) {
  const Vec p = {pixel.x + Real(0.5), pixel.y + Real(0.5), 1};
  std::array<Real, 3> lambda;
  Real least = std::numeric_limits<Real>::infinity(), size = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    lambda[k] = dot(planes.lambda[k], p);
    least = std::min(least, lambda[k]);
    size += std::abs(lambda[k]);
  }
  const Real doubt = edge_doubt * size;
  if (least < -doubt) return;

  // What is weighted by mu is linear in clip space: perspective-correct.
  std::array<Real, 3> mu, mu_right, mu_down;
  Real sum = 0, sum_right = 0, sum_down = 0, z = 0, w = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    mu[k] = lambda[k] * c[k]->factor;
    mu_right[k] = planes.lambda[k].x * c[k]->factor;
    mu_down[k] = planes.lambda[k].y * c[k]->factor;
    sum += mu[k], sum_right += mu_right[k], sum_down += mu_down[k];
    z += mu[k] * c[k]->z, w += mu[k] * c[k]->w;
  }
  const Real depth = z / w;
  if (depth < -1 - depth_doubt || depth > 1 + depth_doubt) return;
  if (depth > candidate.depth + depth_doubt) return;
  const bool doubtful = least <= doubt || std::abs(std::abs(depth) - 1) <= depth_doubt ||
                        std::abs(depth - candidate.depth) <= depth_doubt;

  const auto mean = [&](auto&& attribute) {
    return attribute(*c[0]) * (mu[0] / sum) + attribute(*c[1]) * (mu[1] / sum) + attribute(*c[2]) * (mu[2] / sum);
  };
  const auto u = [](const Corner& corner) { return corner.u; };
  const auto v = [](const Corner& corner) { return corner.v; };
  // (a / b)' = (a' - (a / b) b') / b
  const auto change = [&](auto&& attribute, const std::array<Real, 3>& step, Real sum_step) {
    const Real a = attribute(*c[0]) * step[0] + attribute(*c[1]) * step[1] + attribute(*c[2]) * step[2];
    return (a - mean(attribute) * sum_step) / sum;
  };
  Seen seen;
  seen.object = &object;
  seen.position = mean([](const Corner& corner) { return corner.position; });
  const Vec normal = mean([](const Corner& corner) { return corner.normal; });
  seen.has_uv = c[0]->has_uv && c[1]->has_uv && c[2]->has_uv;
  seen.u = mean(u), seen.v = mean(v);
  seen.u_right = change(u, mu_right, sum_right), seen.v_right = change(v, mu_right, sum_right);
  seen.u_down = change(u, mu_down, sum_down), seen.v_down = change(v, mu_down, sum_down);
  if (length(normal) > 0) seen.normal = unit(normal);
  candidate = {depth, doubtful || !(length(normal) > 0), seen};
}

/// A polygon of 0, 3 or 4 corners.
std::vector<Corner> part_in_front(const std::array<const Corner*, 3>& triangle, const Viewer& viewer) {
  std::array<const Corner*, 3> c = triangle;
  bool odd = false;
  for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
    if (!before(*c[static_cast<std::size_t>(j)], *c[static_cast<std::size_t>(i)])) continue;
    std::swap(c[static_cast<std::size_t>(i)], c[static_cast<std::size_t>(j)]);
    odd = !odd;
  }
  std::vector<Corner> polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &here = *c[k], &next = *c[(k + 1) % 3];
    if (here.w > 0) polygon.push_back(here);
    if ((here.w > 0) != (next.w > 0)) polygon.push_back(here.w > 0 ? viewer.cut(here, next) : viewer.cut(next, here));
  }
  if (odd) std::reverse(polygon.begin() + (polygon.empty() ? 0 : 1), polygon.end()); // the winding as submitted
  return polygon;
}

} // namespace

std::vector<std::optional<Seen>> seen_at(const Scene& scene, int width, int height, std::span<const Pixel> pixels,
                                         Vertices vertices) {
  const Viewer viewer(scene.camera, width, height);
  Geometry geometry;
  if (vertices == Vertices::of_the_renderer) {
    RenderOptions options;
    options.width = width, options.height = height, options.threads = 1;
    transform({scene, options}, geometry);
  }
  std::vector<Candidate> candidates(pixels.size());
  for (std::size_t index = 0; index < scene.objects.size(); ++index) {
    const Object& object = scene.objects[index];
    const std::vector<Corner> corners =
        vertices == Vertices::own ? corners_of(object, viewer) : stored_corners(scene, geometry, index, width, height);
    const auto draw = [&](const std::array<const Corner*, 3>& c) {
      const Vec e0 = cross(c[1]->window, c[2]->window), e1 = cross(c[2]->window, c[0]->window),
                e2 = cross(c[0]->window, c[1]->window);
      const Real determinant = dot(c[0]->window, e0);
      if (determinant == 0) return;
      if (object.cull == Cull::back && determinant > 0) return; // clockwise in the image, with y down
      const Planes planes = {{e0 * (1 / determinant), e1 * (1 / determinant), e2 * (1 / determinant)}};
      for (std::size_t i = 0; i < pixels.size(); ++i) look(object, c, planes, pixels[i], candidates[i]);
    };
    for (const auto& triangle : object.mesh->triangles) {
      const std::array<const Corner*, 3> c = {&corners[triangle[0]], &corners[triangle[1]], &corners[triangle[2]]};
      if (c[0]->w > 0 && c[1]->w > 0 && c[2]->w > 0) {
        draw(c);
        continue;
      }
      const std::vector<Corner> part = part_in_front(c, viewer);
      for (std::size_t k = 1; k + 1 < part.size(); ++k) draw({&part[0], &part[k], &part[k + 1]});
    }
  }
  std::vector<std::optional<Seen>> result;
  for (const Candidate& candidate : candidates)
    result.push_back(candidate.doubtful ? std::nullopt : std::optional(candidate.seen));
  return result;
}

} // namespace refraster::slow
