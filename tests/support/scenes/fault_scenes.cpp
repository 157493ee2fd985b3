#include "tests/support/scenes/fault_scenes.h"

#include "math/vec.h"
#include "tests/support/scenes/brick_scene.h"
#include "tests/support/scenes/leaf_scene.h"

#include <cmath>
#include <string>

namespace refraster {
namespace {

/// Patches of all colours, alike nowhere: turned, shifted or exchanged it is another.
std::shared_ptr<const Texture> patches(int width, int height, TextureFilter filter) {
  auto texture = std::make_shared<Texture>();
  TextureLevel image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int patch = (x / 2 * 7 + y / 2 * 13 + x * y / 9) % 11;
      for (const int value : {40 + 19 * patch, 30 + x * 200 / width, 250 - y * 220 / height})
        image.rgb.push_back(static_cast<float>(value));
    }
  texture->levels.push_back(std::move(image));
  if (filter == TextureFilter::trilinear) build_mip_levels(*texture);
  return texture;
}

std::shared_ptr<const Mesh> shared(Mesh mesh) {
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// Texture coordinates from -0.4 to 2.2, so that it repeats.
Mesh repeating(Mesh mesh) {
  for (Float2& uv : mesh.uvs) uv = uv * 2.6f - 0.4f;
  return mesh;
}

/// The lower half of the sphere: open, its inside is seen from above.
Mesh bowl() {
  Mesh mesh = sphere_mesh(32, 16);
  std::erase_if(mesh.triangles, [&](const auto& t) {
    return mesh.positions[t[0]].y > 0.01f || mesh.positions[t[1]].y > 0.01f || mesh.positions[t[2]].y > 0.01f;
  });
  return mesh;
}

/// Normals of length 2 to 3: any length counts as the same.
Mesh with_long_normals(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) mesh.normals[i] *= 2 + 0.1f * static_cast<float>(i % 11);
  return mesh;
}

Object thing(std::string name, Mesh mesh, const Double3& position, const Double3& rotate, const Double3& scale,
             FragmentFunction function) {
  Object object;
  object.name = std::move(name);
  object.mesh = shared(std::move(mesh));
  object.position = position, object.rotate_degrees = rotate, object.scale = scale;
  object.material.fragment_function = std::move(function);
  return object;
}

template <class Function>
Function plastic(const Double3& ka, const Double3& kd, const Double3& ks, double glossiness,
                 SpecularGate gate = SpecularGate::open) {
  Function function;
  function.ka = ka, function.kd = kd, function.ks = ks, function.glossiness = glossiness, function.specular_gate = gate;
  return function;
}

void show(Object& object, int width, int height, TextureFilter filter) {
  object.material.diffuse_map.texture = patches(width, height, filter);
  object.material.diffuse_map.filter = filter;
}

Scene plastics(SpecularGate gate) {
  Scene scene;
  scene.camera = {{1.2, 2.1, 5.2}, {0.1, -0.1, 0}, {0, 1, 0}, 48, 0.4, 40};
  scene.background = {0.05, 0.08, 0.12};
  scene.point_lights = {{{-3, 3.5, 4}, {7, 6.2, 5}, 0.3, 0.2, 0.15}, {{3.5, 1.2, -2.5}, {0.5, 0.6, 0.8}, 1, 0, 0}};
  scene.direction_lights = {{{0.3, -1, -0.4}, {0.24, 0.28, 0.2}}, {{-1, -0.2, 0.6}, {0.15, 0.1, 0.2}}};

  Object ground = thing("ground", repeating(plane_mesh(3)), {0, -1.05, -3}, {0, 12, 0}, {5, 1, 7},
                        plastic<Phong>({0.08, 0.07, 0.06}, {0.55, 0.6, 0.5}, {0.15, 0.15, 0.2}, 12, gate));
  show(ground, 64, 48, TextureFilter::trilinear);
  Object ball = thing("ball", sphere_mesh(40, 20), {-1.3, 0.05, 0.4}, {10, 25, 8}, {1.25, 0.8, 0.55},
                      plastic<Phong>({0.05, 0.05, 0.06}, {0.5, 0.35, 0.25}, {0.45, 0.45, 0.4}, 30, gate));
  show(ball, 24, 20, TextureFilter::bilinear);
  Object torus =
      thing("torus", with_long_normals(torus_mesh(36, 18, 0.4)), {1.25, -0.15, 0.3}, {62, 0, 24}, {0.9, 1.3, 0.6},
            plastic<BlinnPhong>({0.04, 0.06, 0.05}, {0.25, 0.45, 0.4}, {0.5, 0.4, 0.4}, 45, gate));
  Object box = thing("box", cube_mesh(), {0.2, -0.45, 1.7}, {0, 33, 0}, {0.35, 0.45, 0.3},
                     plastic<BlinnPhong>({0.06, 0.05, 0.05}, {0.5, 0.5, 0.45}, {0.3, 0.3, 0.3}, 8, gate));
  show(box, 8, 6, TextureFilter::nearest);
  Object open = thing("bowl", bowl(), {0.1, 0.45, -1.6}, {48, 0, 10}, {0.9, 0.7, 0.9},
                      plastic<Phong>({0.06, 0.06, 0.07}, {0.45, 0.3, 0.5}, {0.3, 0.35, 0.3}, 5, gate));
  Object culled = thing("culled bowl", bowl(), {2.2, 0.6, -2.2}, {52, 20, 0}, {0.8, 0.9, 0.8},
                        plastic<BlinnPhong>({0.05, 0.06, 0.05}, {0.5, 0.5, 0.2}, {0.3, 0.3, 0.3}, 20, gate));
  culled.cull = Cull::back;
  const Double3 wall(-0.9, 0.9, -3);
  Object poster = thing("poster", plane_mesh(1), wall, {90, 0, 0}, {1.5, 1, 0.6},
                        plastic<Phong>({0.2, 0.1, 0.1}, {0.6, 0.2, 0.2}, {0.1, 0.1, 0.1}, 10, gate));
  Object same = thing("poster in its place", plane_mesh(1), wall, {90, 0, 0}, {1.5, 1, 0.6},
                      plastic<Phong>({0.1, 0.1, 0.3}, {0.2, 0.3, 0.7}, {0.1, 0.1, 0.1}, 10, gate));
  Object near = thing("near the eye", plane_mesh(1), {1.25, 1.25, 3.6}, {35, 0, 0}, {0.12, 1, 0.6},
                      plastic<Phong>({0.1, 0.15, 0.1}, {0.3, 0.5, 0.3}, {0.2, 0.2, 0.2}, 15, gate));
  scene.objects = {ground, ball, torus, box, open, culled, poster, same, near};
  return scene;
}

/// Rises toward the highlight, with waves along all three axes and different for red, green and blue; a twelfth of the
/// samples is marked as never measured.
std::shared_ptr<const MerlTable> wavy_table() {
  PaddedVector<double> rgb(3 * MerlTable::samples);
  std::size_t at = 0;
  for (int h = 0; h < MerlTable::theta_h_bins; ++h)
    for (int d = 0; d < MerlTable::theta_d_bins; ++d)
      for (int p = 0; p < MerlTable::phi_d_bins; ++p) {
        const bool measured = (h / 3 * 31 + d / 5 * 17 + p / 9 * 7) % 12 != 0;
        const double highlight = 1.5 * std::exp(-0.012 * h * h);
        const double waves = 1 + 0.4 * std::sin(0.11 * d + 0.02 * h) + 0.3 * std::sin(0.07 * p);
        for (int c = 0; c < 3; ++c)
          rgb[at++] = measured ? (0.1 + 0.06 * c) * waves + highlight * (1 - 0.2 * c) : -1.0 / (1500 - 300 * c);
      }
  return std::make_shared<const MerlTable>(std::move(rgb));
}

Scene measured() {
  Scene scene;
  scene.camera = {{-0.7, 1.6, 4.6}, {0, 0, 0}, {0, 1, 0}, 45, 0.2, 30};
  scene.background = {0.1, 0.09, 0.08};
  scene.point_lights = {{{-2.5, 3, 3.5}, {2.6, 2.2, 1.9}, 0.4, 0.15, 0.1}};
  scene.direction_lights = {{{0.5, -1, -0.3}, {0.5, 0.55, 0.65}}};
  Merl merl;
  merl.table = wavy_table();
  scene.objects = {
      thing("ball", sphere_mesh(48, 24), {-1, 0.1, 0}, {10, 25, 0}, {1.1, 0.9, 0.7}, merl),
      thing("torus", torus_mesh(40, 20, 0.4), {1.1, 0, 0}, {60, 10, 0}, {0.9, 0.8, 1.2}, merl),
  };
  return scene;
}

/// Brighter and darker, alike nowhere, with the colours of its vertices.
Mesh with_colours(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.colours.emplace_back(0.3f + static_cast<float>(i % 8) / 10, 0.9f - static_cast<float>(i % 5) / 10, 0.5f);
  return mesh;
}

/// What the other scenes have not: maps of normals, of opacity and of highlights, light of its own, colours of
/// vertices, a texture in sRGB.
Scene mapped() {
  constexpr TextureFilter filter = TextureFilter::bilinear;
  Scene scene = brick_scene(filter, BrickMaps::normals);
  scene.point_lights[0] = {{-3, 4, 5}, {0.8, 0.75, 0.7}, 1, 0, 0};
  const auto shine = plastic<BlinnPhong>({0.06, 0.06, 0.06}, {0.5, 0.5, 0.45}, {0.4, 0.4, 0.45}, 14);
  BlinnPhong wide = shine; // its highlight is all over the ground
  wide.glossiness = 3;
  Object ground = thing("ground", plane_mesh(2), {0, -1.1, -1}, {0, 10, 0}, {5, 1, 4}, wide);
  Texture decoded = *patches(32, 24, filter);
  decode_srgb(decoded);
  ground.material.diffuse_map.texture = std::make_shared<const Texture>(std::move(decoded));
  ground.material.specular_map.texture = patches(12, 10, filter);
  Object knot = thing("coloured knot", with_colours(knot_mesh(64, 12, 0.3)), {0.05, 1.15, -0.8}, {20, 10, 0},
                      Double3(0.32), shine);
  Object lamp = thing("lamp", sphere_mesh(20, 10), {0.15, -0.55, 1.3}, {0, 0, 20}, Double3(0.32), shine);
  lamp.material.emissive = {0.4, 0.35, 0.2};
  lamp.material.emissive_map.texture = patches(10, 8, filter);
  Object card = leaf_scene(filter).objects[0];
  card.position = {-0.05, 0.35, 0.9}, card.rotate_degrees = {0, 200, 10}, card.scale = Double3(0.7);
  for (Object* const object : {&ground, &knot, &lamp, &card}) scene.objects.push_back(std::move(*object));
  return scene;
}

/// Half metal, and none of it: rough and less rough, with maps.
Scene microfacets() {
  Scene scene;
  scene.camera = {{0.4, 1.3, 4.8}, {0, 0, 0}, {0, 1, 0}, 42, 0.3, 30};
  scene.background = {0.06, 0.07, 0.09};
  scene.point_lights = {{{-2.5, 3, 3.5}, {1.6, 1.5, 1.4}, 1, 0, 0}, {{3, 1.5, 3}, {0.7, 0.8, 1}, 1, 0, 0}};
  const auto surface = [](const Double3& base, double metallic, double roughness) {
    Microfacet function;
    function.base_color = base, function.metallic = metallic, function.roughness = roughness;
    return function;
  };
  Object ball =
      thing("ball", sphere_mesh(48, 24), {-1.15, 0.2, 0}, {10, 25, 0}, Double3(1.05), surface({0.9, 0.6, 0.3}, 1, 0.6));
  Object torus = thing("torus", torus_mesh(40, 20, 0.4), {1.2, 0.1, 0}, {60, 10, 0}, {0.9, 0.8, 1.1},
                       surface({0.3, 0.5, 0.8}, 0.3, 0.75));
  Object ground = thing("ground", plane_mesh(2), {0, -1.1, -1}, {0, 10, 0}, {4, 1, 4}, surface({0.8, 0.8, 0.7}, 0, 1));
  show(ground, 32, 24, TextureFilter::bilinear);
  ground.material.roughness_map = {patches(16, 12, TextureFilter::bilinear), TextureFilter::bilinear};
  scene.objects = {ball, torus, ground};
  return scene;
}

/// Between a lamp and a low sun, each with a map: every face of the lamp's shows something.
Scene shadowed() {
  Scene scene;
  scene.camera = {{0.3, 1.9, 4.6}, {0, 0.1, 0}, {0, 1, 0}, 50, 0.3, 30};
  scene.background = {0.05, 0.06, 0.08};
  ShadowMap lamp, sun;
  lamp.size = 128, lamp.filter = ShadowFilter::pcf3, lamp.slope_bias = 3;
  sun.size = 256;
  scene.point_lights = {{{0.1, 1.3, 0.4}, {0.8, 0.75, 0.7}, 1, 0, 0, lamp}};
  scene.direction_lights = {{{0.5, -0.7, -0.6}, {0.5, 0.5, 0.4}, sun}};
  const auto matt = plastic<Phong>({0.08, 0.08, 0.08}, {0.6, 0.6, 0.55}, {0.1, 0.1, 0.1}, 10);
  scene.objects = {thing("ground", plane_mesh(2), {0, -0.9, 0}, {0, 15, 0}, {4, 1, 4}, matt),
                   thing("wall", plane_mesh(2), {0, 1, -2}, {90, 0, 0}, {4, 1, 3}, matt),
                   thing("ball", sphere_mesh(40, 20), {-0.9, -0.2, 0.5}, {10, 20, 30}, Double3(0.6), matt),
                   thing("knot", knot_mesh(64, 12, 0.26), {0.9, 0, -0.2}, {70, 0, 20}, Double3(0.6), matt),
                   thing("lid", cube_mesh(), {0.3, 1.9, 0.2}, {0, 30, 0}, {0.4, 0.04, 0.3}, matt)};
  return scene;
}

} // namespace

const std::vector<FaultScene>& fault_scenes() {
  static const std::vector<FaultScene> all = {{"plastics", plastics(SpecularGate::open)},
                                              {"gated plastics", plastics(SpecularGate::cut_below_horizon)},
                                              {"measured", measured()},
                                              {"mapped", mapped()},
                                              {"microfacets", microfacets()},
                                              {"shadowed", shadowed()}};
  return all;
}

} // namespace refraster
