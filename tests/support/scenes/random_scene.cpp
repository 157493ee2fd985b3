#include "tests/support/scenes/random_scene.h"

#include <refraster/mesh.h>

#include "math/precisions.h"
#include "tests/support/invariants.h"
#include "tests/support/shading/each_fragment_function.h"

#include <algorithm>
#include <array>
#include <memory>

namespace refraster::test {
namespace {

bool one_in(Random& random, int n) {
  return random.below(n) == 0;
}

/// Mostly what people write; now and then anything finite.
double coordinate(Random& random) {
  return one_in(random, 12) ? random.hard<double>() : random.uniform(-3, 3);
}
Double3 vector(Random& random) {
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}
/// A number >= 0, the same way.
double amount(Random& random) {
  switch (random.below(12)) {
  case 0:
    return std::abs(random.hard<double>());
  case 1:
  case 2:
    return 0;
  default:
    return random.uniform(0, 2);
  }
}
Double3 colour(Random& random) {
  const double r = amount(random), g = amount(random), b = amount(random);
  return {r, g, b};
}

/// Triangles that have little to do with each other: degenerate ones, huge ones, normals and uvs of any kind.
Mesh loose_triangles(Random& random) {
  const auto number = [&] {
    return one_in(random, 20) ? random.hard<float>() : static_cast<float>(random.uniform(-2, 2));
  };
  const auto triple = [&] {
    const float x = number(), y = number(), z = number();
    return Float3(x, y, z);
  };
  Mesh mesh;
  const auto vertices = static_cast<std::uint32_t>(3 + random.below(30));
  // All have uvs, or the first ones, or none.
  const auto textured = static_cast<std::uint32_t>(random.below(3) * static_cast<int>(vertices) / 2);
  for (std::uint32_t i = 0; i < vertices; ++i) {
    mesh.positions.push_back(one_in(random, 8) && i > 0 ? mesh.positions.back() : triple());
    mesh.normals.push_back(one_in(random, 8) ? Float3(0) : triple());
    const Float3 uv = triple();
    if (i < textured) mesh.uvs.emplace_back(uv.x, uv.y);
  }
  const auto any = [&] { return static_cast<std::uint32_t>(random.below(static_cast<int>(vertices))); };
  for (std::uint32_t i = 0; i < vertices; ++i) { // each vertex is used
    const std::uint32_t b = any(), c = any();
    mesh.triangles.push_back({i, b, c});
  }
  return mesh;
}

Mesh random_mesh(Random& random) {
  const auto cuts = [&](int least) { return least + random.below(one_in(random, 10) ? 40 : 10); };
  const double tube = one_in(random, 8) ? random.log_uniform(1e-6, 1000) : random.uniform(0.05, 1.2);
  const int a = cuts(3), b = cuts(3);
  switch (random.below(7)) {
  case 0:
    return sphere_mesh(a, b - 1);
  case 1:
    return cube_mesh();
  case 2:
    return plane_mesh(a - 2);
  case 3:
    return torus_mesh(a, b, tube);
  case 4:
    return knot_mesh(a, b, tube);
  default:
    return loose_triangles(random);
  }
}

/// Of one mesh in four: of all vertices, or of the first half. From a generator of its own, which the mesh seeds, so
/// that all else in a scene of a given seed is what it is without them.
std::vector<Float3> random_colours(const Mesh& mesh) {
  Random random(1000 * mesh.positions.size() + mesh.triangles.size());
  if (!one_in(random, 4)) return {};
  std::vector<Float3> colours(mesh.positions.size() / (one_in(random, 3) ? 2 : 1));
  for (Float3& value : colours)
    for (int c = 0; c < 3; ++c) value[c] = static_cast<float>(random.uniform(0, 2));
  return colours;
}

/// Of one mesh in three: those of MikkTSpace, or any. From a generator of its own, likewise.
void add_random_tangents(Mesh& mesh) {
  Random random(2000 * mesh.positions.size() + mesh.triangles.size());
  if (one_in(random, 3)) return add_tangents(mesh);
  if (!one_in(random, 4)) return;
  mesh.tangents.resize(mesh.positions.size() / (one_in(random, 3) ? 2 : 1));
  for (Float4& value : mesh.tangents)
    for (int c = 0; c < 4; ++c)
      value[c] = one_in(random, 12) ? random.hard<float>() : static_cast<float>(random.uniform(-1, 1));
}

std::shared_ptr<const Texture> random_texture(Random& random, TextureFilter filter) {
  auto texture = std::make_shared<Texture>();
  texture->full_scale = one_in(random, 3) ? 65535 : 255;
  TextureLevel& level = texture->levels.emplace_back();
  level.width = 1 + random.below(17);
  level.height = 1 + random.below(17);
  for (int i = 0; i < 3 * level.width * level.height; ++i)
    level.rgb.push_back(static_cast<float>(random.below(static_cast<int>(texture->full_scale) + 1)));
  if (filter == TextureFilter::trilinear) build_mip_levels(*texture);
  return texture;
}

/// Those beside the diffuse one, and where they all are placed. From a generator of its own, which the other only
/// seeds.
void add_further_textures(const Random& random, Material& material) {
  Random peek = random, own(static_cast<std::uint64_t>(peek.below(1 << 30)));
  for (const TextureSlot& slot : texture_slots) {
    TextureMap& map = material.*slot.map;
    if (slot.map == &Material::opacity_map || is_of_microfacets(slot)) continue; // add_opacity, add_microfacets
    if (slot.map != &Material::diffuse_map && one_in(own, 4)) {
      constexpr TextureFilter filters[] = {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear};
      map.filter = filters[own.below(3)];
      Texture texture = *random_texture(own, TextureFilter::bilinear);
      if (one_in(own, 3)) decode_srgb(texture);
      if (map.filter == TextureFilter::trilinear) build_mip_levels(texture);
      map.texture = std::make_shared<const Texture>(std::move(texture));
    }
    if (slot.multiplied && one_in(own, 3)) material.*slot.multiplied = Double3(own.log_uniform(1e-3, 10), 0, 1);
    if (!one_in(own, 4)) continue;
    map.wrap = one_in(own, 2) ? TextureWrap::repeat : TextureWrap::clamp;
    const auto scale = [&] { return one_in(own, 8) ? own.log_uniform(1e-300, 1e300) : own.uniform(-4, 4); };
    map.scale = {scale(), scale()}, map.offset = {scale(), scale()};
  }
  const auto strength = [&] { return one_in(own, 8) ? own.hard<double>() : own.uniform(-3, 3); };
  material.normal_scale = strength(), material.bump_scale = strength();
}

/// Of few materials, from a generator of its own, which the other only seeds. Most thresholds cut out a part, some
/// nothing, or everything but a texel.
void add_opacity(const Random& random, Material& material) {
  constexpr std::uint64_t opacity_seed = 0x6f706163697479; // other numbers than those of add_further_textures
  Random peek = random, own(opacity_seed + static_cast<std::uint64_t>(peek.below(1 << 30)));
  if (!one_in(own, 6)) return;
  constexpr TextureFilter filters[] = {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::trilinear};
  TextureMap& map = material.opacity_map;
  map.filter = filters[own.below(3)];
  map.texture = random_texture(own, map.filter);
  constexpr double thresholds[] = {0, 0.25, 0.5, 0.5, 0.75, 1};
  material.opacity_threshold = thresholds[own.below(6)];
  if (!one_in(own, 2)) return;
  map.wrap = one_in(own, 2) ? TextureWrap::repeat : TextureWrap::clamp;
  map.scale = {own.uniform(-4, 4), own.log_uniform(1e-3, 1e3)}, map.offset = {own.uniform(-1, 1), own.uniform(-1, 1)};
}

template <class Enum>
Enum any_of(Random& random) {
  return EnumNames<Enum>::names[random.below(static_cast<int>(std::size(EnumNames<Enum>::names)))].first;
}

/// Of one material in five, from a generator of its own, which the other only seeds: any parameters in their ranges,
/// and maps.
void add_microfacets(const Random& random, Material& material) {
  constexpr std::uint64_t microfacet_seed = 0x6d6963726f;
  Random peek = random, own(microfacet_seed + static_cast<std::uint64_t>(peek.below(1 << 30)));
  if (!one_in(own, 5)) return;
  const auto fraction = [&] { return one_in(own, 4) ? own.below(2) : own.uniform(0, 1); };
  const auto index = [&] { return one_in(own, 4) ? own.log_uniform(1e-30, 99) : own.uniform(0.1, 5); };
  Microfacet function;
  for (int c = 0; c < 3; ++c) function.base_color[c] = fraction(), function.eta[c] = index(), function.k[c] = index();
  function.metallic = fraction(), function.roughness = fraction(),
  function.ior = std::max(1.0, std::min(index(), 10.0));
  function.fresnel = any_of<MicrofacetFresnel>(own);
  material.fragment_function = function;
  for (TextureMap* const map : {&material.roughness_map, &material.metallic_map})
    if (one_in(own, 3)) {
      map->filter = any_of<TextureFilter>(own);
      map->texture = random_texture(own, map->filter);
    }
}

/// One for all scenes: it has 105 MB. A third of it was never measured.
std::shared_ptr<const MerlTable> ragged_table() {
  static const auto table = [] {
    Random random(1);
    PaddedVector<double> rgb(3 * MerlTable::samples);
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
      const bool measured = random.below(3) > 0;
      for (std::size_t c = 0; c < 3; ++c) rgb[i + c] = measured ? random.log_uniform(1e-6, 1e3) : -1;
    }
    return std::make_shared<const MerlTable>(std::move(rgb));
  }();
  return table;
}

/// x if it may be that, and a number near the least otherwise.
double within(const Range& range, double x) {
  if (range.contains(x)) return x;
  return range.contains(range.min) ? range.min : range.min + std::min(1.0, (range.max - range.min) / 2);
}

/// Any values that a fragment function declares: few of the ordinary kind, and the ends of their ranges.
struct RandomParameter {
  Random& random;

  void operator()(std::string_view, Double3& value, const Range& range, std::string_view) const {
    value = colour(random);
    for (int c = 0; c < 3; ++c) value[c] = within(range, value[c]);
  }
  void operator()(std::string_view, double& value, const Range& range, std::string_view) const {
    value = within(range, one_in(random, 6) ? random.log_uniform(1e-9, 1e9) : amount(random) * 20);
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
        if constexpr (requires { function.table; }) function.table = ragged_table();
        Function::fields(function, RandomParameter{random});
      },
      chosen);
  return chosen;
}

Object random_object(Random& random) {
  Object object;
  object.name = "object";
  Mesh mesh = random_mesh(random);
  mesh.colours = random_colours(mesh);
  add_random_tangents(mesh);
  object.mesh = std::make_shared<const Mesh>(std::move(mesh));
  object.position = one_in(random, 4) ? vector(random) : Double3{random.uniform(-1, 1), random.uniform(-1, 1), 0};
  const double turns = one_in(random, 2) ? 1.0 : 60.0;
  object.rotate_degrees = vector(random) * turns;
  object.scale = one_in(random, 3) ? vector(random) : Double3(random.uniform(0.3, 2));
  const auto finite = [](Double3& a, const Double3& otherwise) {
    if (!std::isfinite(a.x + a.y + a.z)) a = otherwise;
  };
  finite(object.rotate_degrees, Double3(90));
  if (one_in(random, 8)) object.scale[random.below(3)] = 0;
  object.cull = any_of<Cull>(random);
  object.two_sided = object.position.y < 0 ? TwoSided::yes : TwoSided::no; // no other number is drawn for it
  object.material.fragment_function = random_function(random);
  object.material.diffuse_map.filter = any_of<TextureFilter>(random);
  if (!one_in(random, 3))
    object.material.diffuse_map.texture = random_texture(random, object.material.diffuse_map.filter);
  add_further_textures(random, object.material);
  add_opacity(random, object.material);
  add_microfacets(random, object.material);
  return object;
}

/// As io/scene/scene_reader.cpp takes them: with a line of sight of finite length, and up not along it.
Camera random_camera(Random& random) {
  for (;;) {
    Camera camera;
    camera.position = one_in(random, 10) ? vector(random) : Double3{random.uniform(-2, 2), random.uniform(-2, 2), 5};
    camera.target = one_in(random, 6) ? vector(random) : Double3{random.uniform(-0.5, 0.5), 0, 0};
    camera.up = one_in(random, 4) ? vector(random) : Double3(0, 1, 0);
    camera.fov_y_degrees = one_in(random, 5) ? 180 * random.log_uniform(1e-9, 0.999999) : random.uniform(15, 80);
    camera.near = one_in(random, 6) ? random.log_uniform(1e-300, 1) : random.uniform(0.01, 3);
    camera.far = one_in(random, 6) ? random.log_uniform(1, 1e300) : camera.near + random.uniform(1, 100);
    const Double3 sight = camera.target - camera.position;
    const double distance = length(sight), tilt = length(cross(normalize(sight), normalize(camera.up)));
    if (camera.near < camera.far && distance > 0 && std::isfinite(distance) && tilt > 1e-6) return camera;
  }
}

ShadowMap random_map(Random& random) {
  ShadowMap map;
  map.size = 16 + random.below(80);
  map.filter = EnumNames<ShadowFilter>::names[random.below(3)].first;
  map.bias = one_in(random, 8) ? random.log_uniform(1e-3, 1e3) : random.uniform(0, 2);
  map.slope_bias = one_in(random, 4) ? 0 : random.uniform(0, 4);
  if (one_in(random, 8)) map.near = random.log_uniform(1e-3, 10);
  return map;
}

/// Of lights of some scenes, from a generator of its own, which the other only seeds.
void add_shadows(const Random& random, Scene& scene) {
  constexpr std::uint64_t shadow_seed = 0x736861646f77;
  Random peek = random, own(shadow_seed + static_cast<std::uint64_t>(peek.below(1 << 30)));
  if (!one_in(own, 3)) return;
  for_each_light_list(scene, [&](auto& lights) {
    for (auto& light : lights) {
      if (!one_in(own, 2)) continue;
      if (one_in(own, 2)) light.shadow = Shadow::exact;
      else light.shadow = random_map(own);
    }
  });
}

} // namespace

Scene random_scene(Random& random) {
  Scene scene;
  scene.camera = random_camera(random);
  scene.background = colour(random);
  for (int i = random.below(4); i > 0; --i)
    scene.point_lights.push_back({vector(random), colour(random), amount(random), amount(random), amount(random)});
  for (int i = random.below(3); i > 0; --i) {
    DirectionLight light{vector(random), colour(random)};
    if (light.direction.x == 0 && light.direction.y == 0 && light.direction.z == 0) light.direction.z = 1;
    scene.direction_lights.push_back(light);
  }
  add_shadows(random, scene);
  for (int i = random.below(6); i > 0; --i) scene.objects.push_back(random_object(random));
  return scene;
}

RenderOptions random_options(Random& random) {
  constexpr Precision precisions[] = {Precision::double_, Precision::double_, Precision::float_, Precision::fast};
  RenderOptions options;
  options.width = 1 + random.below(48);
  options.height = 1 + random.below(48);
  options.precision = precisions[random.below(4)];
  options.samples = 1 << random.below(5);
  options.transfer = one_in(random, 2) ? Transfer::linear : Transfer::srgb;
  options.want_radiance = true;
  options.aovs = all_aovs();
  return options;
}

} // namespace refraster::test
