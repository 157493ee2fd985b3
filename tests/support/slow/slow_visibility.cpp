#include "tests/support/slow/slow_visibility.h"

#include "tests/support/slow/slow_shading.h"
#include "tests/support/slow/slow_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace refraster::slow {
namespace {

/// The order that makes pieces the same whatever corner of a triangle comes first.
bool before(const Corner& a, const Corner& b) {
  return std::tie(a.x, a.y, a.w, a.z) < std::tie(b.x, b.y, b.w, b.z);
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

/// What runs of the mesh say, one after the other, up to a triangle's own.
const Material& material_of_triangle(const Object& object, std::uint32_t triangle) {
  const Material* material = &object.material;
  for (const TriangleRun& run : object.mesh->material_runs)
    if (run.first_triangle <= triangle)
      material = run.material < object.materials.size() ? &object.materials[run.material] : &object.material;
  return *material;
}

/// `side`: 1, or -1 where normals are turned.
void look(const Object& object, std::uint32_t triangle, const Material& material, Real side,
          const std::array<const Corner*, 3>& c, const Planes& planes, Pixel pixel, Candidate& candidate) {
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
  seen.object = &object, seen.material = &material, seen.triangle = triangle;
  seen.position = mean([](const Corner& corner) { return corner.position; });
  const Vec normal = mean([](const Corner& corner) { return corner.normal; }) * side;
  seen.has_uv = c[0]->has_uv && c[1]->has_uv && c[2]->has_uv;
  seen.u = mean(u), seen.v = mean(v);
  seen.colour = mean([](const Corner& corner) { return corner.colour; });
  seen.tangent = mean([](const Corner& corner) { return corner.tangent; });
  seen.handedness = mean([](const Corner& corner) { return corner.handedness; });
  seen.turned = side < 0;
  seen.u_right = change(u, mu_right, sum_right), seen.v_right = change(v, mu_right, sum_right);
  seen.u_down = change(u, mu_down, sum_down), seen.v_down = change(v, mu_down, sum_down);
  if (length(normal) > 0) seen.normal = unit(normal);
  const std::optional<bool> there = is_there(seen);
  if (there == false) return;
  candidate = {depth, doubtful || !there || !(length(normal) > 0), seen};
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
    const auto draw = [&](const std::array<const Corner*, 3>& c, std::uint32_t number, const Material& material) {
      const Vec e0 = cross(c[1]->window, c[2]->window), e1 = cross(c[2]->window, c[0]->window),
                e2 = cross(c[0]->window, c[1]->window);
      const Real determinant = dot(c[0]->window, e0);
      if (determinant == 0) return;
      if (object.cull == Cull::back && determinant > 0) return; // clockwise in the image, with y down
      const bool mirrored = real(object.scale.x) * real(object.scale.y) * real(object.scale.z) < 0;
      const Real side = object.two_sided == TwoSided::yes && (determinant > 0) != mirrored ? -1 : 1;
      const Planes planes = {{e0 * (1 / determinant), e1 * (1 / determinant), e2 * (1 / determinant)}};
      for (std::size_t i = 0; i < pixels.size(); ++i)
        look(object, number, material, side, c, planes, pixels[i], candidates[i]);
    };
    for (std::uint32_t number = 0; number < object.mesh->triangles.size(); ++number) {
      const auto& triangle = object.mesh->triangles[number];
      const Material& material = material_of_triangle(object, number);
      const std::array<const Corner*, 3> c = {&corners[triangle[0]], &corners[triangle[1]], &corners[triangle[2]]};
      if (c[0]->w > 0 && c[1]->w > 0 && c[2]->w > 0) {
        draw(c, number, material);
        continue;
      }
      const std::vector<Corner> part = part_in_front(c, viewer);
      for (std::size_t k = 1; k + 1 < part.size(); ++k) draw({&part[0], &part[k], &part[k + 1]}, number, material);
    }
  }
  std::vector<std::optional<Seen>> result;
  for (const Candidate& candidate : candidates)
    result.push_back(candidate.doubtful ? std::nullopt : std::optional(candidate.seen));
  return result;
}

} // namespace refraster::slow
