#include "verify/oracle/exact_surface.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace refraster::oracle {
namespace {

struct Turn {
  Exact cosine, sine;
};

/// Quarter turns are exact.
Turn turn(double degrees) {
  const double rest = std::fmod(degrees, 360); // exact
  const Exact angle = Exact(rest) * pi() / 180;
  const auto quarters = static_cast<long>(rest / 90);
  if (static_cast<double>(quarters) * 90 != rest) return {cos(angle), sin(angle)};
  switch ((quarters % 4 + 4) % 4) {
  case 0:
    return {1, 0};
  case 1:
    return {0, 1};
  case 2:
    return {-1, 0};
  default:
    return {0, -1};
  }
}

using Columns = std::array<Exact3, 3>;

Exact3 operator*(const Columns& m, const Exact3& v) {
  return m[0] * v[0] + m[1] * v[1] + m[2] * v[2];
}
Columns operator*(const Columns& m, const Columns& n) {
  return {m * n[0], m * n[1], m * n[2]};
}

/// Turns axis i toward axis j.
Columns rotation(double degrees, std::size_t i, std::size_t j) {
  const Turn t = turn(degrees);
  Columns m{Exact3{1, 0, 0}, Exact3{0, 1, 0}, Exact3{0, 0, 1}};
  m[i][i] = t.cosine, m[i][j] = t.sine;
  m[j][i] = -t.sine, m[j][j] = t.cosine;
  return m;
}

} // namespace

/// A corner, or a point where an edge is cut.
struct ExactGeometry::Corner {
  Double4 clip{};   // of a corner: as the vertex stage has it
  Exact3 window;    // homogeneous point in pixels, y down
  Exact factor = 1; // from there to clip coordinates
  Exact3 position, normal;
  Exact u = 0, v = 0;
  bool behind_eye = false;
};

namespace {

/// The point of a plane triangle that is seen at a pixel's centre. p = sum of lambda_k window_k; the corners' shares,
/// perspective-correct, are in the proportion of lambda_k factor_k.
template <class Corner>
class Sight {
public:
  Sight(const std::array<const Corner*, 3>& corners, int x, int y) : corners_(corners) {
    const Exact3 p{x + Exact(0.5), y + Exact(0.5), 1};
    for (std::size_t k = 0; k < 3; ++k) {
      const Exact3 line = cross(corners[(k + 1) % 3]->window, corners[(k + 2) % 3]->window);
      const Exact determinant = dot(corners[k]->window, line); // the same for all k; its sign is the triangle's facing
      const Exact scale = determinant == 0 ? Exact(0) : corners[k]->factor / determinant;
      share_[k] = dot(line, p) * scale;
      right_[k] = line.x * scale, down_[k] = line.y * scale;
      inside_ = inside_ && share_[k] >= 0;
      sum_ += share_[k], sum_right_ += right_[k], sum_down_ += down_[k];
    }
  }

  bool hits() const { return inside_ && sum_ > 0; }

  std::optional<SurfacePoint> point() const {
    SurfacePoint point;
    Exact3 normal;
    for (std::size_t k = 0; k < 3; ++k) {
      point.position = point.position + corners_[k]->position * (share_[k] / sum_);
      normal = normal + corners_[k]->normal * (share_[k] / sum_);
    }
    if (dot(normal, normal) == 0) return std::nullopt;
    point.normal = unit(normal);
    interpolate(&Corner::u, point.u, point.u_right, point.u_down);
    interpolate(&Corner::v, point.v, point.v_right, point.v_down);
    return point;
  }

private:
  void interpolate(Exact Corner::*value, Exact& at, Exact& by_right, Exact& by_down) const {
    Exact step_right = 0, step_down = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      at += corners_[k]->*value * share_[k] / sum_;
      step_right += corners_[k]->*value * right_[k], step_down += corners_[k]->*value * down_[k];
    }
    by_right = (step_right - at * sum_right_) / sum_; // (f / g)' = (f' - (f / g) g') / g
    by_down = (step_down - at * sum_down_) / sum_;
  }

  std::array<const Corner*, 3> corners_;
  std::array<Exact, 3> share_, right_, down_;
  Exact sum_ = 0, sum_right_ = 0, sum_down_ = 0;
  bool inside_ = true;
};

} // namespace

ExactGeometry::Model ExactGeometry::model_of(const Object& object) const {
  const Double3& r = object.rotate_degrees;
  const Exact3 scale = exact(object.scale);
  Model model;
  model.axes = rotation(r.x, 1, 2) * rotation(r.y, 2, 0) * rotation(r.z, 0, 1);
  for (std::size_t i = 0; i < 3; ++i) model.axes[i] = model.axes[i] * scale[i];
  const auto& [x, y, z] = model.axes;
  const Exact3 yz = cross(y, z);
  const Exact sign = dot(x, yz) < 0 ? -1 : 1;
  model.normals = {yz * sign, cross(z, x) * sign, cross(x, y) * sign};
  model.in_double = object_transform(object, clip_from_world(scene_.camera, static_cast<double>(width_) / height_));
  return model;
}

ExactGeometry::ExactGeometry(const Scene& scene, int width, int height)
    : scene_(scene), width_(width), height_(height), eye_(exact(scene.camera.position)),
      back_(unit(eye_ - exact(scene.camera.target))) {
  for (const Object& object : scene.objects) models_.push_back(model_of(object));
}

Exact3 ExactGeometry::window_point(const Exact& x, const Exact& y, const Exact& w) const {
  return {(x + w) * width_ / 2, (w - y) * height_ / 2, w};
}

std::optional<ExactGeometry::Corner> ExactGeometry::corner(const Place& place, std::size_t k) const {
  const Object& object = scene_.objects[place.object];
  const Model& model = models_[place.object];
  const Mesh& mesh = *object.mesh;
  const std::uint32_t index = mesh.triangles[place.triangle][k];
  Corner corner;
  corner.clip = clip_position(model.in_double, mesh.positions[index]);
  const WindowVertex vertex = window_vertex(corner.clip, width_, height_);
  if ((vertex.outcode & outcode::not_finite) != 0) return std::nullopt;
  corner.position = model.axes * exact(mesh.positions[index]) + exact(object.position);
  corner.normal = model.normals * exact(mesh.normals[index]);
  if (index < mesh.uvs.size()) corner.u = Exact(mesh.uvs[index].x), corner.v = Exact(mesh.uvs[index].y);
  if ((vertex.outcode & outcode::unsnapped) != 0) {
    corner.window = window_point(Exact(corner.clip.x), Exact(corner.clip.y), Exact(corner.clip.w));
    corner.behind_eye = corner.clip.w <= 0;
  } else {
    corner.window = {Exact(vertex.x) / subpixels, Exact(vertex.y) / subpixels, 1};
    corner.factor = 1 / dot(eye_ - corner.position, back_); // w, not as it was rounded
  }
  return corner;
}

/// Where the edge from a corner in front of the eye to one behind ends: at half the distance of the near plane, or of
/// the corner, should that be nearer.
ExactGeometry::Corner ExactGeometry::between(const Corner& front, const Corner& back) const {
  const Exact front_w(front.clip.w), w = std::min(Exact(scene_.camera.near), front_w) / 2;
  const Exact t = (front_w - w) / (front_w - Exact(back.clip.w)), s = 1 - t;
  Corner cut;
  cut.window = window_point(front.clip.x * s + back.clip.x * t, front.clip.y * s + back.clip.y * t, w);
  cut.position = front.position * s + back.position * t;
  cut.normal = front.normal * s + back.normal * t;
  cut.u = front.u * s + back.u * t, cut.v = front.v * s + back.v * t;
  return cut;
}

/// A polygon of 0, 3 or 4 corners, beginning with the least by its place.
std::vector<ExactGeometry::Corner> ExactGeometry::in_front(const std::array<Corner, 3>& corners) const {
  std::array<const Corner*, 3> c = {&corners[0], &corners[1], &corners[2]};
  std::sort(c.begin(), c.end(), [](const Corner* a, const Corner* b) {
    return std::tie(a->clip.x, a->clip.y, a->clip.w, a->clip.z) < std::tie(b->clip.x, b->clip.y, b->clip.w, b->clip.z);
  });
  std::vector<Corner> polygon;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &here = *c[k], &next = *c[(k + 1) % 3];
    if (!here.behind_eye) polygon.push_back(here);
    if (here.behind_eye != next.behind_eye)
      polygon.push_back(here.behind_eye ? between(next, here) : between(here, next));
  }
  return polygon;
}

std::optional<SurfacePoint> ExactGeometry::surface_at(const Place& place) const {
  std::array<Corner, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    std::optional<Corner> made = corner(place, k);
    if (!made) return std::nullopt;
    corners[k] = std::move(*made);
  }
  const std::vector<Corner> part = in_front(corners);
  for (std::size_t k = 1; k + 1 < part.size(); ++k) {
    const Sight<Corner> sight({&part[0], &part[k], &part[k + 1]}, place.x, place.y);
    if (!sight.hits()) continue;
    std::optional<SurfacePoint> point = sight.point();
    const Mesh& mesh = *scene_.objects[place.object].mesh;
    if (point) point->has_uv = has_uvs(mesh, mesh.triangles[place.triangle]);
    return point;
  }
  return std::nullopt;
}

} // namespace refraster::oracle
