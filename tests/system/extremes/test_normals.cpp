// The extremes (docs/extremes.md), rows N: normals and transforms.

#include <refraster/mesh.h>

#include "io/mesh/obj_file.h"
#include "raster/shade/attribute_setup.h"
#include "tests/support/for_all.h"
#include "tests/support/raster/window_scene.h"
#include "tests/system/extremes/exact_vector.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>

using namespace refraster;
using namespace refraster::test;

namespace {

/// The sine of the angle between two directions, and 2 where they point to opposite sides.
double sine_between(const ExactVec3& a, const ExactVec3& b) {
  if (inner(a, b) <= 0) return 2;
  return Mpfr(norm(outer(a, b)) / (norm(a) * norm(b))).convert_to<double>();
}

/// R n with R = Rx Ry Rz, degrees.
ExactVec3 rotated(const Double3& degrees, ExactVec3 v) {
  const Mpfr radians = boost::math::constants::pi<Mpfr>() / 180;
  const auto turn = [&](double angle, std::size_t i, std::size_t j) { // axis i toward axis j
    const Mpfr c = cos(Mpfr(angle) * radians), s = sin(Mpfr(angle) * radians);
    const Mpfr x = v[i], y = v[j];
    v[i] = c * x - s * y;
    v[j] = s * x + c * y;
  };
  turn(degrees.z, 0, 1), turn(degrees.y, 2, 0), turn(degrees.x, 1, 2);
  return v;
}

/// The direction of the inverse transpose of R S, times the normal: R S^-1 n.
ExactVec3 inverse_transpose(const Double3& degrees, const Double3& scale, const Double3& n) {
  return rotated(degrees, {Mpfr(n.x) / Mpfr(scale.x), Mpfr(n.y) / Mpfr(scale.y), Mpfr(n.z) / Mpfr(scale.z)});
}

ObjectTransform transform_of(const Double3& degrees, const Double3& scale) {
  Object object;
  object.rotate_degrees = degrees, object.scale = scale;
  return object_transform(object, Double4x4(1));
}

// In units of 2^-53, relative to the length of a column: the sines and cosines are good to 1, the product of three
// rotations to 12, a column's cross product to 2 12 + 3, and the product with a normal to 4 more. Both factors of a
// component carry its scale, so that no scale makes this worse.
constexpr double direction_bound = 32 * 0x1p-53;

void check_normals(Random& random, const Double3& scale) {
  const Double3 degrees(random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180));
  const Double3 n(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  const Double3 world = transform_of(degrees, scale).world_from_normal * n;
  CHECK(sine_between(exact(world), inverse_transpose(degrees, scale, n)) <= direction_bound);
}

// What a triangle that fills the view shows of its corners' normals: the image of normals, and the diffuse light from
// `light`.
Frame shown(const std::array<Float3, 3>& normals, const Double3& light, Precision precision) {
  WindowScene window(4);
  Object& object = window.add({window.place(-4, -4, 1), window.place(-4, 12, 1), window.place(12, -4, 1)});
  auto mesh = std::make_shared<Mesh>(*object.mesh);
  mesh->normals.assign(normals.begin(), normals.end());
  object.mesh = mesh;
  Phong matt;
  matt.ka = Double3(0), matt.kd = Double3(1), matt.ks = Double3(0);
  object.material.fragment_function = matt;
  window.scene.direction_lights.push_back({-light, Double3(1)});
  RenderOptions options = window.options({Aov::normal});
  options.precision = precision;
  return render(window.scene, options);
}

} // namespace

TEST_CASE("N1: under a scale of 1 : 1e6 a normal is turned as by the inverse transpose") {
  for_all(300, [](Random& random) {
    const double wide = random.log_uniform(1, 1e6);
    const double scales[] = {1, wide, random.log_uniform(1e-3, 1e3)};
    const int turn = random.below(3);
    check_normals(random, {scales[turn], scales[(turn + 1) % 3], scales[(turn + 2) % 3]});
  });
}

TEST_CASE("N2: under a mirrored scale a normal is turned as by the inverse transpose, and outward stays outward") {
  for_all(300, [](Random& random) {
    const auto any = [&] { return random.sign() * random.log_uniform(1e-3, 1e3); };
    check_normals(random, {any(), any(), any()});
  });
  const Mesh ball = sphere_mesh(16, 8); // at its vertices the normal is the position
  for (const Double3 mirror : {Double3(-1, 1, 1), Double3(1, -2, 3), Double3(-1, -1, -1)}) {
    const ObjectTransform t = transform_of({20, 30, 40}, mirror);
    for (const Float3& p : ball.positions)
      CHECK(dot(t.world_from_normal * Double3(p), Double3(t.world_from_object * Double4(p.x, p.y, p.z, 0))) > 0);
  }
}

TEST_CASE("N3: a flattened object has the normals of the plane it lies in; what has none is ambient only") {
  for_all(100, [](Random& random) {
    const Double3 degrees(random.uniform(-180, 180), random.uniform(-180, 180), random.uniform(-180, 180));
    const Double3 n(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    for (int axis = 0; axis < 3; ++axis) {
      Double3 scale(random.log_uniform(0.1, 10), random.log_uniform(0.1, 10), random.log_uniform(0.1, 10));
      scale[axis] = 0;
      // What S^-1 n tends to as that scale falls to 0: the axis, on the side of n.
      Double3 axis_direction(0);
      axis_direction[axis] = n[axis];
      const Double3 world = transform_of(degrees, scale).world_from_normal * n;
      CHECK(sine_between(exact(world), rotated(degrees, exact(axis_direction))) <= direction_bound);
    }
  });
  for (const Double3 scale : {Double3(0, 0, 1), Double3(1, 0, 0), Double3(0, 0, 0)}) {
    const Double3 none = transform_of({10, 20, 30}, scale).world_from_normal * Double3(1, 2, 3);
    CHECK(none == Double3(0));
    WindowScene window(32);
    Object object;
    object.mesh = std::make_shared<Mesh>(sphere_mesh(8, 4));
    object.position = {0.01, 0.02, -3};
    object.scale = scale;
    window.scene.objects.push_back(object);
    Phong lit;
    lit.ka = Double3(0.125);
    window.scene.objects.back().material.fragment_function = lit;
    window.scene.point_lights.push_back({});
    // Its triangles have no area, but for what snapping gives them: so a few samples may see it, without any normal.
    const Frame frame = window.frame({Aov::object, Aov::normal});
    CHECK(frame.counts.undefined[Undefined::no_normal] == frame.counts.fragments);
    for (int i = 0; i < 32 * 32; ++i) {
      CHECK(frame.radiance.at(i % 32, i / 32)[0] == (is_drawn(frame, i % 32, i / 32) ? 0.125f : 0));
      for (int c = 0; c < 3; ++c) CHECK(frame.aovs[1].at(i % 32, i / 32)[c] == 0);
    }
  }
  // A disc from a ball: every normal seen is the plane's.
  WindowScene window(32);
  Object disc;
  disc.mesh = std::make_shared<Mesh>(sphere_mesh(16, 8));
  disc.position = {0, 0, -3};
  disc.scale = {1, 1, 0};
  window.scene.objects.push_back(disc);
  const Frame frame = window.frame({Aov::object, Aov::normal});
  CHECK(drawn_pixels(frame) > 50);
  for (int i = 0; i < 32 * 32; ++i)
    if (is_drawn(frame, i % 32, i / 32)) {
      const float* n = frame.aovs[1].at(i % 32, i / 32);
      CHECK(n[0] == 0);
      CHECK(n[1] == 0);
      CHECK(std::abs(n[2]) == 1);
    }
}

TEST_CASE("N4: normals of any finite length give a unit vector to an ulp") {
  const Double3 light(0.48, 0.6, 0.64);
  const Float3 directions[] = {{1, 0, 0}, {0.3f, -0.5f, 0.7f}, {1e-3f, 1, 0.25f}, {-0.6f, 0.1f, 0.9f}};
  for (const float length_factor : {1.f, 1e30f, 1e-30f, 3e38f, 0x1p-126f, 0x1p-140f})
    for (const Float3& direction : directions) {
      CAPTURE(length_factor);
      const Float3 n = direction * length_factor;
      const ExactVec3 exactly = exact(Double3(n));
      for (const Precision precision : {Precision::double_, Precision::float_}) {
        CAPTURE(name_of(precision));
        const Frame frame = shown({n, n, n}, light, precision);
        Mpfr cosine = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const Mpfr expected = exactly[c] / norm(exactly);
          cosine += expected * Mpfr(light[static_cast<int>(c)]) / norm(exact(light));
          // Half an ulp is the image's. Squares and their sum are good to 4, the root and the quotient to 1 each, of
          // 2^-53.
          CHECK(abs(Mpfr(frame.aovs[0].at(1, 1)[c]) - expected) <= half_float_ulp(expected) + Mpfr(8 * 0x1p-53));
        }
        const double u = precision == Precision::float_ ? 0x1p-24 : 0x1p-53;
        // Normal and light to 8 u each, as above, and the dot product to 3.
        const Mpfr expected = cosine > 0 ? cosine : Mpfr(0);
        CHECK(abs(Mpfr(frame.radiance.at(1, 1)[0]) - expected) <= half_float_ulp(expected) + Mpfr(24 * u));
      }
    }
}

TEST_CASE("N4: lengths near the ends of float change nothing where normals differ from corner to corner") {
  const std::array<Float3, 3> normals{Float3(-1, 0.25f, 0.5f), Float3(1, 0.25f, 0.125f), Float3(0.5f, -1, 0.375f)};
  for (const Precision precision : {Precision::double_, Precision::float_}) {
    const Frame expected = shown(normals, {0.48, 0.6, 0.64}, precision);
    for (const float power : {0x1p127f, 0x1p-120f}) {
      const Frame scaled =
          shown({normals[0] * power, normals[1] * power, normals[2] * power}, {0.48, 0.6, 0.64}, precision);
      CHECK(scaled.aovs[0].values == expected.aovs[0].values);
      CHECK(scaled.radiance.values == expected.radiance.values);
    }
  }
}

TEST_CASE("N5: where normals are zero, missing or cancel, the triangle's own normal is taken, and counted") {
  for (const Precision precision : {Precision::double_, Precision::float_}) {
    const Frame zero = shown({}, {0, 0, 1}, precision);
    CHECK(zero.counts.undefined[Undefined::zero_normal] == 16);
    CHECK(zero.counts.undefined[Undefined::no_normal] == 0);
    for (int i = 0; i < 16; ++i) {
      CHECK(zero.aovs[0].at(i % 4, i / 4)[2] == 1);
      CHECK(zero.radiance.at(i % 4, i / 4)[0] == 1);
    }
  }
  // Opposite normals at two corners: they cancel half way between, at the centre (4.5, 8.5), which is on a left edge.
  // The triangle's area is a power of two, so that both shares are 1/2 without rounding.
  WindowScene window(16);
  Object& object = window.add({window.place(4.5, 4.5, 2), window.place(4.5, 12.5, 2), window.place(12.5, 4.5, 2)});
  auto mesh = std::make_shared<Mesh>(*object.mesh);
  mesh->normals = {{0.25f, 1, 0}, {-0.25f, -1, 0}, {0, 1, 0}};
  object.mesh = mesh;
  const Frame frame = window.frame({Aov::object, Aov::normal});
  REQUIRE(is_drawn(frame, 4, 8));
  CHECK(frame.counts.undefined[Undefined::zero_normal] == 1);
  CHECK(frame.aovs[1].at(4, 8)[0] == 0);
  CHECK(frame.aovs[1].at(4, 8)[1] == 0);
  CHECK(frame.aovs[1].at(4, 8)[2] == 1);
  CHECK(frame.aovs[1].at(4, 7)[1] > 0.9f);
  CHECK(frame.aovs[1].at(4, 9)[1] < -0.9f);
}

TEST_CASE("N5: where the normals of a file's faces cancel, no rounding is taken for one: each triangle has its own") {
  // Two triangles that enclose some degrees, each once each way round, on shared vertices, in one smoothing group.
  const std::string sheet = "v -1 -1 0.1\nv 1 -1 0.2\nv 1 1 0.3\nv -1 1 0.4\ns 1\nf 1 2 3\nf 1 3 4\nf 3 2 1\nf 4 3 1\n";
  WindowScene window(16);
  Object& object = window.add({});
  object.mesh = std::make_shared<const Mesh>(mesh_of_obj("sheet.obj", sheet));
  object.position = {0, 0, -0.75}; // larger than the image
  object.cull = Cull::back;
  for (const Precision precision : {Precision::double_, Precision::float_}) {
    RenderOptions options = window.options({Aov::triangle, Aov::normal});
    options.precision = precision;
    const Frame frame = render(window.scene, options);
    CHECK(frame.counts.undefined[Undefined::zero_normal] == 256);
    CHECK(frame.counts.undefined[Undefined::no_normal] == 0);
    for (int i = 0; i < 256; ++i) {
      // (2, 0, 0.1) x (2, 2, 0.2) and (2, 2, 0.2) x (0, 2, 0.3), that is.
      const bool first = frame.aovs[0].at(i % 16, i / 16)[0] == 1;
      const Double3 expected = first ? normalize(Double3(-0.2, -0.2, 4)) : normalize(Double3(0.2, -0.6, 4));
      // The corners are floats: each edge is off by 2^-25 at most.
      for (int c = 0; c < 3; ++c)
        CHECK(std::abs(static_cast<double>(frame.aovs[1].at(i % 16, i / 16)[c]) - expected[c]) <= 0x1p-23);
    }
  }
}

TEST_CASE("N6: scales of 1e20 and 1e-20 together, and up to the ends of double, cost a normal nothing") {
  for_all(200, [](Random& random) {
    const auto any = [&] {
      const double sizes[] = {1e20, 1e-20, 1, random.log_uniform(1e-20, 1e20)};
      return random.sign() * sizes[random.below(4)];
    };
    check_normals(random, {any(), any(), any()});
  });
  for_all(200, [](Random& random) {
    const double size = random.log_uniform(1e-300, 1e300); // two of them multiplied leave the range of double
    check_normals(random, {size * random.uniform(1, 2), size * random.uniform(1, 2), -size});
  });
}

TEST_CASE("N7: the normal of a needle is good to the last bits") {
  double worst = 0;
  for_all(2000, [&](Random& random) {
    auto mesh = std::make_shared<Mesh>();
    const auto any = [&] { return static_cast<float>(random.uniform(-1, 1)); };
    const Float3 a(any(), any(), any()), b(any(), any(), any());
    const double along = random.uniform(-0.5, 1.5), height = random.log_uniform(1e-7, 1);
    const Double3 c = Double3(a) + along * (Double3(b) - Double3(a)) + height * Double3(any(), any(), any());
    mesh->positions = {a, b, Float3(c)};
    mesh->normals.assign(3, Float3(0));
    mesh->triangles = {{0, 1, 2}};
    Scene scene;
    Object object;
    object.mesh = mesh;
    scene.objects.push_back(object);
    const auto corner = [&](std::size_t k) { return exact(Double3(mesh->positions[k])); };
    const auto edge = [&](std::size_t k) {
      const ExactVec3 p = corner(k), q = corner(0);
      return ExactVec3{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
    };
    const ExactVec3 exactly = outer(edge(1), edge(2));
    if (norm(exactly) == 0) return;
    Geometry geometry;
    RenderOptions options;
    options.width = options.height = 8, options.threads = 1;
    Bins bins;
    const FrameContext context{{scene, options}, geometry, bins};
    transform(context, geometry);
    const Double3 normal = face_normal(context, 0);
    const double error = sine_between(exact(normal), exactly);
    worst = std::max(worst, error);
    CHECK(error <= 4 * 0x1p-53); // the direction of three components, each rounded once, times a unit matrix
  });
  MESSAGE("largest error: " << worst / 0x1p-53 << " units of 2^-53");
}
