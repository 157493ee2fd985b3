#include "tests/gl/colour_bound.h"

#include "raster/shade_packet.h"
#include "tests/gl/window_triangle.h"

#include <limits>
#include <numbers>

namespace refraster {
namespace {

constexpr double u = 0x1p-24; // half a unit in the last place of a float at 1
constexpr double infinite = std::numeric_limits<double>::infinity();

Double3 absolute(const Double3& a) {
  return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
Double3 larger(const Double3& a, const Double3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// Everything that is interpolated.
struct Varyings {
  Double3 position, normal;
  Double2 uv;
};
constexpr int varying_components = 8;

double& component(Varyings& v, int i) {
  return i < 3 ? v.position[i] : i < 6 ? v.normal[i - 3] : v.uv[i - 6];
}

/// The colour of a surface with these varyings, in double; with a measured BRDF's table point moved, in bins.
struct Shader {
  const Scene& scene;
  const Material& material;
  Double2 uv_right, uv_down; // for the level of detail
  MerlPoint<double> moved{0, 0, 0};
  Double3 texture_moved{0};

  Rgb<double> texture(const Varyings& at) const {
    if (!material.texture) return Rgb<double>(1);
    return sample(*material.texture, material.texture_filter, at.uv, uv_right, uv_down) + texture_moved;
  }

  Fragment<double> fragment(const Varyings& at) const {
    return {at.position, normalize(at.normal), normalize(scene.camera.position - at.position), texture(at)};
  }

  Rgb<double> reflected(const Merl& model, const Fragment<double>& at, const Incident<double>& light) const {
    const double n_l = dot(at.normal, light.direction);
    if (!(std::min(n_l, dot(at.normal, at.to_eye)) > 0)) return Rgb<double>(0);
    MerlPoint<double> point = merl_point(half_difference(model.angles, at.normal, light.direction, at.to_eye));
    point.u = std::max(point.u + moved.u, 0.0), point.v += moved.v, point.w += moved.w;
    return merl_value(*model.table, model.lookup, point).f * n_l * light.radiance;
  }
  template <class Model>
  Rgb<double> reflected(const Model& model, const Fragment<double>& at, const Incident<double>& light) const {
    return model(at, light);
  }

  template <class Model>
  Rgb<double> colour(const Model& model, const Varyings& at) const {
    const Fragment<double> here = fragment(at);
    Rgb<double> sum = model.ambient(here);
    for (const PointLight& light : scene.point_lights) sum += reflected(model, here, arriving(light, here));
    for (const DirectionLight& light : scene.direction_lights) sum += reflected(model, here, arriving(light, here));
    return sum;
  }
  Rgb<double> colour(const Varyings& at) const {
    return std::visit([&](const auto& model) { return colour(model, at); }, material.model);
  }
};

/// The share of a colour that comes from highlights, and their exponent.
std::pair<Rgb<double>, double> highlights(const Shader& shader, const Varyings& at) {
  return std::visit(
      [&](const auto& model) -> std::pair<Rgb<double>, double> {
        if constexpr (requires { model.ks; }) {
          auto dull = model;
          dull.ks = Double3(0);
          return {shader.colour(model, at) - shader.colour(dull, at), model.glossiness};
        }
        return {Rgb<double>(0), 0};
      },
      shader.material.model);
}

/// How far float angles may move the point of the table, in bins.
MerlPoint<double> table_error(const Shader& shader, const Varyings& at, double atan_ulp) {
  const Merl* const model = std::get_if<Merl>(&shader.material.model);
  MerlPoint<double> most{0, 0, 0};
  if (!model) return most;
  const Fragment<double> here = shader.fragment(at);
  const auto see = [&](const Incident<double>& light) {
    const Double3 n = here.normal, i = light.direction, o = here.to_eye;
    const HalfDifference<double> angles = half_difference(model->angles, n, i, o);
    constexpr double bins_per_radian = 180 / std::numbers::pi;
    const double s = length(i + o), d = length(i - o);
    const double theta_h_error = atan_ulp * u * angles.theta_h + 8 * u;
    const double highest = 90 * std::sqrt((angles.theta_h + theta_h_error) * 2 / std::numbers::pi);
    most.u = std::max(most.u,
                      highest - 90 * std::sqrt(std::max(angles.theta_h - theta_h_error, 0.0) * 2 / std::numbers::pi));
    most.v = std::max(most.v, bins_per_radian * (atan_ulp * u * angles.theta_d + 8 * u));
    const double azimuth = length(Double3(s * dot(n, i - o), 2 * dot(n, cross(i, o)), 0));
    const double turn =
        azimuth > 0 ? std::min(16 * u * s * std::max(d, 4 * u) / azimuth, std::numbers::pi / 2) : std::numbers::pi / 2;
    most.w = std::max(most.w, bins_per_radian * (atan_ulp * u * angles.phi_d + 4 * u + turn));
  };
  for (const PointLight& light : shader.scene.point_lights) see(arriving(light, here));
  for (const DirectionLight& light : shader.scene.direction_lights) see(arriving(light, here));
  return most;
}

} // namespace

/// A triangle's planes, and how far a float vertex stage may be off.
struct ColourBound::Setup {
  WindowTriangle planes;
  std::array<double, 3> z_clip{}, w_clip{};
  std::array<Varyings, 3> corner;
  Double3 homogeneous_error{0}; // of x w or y w, in pixels; of z in clip space; and of w
  Varyings corner_error;        // of what a float vertex stage makes of each attribute
  bool clipped = false;
};

ColourBound::ColourBound(const Scene& scene, int width, int height, const DriverTolerances& driver)
    : scene_(scene), width_(width), height_(height), driver_(driver) {
  transform(scene, width, height, 1, geometry_);
}

ColourBound::Setup ColourBound::set_up(std::size_t object, std::uint32_t triangle) const {
  const TriangleRef place = ref(object, triangle);
  const Mesh& mesh = *scene_.objects[object].mesh;
  const ObjectTransform& matrices = geometry_.transforms[object];
  const auto& indices = mesh.triangles[triangle];
  std::array<Double3, 3> homogeneous;
  Setup setup{WindowTriangle({Double3(1, 0, 0), Double3(0, 1, 0), Double3(0, 0, 1)}), {}, {}, {}, {}, {}};
  Varyings& error = setup.corner_error;
  for (std::size_t i = 0; i < 3; ++i) {
    const Float3 p = mesh.positions[indices[i]], n = mesh.normals[indices[i]];
    const Double4 clip = clip_position(matrices, p);
    homogeneous[i] = {(clip.x + clip.w) / 2 * width_, (clip.w - clip.y) / 2 * height_, clip.w};
    setup.z_clip[i] = clip.z, setup.w_clip[i] = clip.w;
    // Five roundings: of the matrix, of the product, of three sums.
    const auto product_error = [&](const auto& matrix, int row, const auto& v, int columns, double last) {
      double sum = last;
      for (int c = 0; c < columns; ++c) sum += std::abs(matrix[c][row] * static_cast<double>(v[c]));
      return 5 * u * sum;
    };
    const auto clip_error = [&](int row) {
      return product_error(matrices.clip_from_object, row, p, 3, std::abs(matrices.clip_from_object[3][row]));
    };
    const double x = clip_error(0), y = clip_error(1), w = clip_error(3);
    const double half = std::max(width_, height_) / 2.0;
    // And three more for the division and the viewport, of coordinates up to the size of the image.
    setup.homogeneous_error.x =
        std::max(setup.homogeneous_error.x, half * (std::max(x, y) + w) + 6 * u * half * std::abs(clip.w));
    setup.homogeneous_error.y = std::max(setup.homogeneous_error.y, clip_error(2));
    setup.homogeneous_error.z = std::max(setup.homogeneous_error.z, w);
    const auto v = place.vertex[i];
    setup.clipped |= (geometry_.window[v].outcode != 0);
    Varyings& corner = setup.corner[i];
    corner = {geometry_.world[v].position, geometry_.world[v].normal, Double2(0)};
    if (!mesh.uvs.empty()) corner.uv = Double2(mesh.uvs[indices[i]]);
    for (int row = 0; row < 3; ++row) {
      error.position[row] = std::max(error.position[row], product_error(matrices.world_from_object, row, p, 3,
                                                                        std::abs(matrices.world_from_object[3][row])));
      error.normal[row] = std::max(error.normal[row], product_error(matrices.world_from_normal, row, n, 3, 0));
    }
  }
  setup.planes = WindowTriangle(homogeneous);
  return setup;
}

namespace {

/// A plane over the window, of f / w or of 1 / w, and how far off a driver's float may have it at the pixel.
struct Plane {
  double value, along_x, along_y, error; // at the pixel's centre; by pixel
};

/// Calls visit(-x), visit(x).
template <class Visit>
void both_ways(double x, Visit&& visit) {
  visit(-x);
  visit(x);
}

/// One pixel of one triangle: what changes its colour, cause by cause. To first order the bound is their sum.
class PixelBound {
public:
  PixelBound(const Shader& shader, const DriverTolerances& driver, const Plane& inverse_w,
             const std::array<Plane, varying_components>& planes, const Varyings& corner_error, double shift,
             const std::array<int, 2>& place_in_block, double snapped_detail)
      : shader_(shader), driver_(driver), h_(inverse_w), planes_(planes), shift_(shift),
        place_in_block_(place_in_block), snapped_detail_(snapped_detail), here_(shifted(0, 0)) {
    const double w = 1 / h_.value;
    Varyings corner = corner_error;
    const auto derivative = [&](int c, double Plane::*along) { // of f = g / h: (g_x - f h_x) / h
      return (planes_[static_cast<std::size_t>(c)].*along - component(here_, c) * h_.*along) * w;
    };
    for (int c = 0; c < varying_components; ++c) {
      const double f = component(here_, c), e = planes_[static_cast<std::size_t>(c)].error;
      component(error_, c) =
          (e + std::abs(f) * h_.error) / (h_.value - h_.error) + 3.5 * u * std::abs(f) + component(corner, c);
    }
    shader_.uv_right = {derivative(6, &Plane::along_x), derivative(7, &Plane::along_x)};
    shader_.uv_down = {derivative(6, &Plane::along_y), derivative(7, &Plane::along_y)};
    exact_ = shader_.colour(here_);
  }

  AllowedColour allowed(std::size_t lights) const {
    return {exact_, by_shift() + by_attributes() + by_texture() + by_table() + by_arithmetic(lights)};
  }

private:
  Varyings shifted(double dx, double dy) const {
    Varyings result{};
    const double h = h_.value + h_.along_x * dx + h_.along_y * dy;
    for (int c = 0; c < varying_components; ++c) {
      const Plane& g = planes_[static_cast<std::size_t>(c)];
      component(result, c) = (g.value + g.along_x * dx + g.along_y * dy) / h;
    }
    return result;
  }
  Double3 change(const Shader& shader, const Varyings& at) const { return absolute(shader.colour(at) - exact_); }

  /// Corners that are snapped here and rounded there: the same as another sample nearby. Not at the corners of the box
  /// alone: a highlight's edge or a light's horizon may run through it.
  Double3 by_shift() const {
    Double3 most(0);
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j) most = larger(most, change(shader_, shifted(i * shift_ / 2, j * shift_ / 2)));
    return most;
  }

  /// Interpolated positions and normals.
  Double3 by_attributes() const {
    Double3 sum(0);
    for (int c = 0; c < 6; ++c) {
      Double3 most(0);
      Varyings error = error_;
      both_ways(component(error, c), [&](double e) {
        Varyings there = here_;
        component(there, c) += e;
        most = larger(most, change(shader_, there));
      });
      sum += most;
    }
    return sum;
  }

  Double3 by_texture() const {
    if (!shader_.material.texture) return Double3(0);
    Double3 by_uv(0), by_texel(0);
    both_ways(error_.uv.x, [&](double e_u) {
      both_ways(error_.uv.y, [&](double e_v) {
        Varyings there = here_;
        there.uv += Double2(e_u, e_v);
        by_uv = larger(by_uv, change(shader_, there));
      });
    });
    both_ways(driver_.texel_error + 4 * u, [&](double e) {
      Shader moved = shader_;
      moved.texture_moved = Double3(e);
      by_texel = larger(by_texel, change(moved, here_));
    });
    return by_uv + by_texel + by_detail();
  }

  /// The level of detail. Derivatives may be differences between any neighbours of the pixel's 2 x 2 block, and one for
  /// the whole block. Looked at in the corners of the box of by_shift too, where other texels are near.
  Double3 by_detail() const {
    Double3 most(0);
    if (shader_.material.texture_filter != TextureFilter::trilinear) return most;
    for (const auto& [dx, dy] : {Double2(0, 0), Double2(-1, -1), Double2(-1, 1), Double2(1, -1), Double2(1, 1)}) {
      const Varyings at = shifted(dx * shift_, dy * shift_);
      const Rgb<double> ideal = shader_.colour(at);
      for (const int row : {0, 1})
        for (const int column : {0, 1})
          for (int k = 0; k <= 4; ++k) // in steps, since a colour may rise and fall along a mip chain
            most = larger(most, absolute(with_detail(row, column, k).colour(at) - ideal));
    }
    return most;
  }

  /// With the differences along this row and column of the block, and a level of detail between the least (k = 0) and
  /// the most (k = 4) that the driver may take.
  Shader with_detail(int row, int column, int k) const {
    const double moved =
        std::exp2(std::lerp(-driver_.detail_below - snapped_detail_, driver_.detail_above + snapped_detail_, k / 4.0));
    const auto step = [&](const Double2& from, const Double2& to) { // each of the two values is off by its error
      const auto along = [&](int c) {
        return std::max(std::abs(to[c] - from[c]) + (k - 2) * error_.uv[c], 0.0) * moved;
      };
      return Double2(along(0), along(1));
    };
    const auto uv = [&](int x, int y) { return shifted(x - place_in_block_[0], y - place_in_block_[1]).uv; };
    Shader shader = shader_;
    shader.uv_right = step(uv(0, row), uv(1, row));
    shader.uv_down = step(uv(column, 0), uv(column, 1));
    return shader;
  }

  /// The point at which a measured BRDF's table is read.
  Double3 by_table() const {
    const MerlPoint<double> bins = table_error(shader_, here_, driver_.atan_ulp);
    Double3 sum(0);
    for (const auto member : {&MerlPoint<double>::u, &MerlPoint<double>::v, &MerlPoint<double>::w}) {
      Double3 most(0);
      both_ways(bins.*member, [&](double e) {
        Shader moved = shader_;
        moved.moved.*member = e;
        most = larger(most, change(moved, here_));
      });
      sum += most;
    }
    return sum;
  }

  /// Float arithmetic of the formulas. All terms are positive, so errors are in proportion to the sum.
  Double3 by_arithmetic(std::size_t lights) const {
    const auto [shine, glossiness] = highlights(shader_, here_);
    return absolute(exact_) * ((40 + static_cast<double>(lights)) * u) +
           absolute(shine) * ((16 + (driver_.power_ulp + 6) * glossiness) * u);
  }

  Shader shader_;
  const DriverTolerances& driver_;
  Plane h_; // 1 / w
  std::array<Plane, varying_components> planes_;
  double shift_;                      // of the sample, in pixels, either way
  std::array<int, 2> place_in_block_; // of the pixel in its 2 x 2 block
  double snapped_detail_;             // what snapped corners change in the level of detail
  Varyings here_, error_{};
  Rgb<double> exact_;
};

} // namespace

AllowedColour ColourBound::at(std::size_t object, std::uint32_t triangle, int pixel_x, int pixel_y) const {
  const AllowedColour anything{Double3(0), Double3(infinite)};
  const Setup setup = set_up(object, triangle);
  if (setup.planes.flat) return anything;
  const double x = pixel_x + 0.5, y = pixel_y + 0.5;

  // Anchored at the framebuffer's origin: a0 + a_x x + a_y y, each of the three with errors in proportion to its size.
  const auto plane = [&](auto&& corner_value) {
    Double3 sum(0);
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += setup.planes.l[i] * corner_value(i);
      if (!setup.clipped) most = std::max(most, std::abs(corner_value(i) / setup.w_clip[i]));
    }
    const auto value = [&](double px, double py) { return sum.x * px + sum.y * py + sum.z; };
    if (setup.clipped) // cut at the borders of the window: a plane is largest at a corner of it
      for (const double px : {0.0, static_cast<double>(width_)})
        for (const double py : {0.0, static_cast<double>(height_)}) most = std::max(most, std::abs(value(px, py)));
    return Plane{value(x, y), sum.x, sum.y, driver_.plane_ulp * u * (most + std::abs(sum.x) * x + std::abs(sum.y) * y)};
  };
  const Plane inverse_w = plane([](std::size_t) { return 1.0; });
  if (!(inverse_w.value > inverse_w.error)) return anything;
  std::array<Plane, varying_components> planes{};
  for (int c = 0; c < varying_components; ++c)
    planes[static_cast<std::size_t>(c)] = plane([&](std::size_t i) {
      Varyings corner = setup.corner[i];
      return component(corner, c);
    });

  // Corners in front of the eye are snapped, each by half a lattice step at most; the sample moves by the weighted sum.
  // With a corner behind the eye the weights of the others add up to more than 1.
  double snapped = 0;
  const std::array<double, 3> weight = setup.planes.at(x, y);
  for (std::size_t i = 0; i < 3; ++i) snapped += std::max(weight[i] * setup.w_clip[i], 0.0);
  const Double3& error = setup.homogeneous_error;
  const double shift = 0.5 / 256 * snapped + (error.x + std::max(x, y) * error.z) * inverse_w.value;
  // Snapping moves two corners against each other by up to 1/256 pixel both ways: along an altitude so much of every
  // derivative, in levels.
  double altitude = infinite;
  for (std::size_t i = 0; i < 3; ++i)
    if (setup.w_clip[i] > 0)
      altitude = std::min(altitude, 1 / setup.w_clip[i] / std::hypot(setup.planes.l[i].x, setup.planes.l[i].y));
  const double snapped_detail = std::log2(1 + std::numbers::sqrt2 / 256 / altitude);

  const Shader shader{scene_, scene_.objects[object].material, Double2(0), Double2(0)};
  const PixelBound pixel(shader, driver_, inverse_w, planes, setup.corner_error, shift, {pixel_x & 1, pixel_y & 1},
                         snapped_detail);
  return pixel.allowed(scene_.point_lights.size() + scene_.direction_lights.size());
}

double ColourBound::depth(std::size_t object, std::uint32_t triangle, int x, int y) const {
  const Setup setup = set_up(object, triangle);
  const std::array<double, 3> weight = setup.planes.at(x + 0.5, y + 0.5);
  double z = 0;
  for (std::size_t i = 0; i < 3; ++i) z += weight[i] * setup.z_clip[i];
  return z * 0.5 + 0.5;
}

double ColourBound::depth_error(std::size_t object, std::uint32_t triangle, int pixel_x, int pixel_y) const {
  const Setup setup = set_up(object, triangle);
  const double x = pixel_x + 0.5, y = pixel_y + 0.5;
  Double3 z(0), h(0);
  for (std::size_t i = 0; i < 3; ++i) z += setup.planes.l[i] * setup.z_clip[i], h += setup.planes.l[i];
  const double w = 1 / (h.x * x + h.y * y + h.z);
  const double shift = 1.0 / 256 + (setup.homogeneous_error.x + std::max(x, y) * setup.homogeneous_error.z) / w;
  // z lies in [0, 1] on the screen, and its plane is anchored at the origin like any other.
  const double corner_error = (setup.homogeneous_error.y + setup.homogeneous_error.z) / w;
  return 0.5 * (corner_error + driver_.plane_ulp * u * (1 + std::abs(z.x) * x + std::abs(z.y) * y) +
                shift * (std::abs(z.x) + std::abs(z.y)));
}

} // namespace refraster
