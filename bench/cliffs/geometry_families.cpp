#include "bench/cliffs/shapes.h"

#include <algorithm>
#include <cmath>

namespace refraster::cliffs {
namespace {

std::uint32_t count(double size) {
  return static_cast<std::uint32_t>(std::lround(size));
}

/// One object in the usual scene.
Work one(Mesh mesh, int side, double layers = 1) {
  Work work{empty_scene(), square(side), layers};
  work.scene.objects = {object_of(std::move(mesh))};
  return work;
}

Work grid(double size) {
  return one(wall(size), 512);
}
Work closed_sphere(double size) {
  const int segments = static_cast<int>(std::lround(std::sqrt(size)));
  Work work = one(sphere_mesh(segments, segments / 2 + 1), 512, 2);
  work.scene.camera.position.z = 1.7;
  return work;
}
Work below_a_pixel(double size) {
  return one(wall(size), 128);
}
Work scattered_small(double size) {
  return one(scattered(count(size), 3, 512), 512, size * 3 / (512 * 512));
}
Work scattered_medium(double size) {
  return one(scattered(count(size), 20, 512), 512, size * 200 / (512 * 512));
}
Work scattered_large(double size) {
  return one(scattered(count(size), 150, 512), 512, size * 11000 / (512 * 512));
}

/// Each fills the image.
Work full(double size, double first_z, double step) {
  const auto corner = [=](std::uint32_t i, int k) {
    constexpr double x[] = {-4, 4, 0}, y[] = {-3, -3, 9};
    return Double3(x[k], y[k], first_z + step * i);
  };
  return one(soup(count(size), corner), 512, size);
}
Work full_back_to_front(double size) {
  return full(size, -0.5, 0.5 / size);
}
Work full_front_to_back(double size) {
  return full(size, 0, -0.5 / size);
}
Work full_in_one_plane(double size) {
  return full(size, 0, 0);
}

/// Needles of that length in pixels, at any angle or at one.
Work needles(double size, double pixels, double width, double angle = -1) {
  Numbers numbers;
  Double3 middle;
  double turn = 0;
  const double half = pixels / 512, thin = width / 512;
  const auto corner = [&](std::uint32_t, int k) {
    if (k == 0) middle = numbers.between({-0.9, -0.9, -0.2}, {0.9, 0.9, 0}), turn = numbers.between(0, 6.28);
    const double a = angle < 0 ? turn : angle, along = k == 0 ? -half : half, across = k == 2 ? thin : 0;
    return middle + Double3(std::cos(a) * along - std::sin(a) * across, std::sin(a) * along + std::cos(a) * across, 0);
  };
  return one(soup(count(size), corner), 512, size * pixels * width / 2 / (512 * 512));
}
Work thin_needles(double size) {
  return needles(size, 200, 0.2);
}
Work thick_needles(double size) {
  return needles(size, 200, 2);
}
Work lying_strips(double size) {
  return needles(size, 400, 1, 0);
}
Work standing_strips(double size) {
  return needles(size, 400, 1, 1.5707963);
}

Work without_area(double size) {
  Numbers numbers;
  Double3 a, b;
  return one(soup(count(size),
                  [&](std::uint32_t, int k) {
                    if (k == 0)
                      a = numbers.between({-1, -1, 0}, {1, 1, 0}), b = numbers.between({-1, -1, 0}, {1, 1, 0});
                    return k == 0 ? a : k == 1 ? b : (a + b) * 0.5;
                  }),
             512, 0);
}
Work in_one_point(double size) {
  return one(soup(count(size), [](std::uint32_t, int) { return Double3(0.1, 0.2, 0); }), 512, 0);
}

Work moved(double size, const Double3& by) {
  Work work = one(scattered(count(size), 10, 512), 512, 0);
  work.scene.objects[0].position = by;
  return work;
}
Work beside_the_image(double size) {
  return moved(size, {5, 0, 0});
}
Work behind_the_eye(double size) {
  return moved(size, {0, 0, 3});
}
Work beyond_the_far_plane(double size) {
  return moved(size, {0, 0, -200});
}
Work culled(double size) {
  Work work = one(scattered(count(size), 10, 512), 512, 0);
  work.scene.objects[0].cull = Cull::back;
  work.scene.objects[0].scale = {-1, 1, 1};
  return work;
}
Work across_the_edge(double size) {
  Work work = one(scattered(count(size), 10, 512), 512, size * 50 / (512 * 512));
  work.scene.objects[0].position = {1, 0, 0};
  return work;
}

/// From before the eye to behind it.
Work through_the_eye(double size, int side, double width) {
  Numbers numbers;
  Double3 from;
  return one(soup(count(size),
                  [&](std::uint32_t, int k) {
                    if (k == 0) from = numbers.between({-3, -3, -3}, {3, 3, 0});
                    return k == 2 ? Double3(from.x * 0.5, from.y * 0.5, 4) : from + Double3(k * width, 0, 0);
                  }),
             side, size * width * 0.02);
}
Work through_the_eye_small(double size) {
  return through_the_eye(size, 64, 0.05);
}
Work through_the_eye_wide(double size) {
  return through_the_eye(size, 512, 0.5);
}
Work through_the_near_plane(double size) {
  Work work = one(scattered(count(size), 20, 512), 512, size * 200 / (512 * 512));
  work.scene.camera.near = 1.2;
  return work;
}
Work far_beyond_the_image(double size) {
  Numbers numbers;
  double turn = 0;
  return one(soup(count(size),
                  [&](std::uint32_t, int k) {
                    if (k == 0) turn = numbers.between(0, 6.28);
                    const double a = turn + 0.001 * k;
                    return k == 0 ? Double3(0.01, 0, 0) : Double3(1e5 * std::cos(a), 1e5 * std::sin(a), 0);
                  }),
             512, size * 0.0002);
}

Work crossing_each_other(double size) {
  Numbers numbers;
  Double3 middle;
  return one(soup(count(size),
                  [&](std::uint32_t, int k) {
                    if (k == 0) middle = numbers.between({-0.8, -0.8, -0.1}, {0.8, 0.8, 0});
                    return middle + numbers.between({-0.2, -0.2, -0.2}, {0.2, 0.2, 0.1});
                  }),
             512, size * 0.01);
}
Work fan(double size) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  const std::uint32_t triangles = count(size);
  for (std::uint32_t i = 0; i <= triangles; ++i) {
    const double a = 6.283185 * i / triangles;
    mesh.positions.emplace_back(static_cast<float>(0.95 * std::cos(a)), static_cast<float>(0.95 * std::sin(a)), 0.0f);
    if (i > 0) mesh.triangles.push_back({0, i, i + 1});
  }
  mesh.normals.assign(mesh.positions.size(), Float3(0, 0, 1));
  return one(std::move(mesh), 512);
}
Work at_corners_of_tiles(double size) {
  Numbers numbers;
  Double3 middle;
  return one(soup(count(size),
                  [&](std::uint32_t, int k) {
                    constexpr double x[] = {-3, 3, 0}, y[] = {-3, -3, 3}; // pixels
                    const auto tile = [&] { return 64 * std::floor(numbers.between(1, 8)) / 256 - 1; };
                    if (k == 0) middle.x = tile(), middle.y = tile(), middle.z = numbers.between(-0.01, 0);
                    return middle + Double3(x[k] / 256, y[k] / 256, 0);
                  }),
             512, size * 18 / (512 * 512));
}

/// Cubes all over the image, in one mesh each or of one mesh all.
Work cubes(double size, const Double3& place) {
  Work work{empty_scene(), square(512), size * 0.0002};
  const auto cube = std::make_shared<const Mesh>(cube_mesh());
  Numbers numbers;
  for (std::uint32_t i = 0; i < count(size); ++i) {
    Object object = object_of(cube);
    object.position = place + numbers.between({-1, -1, -1}, {1, 1, 0});
    object.scale = Double3(0.01);
    work.scene.objects.push_back(std::move(object));
  }
  return work;
}
Work many_cubes(double size) {
  return cubes(size, {0, 0, 0});
}
Work many_cubes_outside(double size) {
  return cubes(size, {6, 0, 0});
}
Work many_of_one_mesh(double size) {
  Work work = cubes(size, {0, 0, 0});
  const auto ball = std::make_shared<const Mesh>(sphere_mesh(64, 32));
  for (Object& object : work.scene.objects) object.mesh = ball;
  return work;
}
Work a_material_each(double size) {
  Work work = one(wall(size), 512);
  Object& object = work.scene.objects[0];
  object.materials.assign(2, object.material);
  std::get<BlinnPhong>(object.materials[1].fragment_function).kd = {0.2, 0.3, 0.6};
  change_mesh(work, [](Mesh& mesh) {
    mesh.materials.resize(2), mesh.materials[0].name = "a", mesh.materials[1].name = "b";
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) mesh.material_runs.push_back({i, i % 2});
  });
  return work;
}
Work unused_vertices(double size) {
  Work work = one(wall(200), 512);
  change_mesh(work, [&](Mesh& mesh) {
    mesh.positions.resize(mesh.positions.size() + static_cast<std::size_t>(size), Float3(9, 9, 9));
    mesh.normals.resize(mesh.positions.size(), Float3(0, 0, 1)), mesh.uvs.clear();
  });
  return work;
}

// Why some cost more than ten times the ordinary: docs/performance.md, "Cliffs", has their profiles.
constexpr std::string_view long_and_thin = "long and thin: rows and tiles that are crossed, not pixels",
                           through_the_eye_plane = "the eye plane: exact integers of hundreds of bits",
                           one_depth = "one depth: nothing hides what is as near";

constexpr Family families[] = {
    {"a wall of more and more triangles", Grows::triangles, 250'000, grid},
    {"a closed sphere", Grows::triangles, 100'000, closed_sphere},
    {"triangles far below a pixel", Grows::triangles, 250'000, below_a_pixel},
    {"scattered triangles of 3 pixels", Grows::triangles, 100'000, scattered_small},
    {"scattered triangles of 20 pixels", Grows::triangles, 20'000, scattered_medium},
    {"scattered triangles of 150 pixels", Grows::triangles, 2'000, scattered_large},
    {"triangles over the whole image, back to front", Grows::triangles, 250, full_back_to_front},
    {"triangles over the whole image, front to back", Grows::triangles, 2'000, full_front_to_back},
    {"triangles over the whole image in one plane", Grows::triangles, 250, full_in_one_plane, one_depth},
    {"needles 200 pixels long, a fifth of one wide", Grows::triangles, 20'000, thin_needles, long_and_thin},
    {"needles 200 pixels long, 2 wide", Grows::triangles, 10'000, thick_needles, long_and_thin},
    {"strips a pixel wide along rows", Grows::triangles, 10'000, lying_strips},
    {"strips a pixel wide along columns", Grows::triangles, 10'000, standing_strips},
    {"triangles without area", Grows::triangles, 100'000, without_area, long_and_thin},
    {"triangles in one point", Grows::triangles, 250'000, in_one_point},
    {"triangles beside the image", Grows::triangles, 100'000, beside_the_image},
    {"triangles behind the eye", Grows::triangles, 100'000, behind_the_eye},
    {"triangles beyond the far plane", Grows::triangles, 100'000, beyond_the_far_plane},
    {"triangles that are culled", Grows::triangles, 100'000, culled},
    {"triangles across the image's edge", Grows::triangles, 100'000, across_the_edge},
    {"triangles through the eye plane, 64 x 64", Grows::triangles, 20'000, through_the_eye_small,
     through_the_eye_plane},
    {"wide triangles through the eye plane", Grows::triangles, 500, through_the_eye_wide, through_the_eye_plane},
    {"triangles through the near plane", Grows::triangles, 20'000, through_the_near_plane},
    {"triangles that reach far beyond the image", Grows::triangles, 2'000, far_beyond_the_image, long_and_thin},
    {"triangles that cross each other", Grows::triangles, 5'000, crossing_each_other},
    {"a fan round one vertex", Grows::triangles, 20'000, fan, long_and_thin},
    {"triangles at the corners of tiles", Grows::triangles, 50'000, at_corners_of_tiles},
    {"cubes, an object each", Grows::objects, 2'000, many_cubes},
    {"cubes beside the image", Grows::objects, 10'000, many_cubes_outside},
    {"spheres of one mesh", Grows::objects, 100, many_of_one_mesh},
    {"another material each triangle", Grows::triangles, 20'000, a_material_each},
    {"vertices that no triangle has", Grows::triangles, 1'000'000, unused_vertices},
};

} // namespace

std::span<const Family> geometry_families() {
  return families;
}

} // namespace refraster::cliffs
