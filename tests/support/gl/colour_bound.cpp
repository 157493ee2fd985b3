#include "tests/support/gl/colour_bound.h"

#include "tests/support/gl/ideal_shader.h"
#include "tests/support/gl/window_triangle.h"

#include <limits>
#include <numbers>

namespace refraster {
namespace {

constexpr double u = float_rounding;
constexpr double infinite = std::numeric_limits<double>::infinity();

Double3 absolute(const Double3& a) {
  return {std::abs(a.x), std::abs(a.y), std::abs(a.z)};
}
Double3 larger(const Double3& a, const Double3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
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
  RenderOptions options;
  options.width = width, options.height = height, options.threads = 1;
  transform({scene, options}, geometry_);
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
    if (indices[i] < mesh.uvs.size()) corner.uv = Double2(mesh.uvs[indices[i]]);
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
  PixelBound(const IdealShader& shader, const DriverTolerances& driver, const Plane& inverse_w,
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

  AllowedColour allowed(std::size_t lights, BoundPart part) const {
    if (part == BoundPart::least) return {exact_, by_shift(1) + by_texel() + by_arithmetic(lights), {}};
    const std::pair<std::string_view, Double3> causes[] = {
        {"corners on a lattice", by_shift(4)}, {"interpolation", by_attributes() + by_uv()},
        {"texel filter", by_texel()},          {"level of detail", by_detail()},
        {"table point", by_table()},           {"arithmetic", by_arithmetic(lights)}};
    AllowedColour sum{exact_, Double3(0), {}};
    double most = -1;
    for (const auto& [name, moved] : causes) {
      sum.either_way += moved;
      if (const double size = std::max({moved.x, moved.y, moved.z}); size > most) most = size, sum.main_cause = name;
    }
    return sum;
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
  Double3 change(const IdealShader& shader, const Varyings& at) const { return absolute(shader.colour(at) - exact_); }

  /// Corners that are snapped here and rounded there: the same as another sample nearby. Looked at in so many steps
  /// across the box, since a highlight's edge or a light's horizon may run through it.
  Double3 by_shift(int steps) const {
    const auto along = [&](int i) { return (2.0 * i / steps - 1) * shift_; };
    // Where a colour jumps at a horizon just beyond the exact point, the largest colour is at the jump, between two
    // steps: so also as if it went on without one.
    IdealShader opened = shader_;
    if (shader_.jumps()) opened.below_horizon = cosine_reach();
    const bool at_horizon = shader_.jumps() && change(opened, here_) != Double3(0);
    Double3 most(0);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; j <= steps; ++j) {
        const Varyings there = shifted(along(i), along(j));
        most = larger(most, change(shader_, there));
        if (at_horizon) most = larger(most, change(opened, there));
      }
    return most;
  }

  /// How far the shift may move a cosine between the normal and the eye or a light.
  double cosine_reach() const {
    const Fragment<double> here = shader_.fragment(here_);
    double most = 0;
    both_ways(shift_, [&](double dx) {
      both_ways(shift_, [&](double dy) {
        const Fragment<double> there = shader_.fragment(shifted(dx, dy));
        double turned = length(there.to_eye - here.to_eye);
        for_each_light_list(shader_.scene, [&](const auto& lights) {
          for (const auto& light : lights)
            turned = std::max(turned, length(arriving(light, there).direction - arriving(light, here).direction));
        });
        most = std::max(most, length(there.normal - here.normal) + turned);
      });
    });
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

  /// What a texture's filter makes of the texels.
  Double3 by_texel() const {
    Double3 most(0);
    if (!shader_.material.texture) return most;
    both_ways(driver_.texel_error + 4 * u, [&](double e) {
      IdealShader moved = shader_;
      moved.texture_moved = Double3(e);
      most = larger(most, change(moved, here_));
    });
    return most;
  }

  /// Where a texture is read.
  Double3 by_uv() const {
    Double3 most(0);
    if (!shader_.material.texture) return most;
    both_ways(error_.uv.x, [&](double e_u) {
      both_ways(error_.uv.y, [&](double e_v) {
        Varyings there = here_;
        there.uv += Double2(e_u, e_v);
        most = larger(most, change(shader_, there));
      });
    });
    return most;
  }

  /// The level of detail. Derivatives may be differences between any neighbours of the pixel's 2 x 2 block, and one for
  /// the whole block. Looked at in the corners of the box of by_shift too, where other texels are near.
  static constexpr int detail_steps = 10;
  Double3 by_detail() const {
    Double3 most(0);
    if (!shader_.material.texture || shader_.material.texture_filter != TextureFilter::trilinear) return most;
    for (const auto& [dx, dy] : {Double2(0, 0), Double2(-1, -1), Double2(-1, 1), Double2(1, -1), Double2(1, 1)}) {
      const Varyings at = shifted(dx * shift_, dy * shift_);
      const Rgb<double> ideal = shader_.colour(at);
      for (const int row : {0, 1})
        for (const int column : {0, 1})
          for (int k = 0; k <= detail_steps; ++k) // a colour may rise and fall along a mip chain
            most = larger(most, absolute(with_detail(row, column, k).colour(at) - ideal));
    }
    return most;
  }

  /// With the differences along this row and column of the block, and a level of detail between the least (k = 0) and
  /// the most (k = detail_steps) that the driver may take.
  IdealShader with_detail(int row, int column, int k) const {
    const double moved =
        std::exp2(std::lerp(-driver_.detail_below - snapped_detail_, driver_.detail_above + snapped_detail_,
                            k / static_cast<double>(detail_steps)));
    const auto step = [&](const Double2& from, const Double2& to) { // each of the two values is off by its error
      const auto along = [&](int c) {
        return std::max(std::abs(to[c] - from[c]) + (4.0 * k / detail_steps - 2) * error_.uv[c], 0.0) * moved;
      };
      return Double2(along(0), along(1));
    };
    const auto uv = [&](int x, int y) { return shifted(x - place_in_block_[0], y - place_in_block_[1]).uv; };
    IdealShader shader = shader_;
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
        IdealShader moved = shader_;
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

  IdealShader shader_;
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

AllowedColour ColourBound::at(std::size_t object, std::uint32_t triangle, int pixel_x, int pixel_y,
                              BoundPart part) const {
  const AllowedColour anything{Double3(0), Double3(infinite), "no float can tell"};
  const Setup setup = set_up(object, triangle);
  if (setup.planes.flat) return anything;
  const double x = pixel_x + 0.5, y = pixel_y + 0.5;
  const Double2 reach = from_origin(pixel_x, pixel_y);

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
    return Plane{value(x, y), sum.x, sum.y,
                 driver_.plane_ulp * u * (most + std::abs(sum.x) * reach.x + std::abs(sum.y) * reach.y)};
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
  const double step = std::max(our_lattice, driver_.lattice);
  const double shift = step / 2 * snapped + (error.x + std::max(reach.x, reach.y) * error.z) * inverse_w.value;
  // Snapping moves two corners against each other by up to a step both ways: along an altitude so much of every
  // derivative, in levels.
  double altitude = infinite;
  for (std::size_t i = 0; i < 3; ++i)
    if (setup.w_clip[i] > 0)
      altitude = std::min(altitude, 1 / setup.w_clip[i] / std::hypot(setup.planes.l[i].x, setup.planes.l[i].y));
  const double snapped_detail = std::log2(1 + std::numbers::sqrt2 * step / altitude);

  const Mesh& mesh = *scene_.objects[object].mesh;
  Material material = scene_.objects[object].material;
  if (!has_uvs(mesh, mesh.triangles[triangle])) material.texture = nullptr;
  const IdealShader shader{scene_, material, Double2(0), Double2(0)};
  // Blocks of 2 x 2 pixels begin at OpenGL's row 0, the lowest: in an image of odd height they begin at our odd rows.
  const std::array<int, 2> place_in_block = {pixel_x & 1, (height_ - pixel_y) & 1};
  const PixelBound pixel(shader, driver_, inverse_w, planes, setup.corner_error, shift, place_in_block, snapped_detail);
  return pixel.allowed(light_count(scene_), part);
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
  const Double2 reach = from_origin(pixel_x, pixel_y);
  Double3 z(0), h(0);
  for (std::size_t i = 0; i < 3; ++i) z += setup.planes.l[i] * setup.z_clip[i], h += setup.planes.l[i];
  const double w = 1 / (h.x * x + h.y * y + h.z);
  const double shift =
      rounded_apart(driver_) + (setup.homogeneous_error.x + std::max(reach.x, reach.y) * setup.homogeneous_error.z) / w;
  // z lies in [0, 1] on the screen, and its plane is anchored at the origin like any other.
  const double corner_error = (setup.homogeneous_error.y + setup.homogeneous_error.z) / w;
  return 0.5 * (corner_error + driver_.plane_ulp * u * (1 + std::abs(z.x) * reach.x + std::abs(z.y) * reach.y) +
                shift * (std::abs(z.x) + std::abs(z.y)));
}

} // namespace refraster
