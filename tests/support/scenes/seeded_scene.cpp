#include "tests/support/scenes/seeded_scene.h"

#include <refraster/mesh.h>

#include "scenes/synthesis/merl_synthesis.h"
#include "tests/support/random.h"
#include "tests/support/shading/each_fragment_function.h"

#include <algorithm>
#include <array>
#include <memory>

namespace refraster::test {
namespace {

bool one_in(Random& random, int n) {
  return random.below(n) == 0;
}
Double3 vector(Random& random, double lo, double hi) {
  const double x = random.uniform(lo, hi), y = random.uniform(lo, hi), z = random.uniform(lo, hi);
  return {x, y, z};
}
Double3 direction(Random& random) {
  for (;;)
    if (const Double3 v = vector(random, -1, 1); length(v) > 0.1 && length(v) < 1) return normalize(v);
}
/// Of a length in [lo, hi). What the next number is, must not depend on the compiler: one call in each expression.
Double3 offset(Random& random, double lo, double hi) {
  const double size = random.uniform(lo, hi);
  return size * direction(random);
}
/// The same, where every order of magnitude is as likely.
Double3 log_offset(Random& random, double lo, double hi) {
  const double size = random.log_uniform(lo, hi);
  return size * direction(random);
}
Float2 pair(Random& random, double lo, double hi) {
  const double x = random.uniform(lo, hi), y = random.uniform(lo, hi);
  return Float2(Double2(x, y));
}
template <class Enum>
Enum any_of(Random& random) {
  return EnumNames<Enum>::names[random.below(static_cast<int>(std::size(EnumNames<Enum>::names)))].first;
}

/// Appends a triangle of three vertices of its own, whose normals are nearly the face's, or now and then anything.
void add_triangle(Mesh& mesh, Random& random, const std::array<Double3, 3>& corners) {
  const Double3 across = cross(corners[1] - corners[0], corners[2] - corners[0]);
  const Double3 face = length(across) > 0 ? normalize(across) : Double3(0, 0, 1);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Double3& corner : corners) {
    mesh.positions.emplace_back(corner);
    mesh.normals.emplace_back(one_in(random, 12) ? direction(random) : normalize(face + 0.5 * direction(random)));
    mesh.uvs.push_back(pair(random, -1, 2));
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
}

Mesh triangle_soup(Random& random) {
  Mesh mesh;
  for (int i = 4 + random.below(20); i > 0; --i)
    add_triangle(mesh, random, {vector(random, -1, 1), vector(random, -1, 1), vector(random, -1, 1)});
  return mesh;
}

/// As long as the mesh and as thin as a hundredth of a pixel.
Mesh needles(Random& random) {
  Mesh mesh;
  for (int i = 10 + random.below(30); i > 0; --i) {
    const Double3 from = vector(random, -1, 1), to = vector(random, -1, 1);
    add_triangle(mesh, random, {from, to, from + log_offset(random, 1e-4, 0.03)});
  }
  return mesh;
}

/// Three corners almost, or exactly, on a line.
Mesh slivers(Random& random) {
  Mesh mesh;
  for (int i = 10 + random.below(30); i > 0; --i) {
    const Double3 from = vector(random, -1, 1), to = vector(random, -1, 1);
    const Double3 between = from + random.uniform(0.1, 0.9) * (to - from);
    add_triangle(mesh, random, {from, to, one_in(random, 4) ? between : between + log_offset(random, 1e-6, 0.03)});
  }
  return mesh;
}

/// Many thin triangles around one corner, with edges in common and one normal a vertex.
Mesh fan(Random& random) {
  Mesh mesh;
  const std::uint32_t count = 5 + static_cast<std::uint32_t>(random.below(60));
  const double dent = random.uniform(-0.6, 0.6);
  const Mesh rim = sphere_mesh(static_cast<int>(count), 2); // whose corners on the equator we take
  mesh.positions.emplace_back(0, static_cast<float>(dent), 0);
  mesh.normals.emplace_back(0, 1, 0);
  mesh.uvs.emplace_back(0.5f, 0.5f);
  for (const Float3& p : rim.positions)
    if (std::abs(p.y) < 0.5f && mesh.positions.size() <= count) {
      mesh.positions.emplace_back(p.x, static_cast<float>(random.uniform(-0.1, 0.1)), p.z);
      mesh.normals.emplace_back(normalize(Double3(p.x, 1, p.z)));
      mesh.uvs.emplace_back(0.5f + p.x / 2, 0.5f + p.z / 2);
    }
  for (std::uint32_t i = 1; i < mesh.positions.size(); ++i)
    mesh.triangles.push_back({0, i, i + 1 < mesh.positions.size() ? i + 1 : 1});
  return mesh;
}

/// Triangles from behind the eye to far in front of it, whatever way it looks.
Mesh huge_triangles(Random& random) {
  Mesh mesh;
  for (int i = 1 + random.below(4); i > 0; --i)
    add_triangle(mesh, random, {vector(random, -15, 15), vector(random, -15, 15), vector(random, -15, 15)});
  return mesh;
}

Mesh random_mesh(Random& random) {
  const auto cuts = [&] { return 3 + random.below(one_in(random, 4) ? 60 : 16); };
  const int a = cuts(), b = cuts();
  switch (random.below(13)) {
  case 0:
  case 1:
    return sphere_mesh(a, b - 1);
  case 2:
    return cube_mesh();
  case 3:
    return plane_mesh(a - 2);
  case 4:
    return torus_mesh(a, b, random.uniform(0.1, 0.9));
  case 5:
  case 6:
    return knot_mesh(2 * a, b, random.uniform(0.05, 0.3));
  case 7:
    return fan(random);
  case 8:
    return needles(random);
  case 9:
    return slivers(random);
  case 10:
    return huge_triangles(random);
  default:
    return triangle_soup(random);
  }
}

/// The mesh with its texture repeated, moved, or given to some of the vertices only.
std::shared_ptr<const Mesh> with_uvs_of_its_own(Mesh mesh, Random& random) {
  const Float2 repeats = pair(random, -3, 3), moved = pair(random, -2, 2);
  if (!one_in(random, 3))
    for (Float2& uv : mesh.uvs) uv = uv * repeats + moved;
  if (one_in(random, 8)) mesh.uvs.resize(static_cast<std::size_t>(random.below(static_cast<int>(mesh.uvs.size()))));
  return std::make_shared<const Mesh>(std::move(mesh));
}

/// Noise, or squares with a slope of brightness over them.
std::shared_ptr<const Texture> random_texture(Random& random, TextureFilter filter) {
  auto texture = std::make_shared<Texture>();
  TextureLevel& level = texture->levels.emplace_back();
  level.width = 1 + random.below(40);
  level.height = 1 + random.below(40);
  const bool noise = one_in(random, 2);
  for (int y = 0; y < level.height; ++y)
    for (int x = 0; x < level.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const int square = (x / 4 + y / 4) % 2 == 0 ? 60 : 200;
        level.rgb.push_back(static_cast<float>(noise ? random.below(256) : square + (3 * x + 2 * y + 20 * c) % 56));
      }
  if (filter == TextureFilter::trilinear) build_mip_levels(*texture);
  return texture;
}

/// A metal as it is, and a dull one with noise on it and a twentieth of the samples missing.
const std::array<std::shared_ptr<const MerlTable>, 2>& tables() {
  static const auto made = [] {
    const std::shared_ptr<const MerlTable> metal(new MerlTable(merl_table_from(find_brdf_preset("brass-like")->brdf)));
    Random random(1);
    PaddedVector<double> rough(3 * MerlTable::samples);
    for (std::size_t i = 0; i < rough.size(); i += 3) {
      const double factor = random.uniform(0.7, 1.3);
      const bool measured = !one_in(random, 20);
      for (std::size_t c = 0; c < 3; ++c) {
        const double f = metal->values<double>()[i + c];
        rough[i + c] = measured && f >= 0 ? (0.1 + 0.3 * f) * factor : -1;
      }
    }
    return std::array{metal, std::make_shared<const MerlTable>(std::move(rough))};
  }();
  return made;
}

/// Any values of the parameters that a fragment function declares.
struct RandomParameter {
  Random& random;

  void operator()(std::string_view, Double3& value, const Range&, std::string_view) const {
    value = one_in(random, 8) ? Double3(0) : vector(random, 0, 1);
  }
  void operator()(std::string_view, double& value, const Range&, std::string_view) const {
    value = one_in(random, 8) ? 0 : random.log_uniform(0.5, 400); // an exponent
  }
  template <NamedEnum Enum>
  void operator()(std::string_view, Enum& value, const Range&, std::string_view) const {
    value = any_of<Enum>(random);
  }
};

FragmentFunction random_function(Random& random) {
  std::vector<FragmentFunction> all = each_fragment_function();
  std::erase_if(all, [](const FragmentFunction& function) { return std::holds_alternative<Microfacet>(function); });
  FragmentFunction chosen = all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
  std::visit(
      [&]<class Function>(Function& function) {
        if constexpr (requires { function.table; })
          function.table = tables()[static_cast<std::size_t>(random.below(2))];
        Function::fields(function, RandomParameter{random});
      },
      chosen);
  return chosen;
}

/// Of one material in six, from a generator of its own, which the other only seeds.
void add_opacity(const Random& random, Material& material) {
  constexpr std::uint64_t opacity_seed = 0x6f706163697479; // other numbers than those of other textures
  Random peek = random, own(opacity_seed + static_cast<std::uint64_t>(peek.below(1 << 30)));
  if (!one_in(own, 6)) return;
  material.opacity_map.filter = any_of<TextureFilter>(own);
  material.opacity_map.texture = random_texture(own, material.opacity_map.filter);
  material.opacity_map.wrap = any_of<TextureWrap>(own);
  material.opacity_threshold = own.uniform(0.2, 0.8);
}

/// Of one material in five microfacets, with maps of their own; from a generator of its own, which the other only
/// seeds.
void add_microfacets(const Random& random, Material& material) {
  constexpr std::uint64_t microfacet_seed = 0x6d6963726f;
  Random peek = random, own(microfacet_seed + static_cast<std::uint64_t>(peek.below(1 << 30)));
  if (!one_in(own, 5)) return;
  Microfacet function;
  function.base_color = vector(own, 0, 1);
  function.metallic = own.below(3) / 2.0, function.roughness = own.uniform(0.15, 1);
  function.ior = own.uniform(1.1, 2.5), function.fresnel = any_of<MicrofacetFresnel>(own);
  material.fragment_function = function;
  for (TextureMap* const map : {&material.roughness_map, &material.metallic_map})
    if (one_in(own, 3)) {
      map->filter = any_of<TextureFilter>(own);
      map->texture = random_texture(own, map->filter);
    }
}

Material random_material(Random& random) {
  Material material;
  material.fragment_function = random_function(random);
  material.diffuse_map.filter = any_of<TextureFilter>(random);
  if (!one_in(random, 3)) material.diffuse_map.texture = random_texture(random, material.diffuse_map.filter);
  // No other number is drawn for what follows.
  Random peek = random, own(static_cast<std::uint64_t>(peek.below(1 << 30)));
  for (const TextureSlot& slot : texture_slots) {
    TextureMap& map = material.*slot.map;
    if (slot.map == &Material::opacity_map || is_of_microfacets(slot)) continue;
    const bool is_base = slot.map == &Material::diffuse_map;
    if (!is_base && one_in(own, 3)) {
      map.filter = any_of<TextureFilter>(own);
      map.texture = random_texture(own, map.filter);
      if (slot.multiplied) material.*slot.multiplied = vector(own, 0, 1);
    }
    if (!one_in(own, 3)) continue;
    map.wrap = any_of<TextureWrap>(own);
    map.scale = {own.uniform(-3, 3), own.uniform(-3, 3)}, map.offset = {own.uniform(-1, 1), own.uniform(-1, 1)};
  }
  add_opacity(random, material);
  add_microfacets(random, material);
  material.normal_scale = own.uniform(-1.5, 1.5), material.bump_scale = own.uniform(-2, 2);
  return material;
}

/// Where its maps turn normals: without, as a scene that is made by hand may be, in one of four.
void add_tangents_to(Object& object) {
  const Mesh& mesh = *object.mesh;
  Random own(2000 * mesh.positions.size() + mesh.triangles.size());
  if (!object.material.turns_normals() || one_in(own, 4)) return;
  Mesh with = mesh;
  add_tangents(with);
  object.mesh = std::make_shared<const Mesh>(std::move(with));
}

Object random_object(Random& random) {
  Object object;
  object.mesh = with_uvs_of_its_own(random_mesh(random), random);
  object.position = vector(random, -1, 1);
  object.rotate_degrees = one_in(random, 6) ? Double3(0) : vector(random, -180, 180);
  object.scale = one_in(random, 3) ? vector(random, 0.3, 1.6) : Double3(random.uniform(0.4, 1.5));
  if (one_in(random, 6)) object.scale[random.below(3)] *= -1;
  if (one_in(random, 16)) object.scale[random.below(3)] = 0;
  object.cull = any_of<Cull>(random);
  object.two_sided = object.position.y < 0 ? TwoSided::yes : TwoSided::no; // no other number is drawn for it
  object.material = random_material(random);
  add_tangents_to(object);
  return object;
}

/// A ground on which the camera stands, or that it has in itself: its corners lie behind the eye too.
Object ground(Random& random, const Camera& camera) {
  Object object;
  object.mesh = with_uvs_of_its_own(plane_mesh(1 + random.below(4)), random);
  object.position = camera.position;
  if (one_in(random, 3)) object.rotate_degrees = vector(random, -180, 180); // through the eye, up to rounding
  else if (!one_in(random, 4)) object.position.y -= random.log_uniform(1e-3, 3);
  object.scale = Double3(random.uniform(2, 30));
  object.cull = Cull::none;
  object.material = random_material(random);
  add_tangents_to(object);
  return object;
}

Camera random_camera(Random& random) {
  for (;;) {
    Camera camera;
    camera.position = one_in(random, 4) ? offset(random, 0.3, 1.5) : offset(random, 1.5, 4);
    camera.target = vector(random, -0.5, 0.5);
    camera.up = one_in(random, 4) ? direction(random) : Double3(0, 1, 0);
    camera.fov_y_degrees = random.uniform(25, 100);
    camera.near = one_in(random, 8) ? random.uniform(0.5, 2) : random.log_uniform(0.01, 0.3);
    camera.far = camera.near + random.uniform(4, 100);
    const Double3 sight = camera.target - camera.position;
    if (length(sight) > 0.05 && length(cross(normalize(sight), normalize(camera.up))) > 0.05) return camera;
  }
}

void add_lights(Scene& scene, Random& random) {
  for (int i = one_in(random, 12) ? 0 : 1 + random.below(3); i > 0; --i) {
    PointLight light{offset(random, 0.5, 6), vector(random, 0, 1.5), 1, 0, 0};
    if (one_in(random, 2)) light.position += scene.camera.position; // where its light is seen
    const auto maybe = [&](double most) { return one_in(random, 2) ? random.uniform(0, most) : 0; };
    if (one_in(random, 2)) light.linear = maybe(0.3), light.quadratic = maybe(0.1);
    if (one_in(random, 6)) light.constant = 0;
    scene.point_lights.push_back(light);
  }
  for (int i = random.below(3); i > 0; --i)
    scene.direction_lights.push_back({offset(random, 0.2, 3), vector(random, 0, 1)});
}

/// Of the lights of one scene in three, from a generator of its own, which the other only seeds.
void add_shadow_maps(const Random& random, Scene& scene) {
  constexpr std::uint64_t map_seed = 0x6d617073;
  Random peek = random, own(map_seed + static_cast<std::uint64_t>(peek.below(1 << 30)));
  if (!one_in(own, 3)) return;
  for_each_light_list(scene, [&](auto& lights) {
    for (auto& light : lights) {
      if (one_in(own, 3)) continue;
      ShadowMap map;
      map.size = 16 + own.below(112);
      map.filter = any_of<ShadowFilter>(own);
      map.bias = own.uniform(0, 2), map.slope_bias = one_in(own, 4) ? 0 : own.uniform(0, 4);
      if (one_in(own, 6)) map.near = own.log_uniform(0.01, 1);
      light.shadow = map;
    }
  });
}

} // namespace

SeededScene seeded_scene(std::uint64_t seed) {
  // Neighbouring seeds of Random give the same numbers, moved on by one.
  Random random(Random(seed).bits());
  SeededScene made;
  made.width = 150 + random.below(21);
  made.height = 80 + random.below(21);
  Scene& scene = made.scene;
  scene.camera = random_camera(random);
  scene.background = vector(random, 0, 0.5);
  add_lights(scene, random);
  for (int i = 2 + random.below(5); i > 0; --i) scene.objects.push_back(random_object(random));
  if (one_in(random, 3)) scene.objects.push_back(ground(random, scene.camera));
  if (one_in(random, 8)) { // in the same place, so that the first drawn is seen
    scene.objects.push_back(scene.objects.front());
    scene.objects.back().material = random_material(random);
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) scene.objects[i].name = "object " + std::to_string(i + 1);
  add_shadow_maps(random, scene);
  return made;
}

} // namespace refraster::test
