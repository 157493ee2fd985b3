#include "tests/support/scenes/hashed_scenes.h"

#include <refraster/mesh.h>

#include "scenes/synthesis/merl_synthesis.h"
#include "tests/support/random.h"

#include <cstdint>
#include <limits>

namespace refraster::test {

namespace {

/// In [-1, 1]^3. Drawn one after the other: compilers do not agree on the order in which they compute arguments.
Double3 in_cube(Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
  return {x, y, z};
}

using MeshPointer = std::shared_ptr<const Mesh>;

MeshPointer shared(Mesh mesh) {
  return std::make_shared<const Mesh>(std::move(mesh));
}

template <class SomeFunction>
SomeFunction glossy(Double3 kd, Double3 ks, double glossiness) {
  SomeFunction function;
  function.kd = kd, function.ks = ks, function.glossiness = glossiness;
  return function;
}

Object object(MeshPointer mesh, Double3 position, Double3 rotate_degrees, Double3 scale, FragmentFunction function) {
  Object o;
  o.mesh = std::move(mesh);
  o.position = position, o.rotate_degrees = rotate_degrees, o.scale = scale;
  o.material.fragment_function = std::move(function);
  return o;
}

// A point light that fades and a direction light, colours that differ in every channel.
Scene lit() {
  Scene scene;
  scene.camera.position = {0.3, 0.4, 3.7};
  scene.camera.target = {0.1, 0, 0};
  scene.background = {0.1, 0.2, 0.3};
  scene.point_lights.push_back({{2, 3, 2.5}, {7, 8, 9}, 1, 0.2, 0.1});
  scene.direction_lights.push_back({{-0.3, -1, -0.7}, {0.6, 0.5, 0.4}});
  return scene;
}

Scene with(Scene scene, std::vector<Object> objects) {
  scene.objects = std::move(objects);
  return scene;
}

std::shared_ptr<const Texture> noise_texture(int width, int height) {
  Random random = Random::from_state(5);
  auto texture = std::make_shared<Texture>();
  TextureLevel level{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) level.rgb.push_back(static_cast<float>(random.below(256)));
  texture->levels.push_back(std::move(level));
  build_mip_levels(*texture);
  return texture;
}

Scene textured(TextureFilter filter) {
  Scene scene = lit();
  scene.camera.position = {0.2, 0.3, 2};
  // The floor reaches behind the eye and out to the far plane: from many texels a pixel to many pixels a texel.
  Object floor = object(shared(plane_mesh(3)), {0, -0.4, 0}, {0, 20, 0}, {200, 1, 200},
                        glossy<Phong>({0.9, 0.9, 0.9}, {0.2, 0.2, 0.2}, 20));
  Mesh tiled = *floor.mesh;
  for (Float2& uv : tiled.uvs) uv = uv * 150.f - Float2(20, 70);
  floor.mesh = shared(tiled);
  Object ball = object(shared(sphere_mesh(24, 12)), {0, 0.3, 0}, {0, 40, 10}, {0.5, 0.6, 0.5},
                       glossy<BlinnPhong>({1, 1, 1}, {}, 1));
  for (Object* o : {&floor, &ball}) {
    o->material.diffuse_map.texture = noise_texture(37, 16);
    o->material.diffuse_map.filter = filter;
  }
  return with(scene, {floor, ball});
}

Scene measured(const std::shared_ptr<const MerlTable>& table,
               const std::vector<std::pair<MerlLookup, MerlAngles>>& ways) {
  std::vector<Object> balls;
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double x = static_cast<double>(i) - (static_cast<double>(ways.size()) - 1) / 2;
    balls.push_back(object(shared(sphere_mesh(32, 16)), {0.75 * x, 0.3 * x * x - 0.3, 0}, {10, 20, 30}, Double3(0.45),
                           Merl{table, ways[i].first, ways[i].second}));
  }
  return with(lit(), std::move(balls));
}

// Triangles of all sizes at all places: many cross the eye plane, a depth plane or the guard band.
Scene thrown(int triangles) {
  Random random = Random::from_state(11);
  Mesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const double size = 0.01 * static_cast<double>(1 << random.below(12)); // up to 20
    const auto spread = [&](double reach) { return reach * in_cube(random); };
    const Double3 centre = spread(4);
    for (int k = 0; k < 3; ++k) {
      mesh.positions.emplace_back(centre + spread(size));
      mesh.normals.emplace_back(spread(1));
      const Double3 uv = 3.0 * in_cube(random);
      mesh.uvs.emplace_back(uv.x, uv.y);
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  Object o = object(shared(mesh), {}, {}, Double3(1), glossy<BlinnPhong>({0.7, 0.8, 0.9}, {0.4, 0.3, 0.2}, 40));
  o.material.diffuse_map.texture = noise_texture(8, 8);
  return with(lit(), {o});
}

// What no scene should hold: numbers at the ends of their range, normals that are 0, scales that flatten.
Scene extremes() {
  constexpr float huge = std::numeric_limits<float>::max(), nan = std::numeric_limits<float>::quiet_NaN(),
                  infinite = std::numeric_limits<float>::infinity(), tiny = std::numeric_limits<float>::denorm_min();
  Mesh wall;
  const auto triangle = [&wall](Float3 a, Float3 b, Float3 c, Float3 normal, Float2 uv) {
    const auto first = static_cast<std::uint32_t>(wall.positions.size());
    for (const Float3& p : {a, b, c}) {
      wall.positions.push_back(p);
      wall.normals.push_back(normal);
      wall.uvs.push_back(uv);
    }
    wall.triangles.push_back({first, first + 1, first + 2});
  };
  triangle({-huge, -huge, -20}, {huge, -huge, -20}, {0, huge, -20}, {0, 0, 1}, {1e7f, -1e-9f});
  triangle({-1, -1, 0}, {0, -1, 0}, {-1, 0, 0}, {0, 0, 0}, {nan, 0});
  triangle({0, 0, 0}, {1, 0, 0}, {1, 1, 0.5f}, {0, 0, huge}, {infinite, 3});
  triangle({0, -1, 0}, {1, -1, 0}, {1, -0.1f, 0}, {tiny, tiny, tiny}, {0, 1});
  triangle({nan, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0});
  triangle({0, 0, 3.7f}, {infinite, 0, 0}, {1, 1, 0}, {0, 0, 1}, {0, 0});
  triangle({-3, 0.5f, 3.7f}, {1, 0.4f, 3.7f}, {0, 0.7f, -300}, {0, 1, 0},
           {0, 0}); // through the eye plane and the far one
  Scene scene = lit();
  Object o = object(shared(wall), {}, {}, Double3(1), glossy<Phong>({0.5, 0.6, 0.7}, {0.5, 0.5, 0.5}, 0));
  o.material.diffuse_map.texture = noise_texture(1, 3);
  scene.objects.push_back(o);
  const MeshPointer ball = shared(sphere_mesh(12, 6));
  scene.objects.push_back(
      object(ball, {-0.5, 0.6, 0}, {30, 0, 0}, {-0.3, 0.4, 1e-6}, glossy<BlinnPhong>({1, 0, 0}, {0, 1, 0}, 1e6)));
  scene.objects.push_back(
      object(ball, {0.5, 0.6, 0}, {30, 0, 0}, {0.4, 0, 0.4}, glossy<Phong>({1, 1, 0}, {0, 1, 1}, 1e-3)));
  scene.objects.push_back(object(ball, {0, 0, 0}, {}, {0, 0, 0.5}, Phong{}));
  scene.point_lights.push_back({{-0.5, -0.5, 0}, {1, 1, 1}, 0, 0, 1});
  scene.point_lights.push_back({{1e20, 1e20, 1e20}, {1, 1, 1}, 0, 0, 0});
  return scene;
}

// Of what is seen and what is not, on each other and on a floor with other corners than theirs.
Scene shadows() {
  Scene scene = lit();
  for (PointLight& light : scene.point_lights) light.shadow = Shadow::exact;
  for (DirectionLight& light : scene.direction_lights) light.shadow = Shadow::exact;
  scene.camera.position = {0.3, 1.9, 3.7};
  return with(scene, {object(shared(plane_mesh(3)), {0, -0.8, 0}, {0, 20, 0}, {4, 1, 4},
                             glossy<Phong>({0.9, 0.9, 0.9}, {0.2, 0.2, 0.2}, 20)),
                      object(shared(knot_mesh(120, 12, 0.22)), {0.3, 0.1, 0}, {70, 0, 20}, Double3(0.7),
                             glossy<BlinnPhong>({0.6, 0.7, 0.8}, {0.9, 0.9, 0.9}, 40)),
                      object(shared(sphere_mesh(24, 12)), {-0.9, -0.4, 0.5}, {10, 20, 30}, Double3(0.4),
                             glossy<Phong>({0.8, 0.5, 0.3}, {0.5, 0.5, 0.5}, 12))});
}

// The same by maps of every filter.
Scene shadow_maps() {
  Scene scene = shadows();
  ShadowFilter filter = ShadowFilter::nearest;
  for_each_light_list(scene, [&](auto& lights) {
    for (auto& light : lights) {
      ShadowMap map;
      map.size = 96, map.filter = filter;
      light.shadow = map;
      filter = filter == ShadowFilter::nearest      ? ShadowFilter::two_by_two
               : filter == ShadowFilter::two_by_two ? ShadowFilter::pcf3
                                                    : ShadowFilter::nearest;
    }
  });
  return scene;
}

Scene many_lights() {
  Random random = Random::from_state(3);
  Scene scene = lit();
  for (int i = 0; i < 100; ++i) {
    const Double3 position = 4.0 * in_cube(random), tint = in_cube(random), direction = in_cube(random);
    scene.point_lights.push_back({position, Double3(0.1) + 0.05 * tint, 1, 0, 0.3});
    scene.direction_lights.push_back({direction - Double3(0, 2, 0), Double3(0.01)});
  }
  return with(scene, {object(shared(torus_mesh(20, 10, 0.4)), {}, {70, 0, 10}, Double3(1),
                             glossy<Phong>({0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}, 8))});
}

} // namespace

std::vector<HashedScene> hashed_scenes() {
  const MeshPointer knot = shared(knot_mesh(120, 12, 0.22));
  const std::shared_ptr<const MerlTable> table(
      new MerlTable(merl_table_from(GgxDielectric{0.25, 1.5, {0.6, 0.3, 0.1}})));
  Phong gated = glossy<Phong>({0.6, 0.7, 0.8}, {0.5, 0.4, 0.3}, 12);
  gated.specular_gate = SpecularGate::cut_below_horizon;

  std::vector<HashedScene> scenes;
  scenes.push_back({"phong", with(lit(), {object(knot, {}, {70, 0, 20}, Double3(0.8), gated)})});
  scenes.push_back(
      {"blinn-phong", with(lit(), {object(knot, {}, {70, 0, 20}, {0.8, 0.6, -0.8},
                                          glossy<BlinnPhong>({0.6, 0.7, 0.8}, {0.9, 0.9, 0.9}, 1000.5))})});
  scenes.push_back({"merl-lookups", measured(table, {{MerlLookup::nearest, MerlAngles::closed},
                                                     {MerlLookup::trilinear, MerlAngles::closed},
                                                     {MerlLookup::trilinear_edge, MerlAngles::closed},
                                                     {MerlLookup::trilinear_log, MerlAngles::closed},
                                                     {MerlLookup::tricubic_log, MerlAngles::closed}})});
  scenes.push_back({"merl-angles", measured(table, {{MerlLookup::trilinear, MerlAngles::rotation},
                                                    {MerlLookup::trilinear, MerlAngles::frame}})});
  Microfacet gold, clay;
  gold.roughness = 0.2, gold.fresnel = MicrofacetFresnel::conductor;
  clay.roughness = 0.7, clay.metallic = 0.25, clay.base_color = {0.7, 0.4, 0.3};
  clay.fresnel = MicrofacetFresnel::dielectric;
  Microfacet coated = clay;
  coated.roughness = 1e-3, coated.fresnel = MicrofacetFresnel::schlick;
  scenes.push_back({"microfacets", with(lit(), {object(knot, {-0.8, 0, 0}, {70, 0, 20}, Double3(0.6), gold),
                                                object(knot, {0.8, 0, 0}, {70, 0, 20}, Double3(0.6), clay),
                                                object(knot, {0, 0.9, 0}, {20, 0, 70}, Double3(0.5), coated)})});
  scenes.push_back({"texture-nearest", textured(TextureFilter::nearest)});
  scenes.push_back({"texture-bilinear", textured(TextureFilter::bilinear)});
  scenes.push_back({"texture-trilinear", textured(TextureFilter::trilinear)});
  scenes.push_back({"small-triangles", with(lit(), {object(shared(sphere_mesh(300, 150)), {}, {20, 0, 20}, Double3(0.9),
                                                           glossy<Phong>({1, 1, 1}, {}, 1))})});
  scenes.push_back({"thrown-triangles", thrown(400)});
  scenes.push_back({"extremes", extremes()});
  scenes.push_back({"many-lights", many_lights()});
  scenes.push_back({"shadows", shadows()});
  scenes.push_back({"shadows-4", shadows(), 4});
  scenes.push_back({"shadow-maps", shadow_maps()});
  for (const int samples : {2, 4, 8, 16})
    scenes.push_back({"samples-" + std::to_string(samples), thrown(100), samples});
  return scenes;
}

} // namespace refraster::test
