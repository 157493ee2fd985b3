#pragma once
// A scene as plain data: what is drawn, no file formats. Meshes, textures and tables are shared and immutable.

#include <refraster/fields.h>
#include <refraster/material.h>
#include <refraster/mesh.h>
#include <refraster/vector.h>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace refraster {

/// What a list of lights of one type is called.
struct LightNames {
  std::string_view key = {};   ///< in a scene file: "point_lights"
  std::string_view words = {}; ///< in a message: "point lights"
  std::string_view glsl = {};  ///< the array of uniforms: "pointLights", of PointLight; how many: "pointLightCount"
  Need need = Need::optional;  ///< whether a scene file must have the list
};

/// Whether surfaces keep a light from others, and how that is found out.
enum class Shadow {
  none,  ///< the light shines through everything
  exact, ///< no light where a triangle of the scene lies between, decided without rounding: docs/shadows.md
  map    ///< the same by an image of depths that the light sees, as GPUs do: docs/shadow-maps.md
};

template <>
struct EnumNames<Shadow> {
  static constexpr std::pair<Shadow, std::string_view> names[] = {
      {Shadow::none, "none"}, {Shadow::exact, "exact"}, {Shadow::map, "map"}};
};

/// Which texels of a shadow map are compared with the depth of a surface, and how the answers become one.
enum class ShadowFilter {
  nearest,    ///< that of the texel it lies in: 0 or 1
  two_by_two, ///< those of the four texels about it, by bilinear weights, as `sampler2DShadow` has with GL_LINEAR
  pcf3        ///< the mean of nine: of its texel and the eight about that
};

template <>
struct EnumNames<ShadowFilter> {
  static constexpr std::pair<ShadowFilter, std::string_view> names[] = {
      {ShadowFilter::nearest, "none"}, {ShadowFilter::two_by_two, "2x2"}, {ShadowFilter::pcf3, "pcf3"}};
};

/// What a shadow map is like. docs/shadow-maps.md has the formulas.
struct ShadowMap {
  /// Of `size`.
  static constexpr Range sizes{16, 8192};
  int size = 1024;                                ///< texels a side; of each of a point light's six faces
  ShadowFilter filter = ShadowFilter::two_by_two; ///< of what is compared
  double bias = 1;                                ///< how much nearer to the light a surface counts, in texels >= 0
  double slope_bias = 2; ///< the same for each texel that the surface rises by across a texel; >= 0
  double near = 0;       ///< of a point light's faces: the near plane's distance; 0: by the scene's bounds

  /// Declares the parameters, as those of a light are.
  static void fields(auto& self, auto&& field) {
    field("map", self.size, sizes, "texels a side; a point light has six such faces");
    field("filter", self.filter, Range{}, "which texels are compared: one, four by bilinear weights, or nine");
    field("bias", self.bias, Range{}, "how much nearer to the light a surface counts than it is, in texels");
    field("slope_bias", self.slope_bias, Range{},
          "the same for each texel that the surface's depth changes by from texel to texel");
    field("near", self.near, Range{}, "of a point light: what is nearer to it casts no shadow; 0: by the scene's size");
  }
  /// Whether they are the same.
  bool operator==(const ShadowMap&) const = default;
};

/// What keeps a light from surfaces. Made from either of the two, and compared with a kind.
struct CastShadow {
  Shadow kind = Shadow::none; ///< how it is found out
  ShadowMap map = {};         ///< for Shadow::map

  /// None.
  constexpr CastShadow() = default;
  /// Of that kind; a map as it is where nothing is said of it.
  constexpr CastShadow(Shadow its_kind) : kind(its_kind) {}
  /// By this map.
  constexpr CastShadow(const ShadowMap& its_map) : kind(Shadow::map), map(its_map) {}
  /// Whether it is of that kind.
  constexpr bool operator==(Shadow other) const { return kind == other; }
};

// A type of light declares its names and, as a fragment function does, its parameters: <refraster/fields.h>. What
// arrives of it at a surface is in shading/light.h.

/// Of the parameter, for the documentation.
inline constexpr std::string_view shadow_meaning =
    "`\"exact\"`: whatever triangle lies between it and a surface takes its light ([shadows.md](shadows.md)); "
    "`\"map\"`, or an object: the same by a depth map, as GPUs do ([shadow-maps.md](shadow-maps.md))";

/// A light that shines from one point in all directions: attenuated by 1 / (Kc + Kl d + Kq d^2), d in world units. All
/// three 0 means no attenuation.
struct PointLight {
  Double3 position{0};    ///< world space
  Double3 radiance{1};    ///< linear; each channel >= 0
  double constant = 1;    ///< Kc >= 0
  double linear = 0;      ///< Kl >= 0
  double quadratic = 0;   ///< Kq >= 0
  CastShadow shadow = {}; ///< what keeps it from a surface: what crosses the segment to `position`

  /// Of the list.
  static constexpr LightNames names{"point_lights", "point lights", "pointLights", Need::required};
  /// Declares the parameters.
  static void fields(auto& self, auto&& field) {
    field("position", self.position, any_number, "world space");
    field("radiance", self.radiance, Range{}, "red, green, blue");
    field("constant", self.constant, Range{}, "Kc of the attenuation 1 / (Kc + Kl d + Kq d²); all three 0: none");
    field("linear", self.linear, Range{}, "Kl");
    field("quadratic", self.quadratic, Range{}, "Kq");
    field("shadow", self.shadow, Range{}, shadow_meaning);
  }
};

/// A light infinitely far away. Not attenuated.
struct DirectionLight {
  Double3 direction{0, 0, -1}; ///< world space: where the light travels to; any length but 0
  Double3 radiance{1};         ///< linear; each channel >= 0
  CastShadow shadow = {};      ///< what keeps it from a surface: what crosses the ray against `direction`

  /// Of the list.
  static constexpr LightNames names{"direction_lights", "direction lights", "directionLights", Need::required};
  /// Declares the parameters.
  static void fields(auto& self, auto&& field) {
    field("direction", self.direction, any_direction, "where the light travels to, world space; not zero");
    field("radiance", self.radiance, Range{}, "red, green, blue");
    field("shadow", self.shadow, Range{}, shadow_meaning);
  }
};

/// OpenGL's camera: right-handed, looks down its own -Z.
struct Camera {
  Double3 position{0, 0, 0}; ///< world space
  Double3 target{0, 0, -1};  ///< the point looked at; not the position
  Double3 up{0, 1, 0};       ///< up in the image; not parallel to the line of sight
  double fov_y_degrees = 45; ///< vertical field of view, in (0, 180)
  double near = 0.1;         ///< distance of the near plane; > 0
  double far = 100;          ///< distance of the far plane; > near
};

/// Whether triangles that are seen from behind are drawn.
enum class Cull { none, back };

template <>
struct EnumNames<Cull> {
  static constexpr std::pair<Cull, std::string_view> names[] = {{Cull::none, "none"}, {Cull::back, "back"}};
};

/// Whether a surface is lit from both of its sides.
enum class TwoSided {
  no, ///< normals are as the mesh gives them
  yes ///< the normal is turned to the eye where a triangle is seen from the side away from its normals
};

template <>
struct EnumNames<TwoSided> {
  static constexpr std::pair<TwoSided, std::string_view> names[] = {{TwoSided::no, "false"}, {TwoSided::yes, "true"}};
};

/// A mesh, placed. World from object is T . Rx . Ry . Rz . S.
struct Object {
  std::string name = {};                 ///< for reports
  std::shared_ptr<const Mesh> mesh = {}; ///< not null
  Double3 position{0};                   ///< world space
  Double3 rotate_degrees{0};             ///< about x, y and z
  Double3 scale{1};                      ///< negative mirrors, 0 flattens: both are drawn
  Cull cull = Cull::none;                ///< whether its back is drawn
  TwoSided two_sided = TwoSided::no;     ///< whether its back is lit as its front is
  Material material = {};                ///< what its surface is like, where `materials` has nothing else
  std::vector<Material> materials = {};  ///< of the mesh's runs of triangles, by their number
  /// GLSL, read by OpenGL only; an absolute path, or relative to the current directory. Empty: our own.
  std::string vertex_shader_path = {};
  /// The same.
  std::string fragment_shader_path = {};
};

/// A material, and up to which triangle of the mesh it goes on: the first of another's, or how many there are.
struct MaterialRange {
  const Material* material = nullptr; ///< not null; of the object
  std::uint32_t end_triangle = 0;     ///< the first triangle that is not of the run
};

/// What a triangle of the object's mesh is drawn with. Takes time in proportion to the logarithm of the mesh's runs.
MaterialRange material_range(const Object& object, std::uint32_t triangle);

/// The same without its range.
inline const Material& material_of(const Object& object, std::uint32_t triangle) {
  if (object.materials.empty()) return object.material;
  return *material_range(object, triangle).material;
}

/// Calls visit(material) with each material that the object may be drawn with.
void for_each_material(auto& object, auto&& visit) requires requires {
  object.materials;
}
{
  visit(object.material);
  for (auto& material : object.materials) visit(material);
}

/// What is drawn.
struct Scene {
  Camera camera = {};                                ///< from where
  Double3 background{0};                             ///< linear colour where there is no surface; each channel >= 0
  std::vector<PointLight> point_lights = {};         ///< light is summed in the order of light_lists and of each list
  std::vector<DirectionLight> direction_lights = {}; ///< after all point lights
  std::vector<Object> objects = {};                  ///< drawn in this order
};

/// Calls visit(material) with each material that anything of a scene may be drawn with.
void for_each_material(auto& scene, auto&& visit) requires requires {
  scene.objects;
}
{
  for (auto& object : scene.objects) for_each_material(object, visit);
}

/// Whether has(material) holds for any of them.
bool any_material(const Scene& scene, auto&& has) {
  bool any = false;
  for_each_material(scene, [&](const Material& material) { any = any || has(material); });
  return any;
}

/// The types of light there are: every list of them that a scene has, in the order in which light is summed. Scene
/// files and their documentation, checks, all precisions and OpenGL's uniforms follow from this list.
inline constexpr std::tuple light_lists{&Scene::point_lights, &Scene::direction_lights};

/// Calls visit(list) with each list of lights of a scene.
void for_each_light_list(auto& scene, auto&& visit) {
  std::apply([&](auto... list) { (visit(scene.*list), ...); }, light_lists);
}

/// Whether any light is kept from surfaces by others.
inline bool has_shadows(const Scene& scene) {
  bool any = false;
  for_each_light_list(scene, [&](const auto& lights) {
    for (const auto& light : lights) any = any || light.shadow != Shadow::none;
  });
  return any;
}
/// The same of one kind.
inline bool has_shadows(const Scene& scene, Shadow kind) {
  bool any = false;
  for_each_light_list(scene, [&](const auto& lights) {
    for (const auto& light : lights) any = any || light.shadow == kind;
  });
  return any;
}

/// Of all types.
inline std::size_t light_count(const Scene& scene) {
  std::size_t count = 0;
  for_each_light_list(scene, [&](const auto& lights) { count += lights.size(); });
  return count;
}

/// Something about a scene that is not as it should be.
struct SceneFault {
  /// What render() does about it.
  enum class Effect {
    refused, ///< throws std::invalid_argument with text()
    drawn    ///< draws the rest: a triangle with a vertex that is not finite is left out and counted
  };
  Effect effect = Effect::refused; ///< what render() does
  std::string where = {};          ///< as the keys of a scene file are called: "objects/2/material/glossiness"
  std::string found = {};          ///< "-1"
  std::string expected = {};       ///< "finite numbers from 0"

  /// "objects/2/material/glossiness: found -1, expected finite numbers from 0".
  std::string text() const;
};

/// Everything that is wrong with a scene that was made or changed by a program: parameters out of range, indices that
/// name no vertex, lists that do not belong together, values that are not finite. One fault for each list of values:
/// the first of it. Empty: render() draws all of it. Never throws but std::bad_alloc. Takes time in proportion to all
/// meshes and textures. A scene that was read from a file has none.
std::vector<SceneFault> validate(const Scene& scene);

} // namespace refraster
