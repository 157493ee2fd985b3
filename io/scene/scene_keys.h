#pragma once
// The scene file, declared: every key with its type, range, default and meaning, once. The reader (scene_reader.h), its
// error messages and the table in docs/scene-format.md (scene_markdown.cpp) are three readings of these functions.
//
// `keys` is the reading. It is called
//   keys("fov_y", value, range, "meaning", presence)                 a value; its type says what JSON may stand there
//   keys.object("camera", presence, "meaning", declare)              an object; declare(keys) has its members
//   keys.optional_object("fit", content, "meaning", declare)         one that may be left out: std::optional<Content>;
//                                                                    declare(content, keys) has its members
//   keys.list("objects", presence, limit::objects, "meaning", items, declare)
//                                                                    objects; declare(item, keys) has those of each
//   keys.shape("mesh", shape, "meaning")                             one of the shapes below
//   keys.normals("normals", normals, "meaning")                      a word, or an object with an angle
//   keys.shadow("shadow", shadow, "meaning", declare)                a word, or an object; declare(map, keys) has its
//                                                                    members
//   keys.map("diffuse_map", text, "meaning", short_form, multiplied)
//                                                                    a path, or an object with one
//   keys.material("material", text, "meaning", declare)              the same, or a word
//   keys.materials("materials", text, "meaning", declare)            of each name of a material the same
//   keys.check(value)                                                what a single key cannot show
//   keys.check_light(light)                                          the same of a light
//   keys.parameters(function, use)                                   what a fragment function declares (fields.h)
// A value that may be left out keeps what the member is initialised with.

#include <refraster/files.h>
#include <refraster/scene.h>

#include "io/file/limits.h"
#include "io/scene/material_texture.h"
#include "raster/vertex/scene_view.h"

#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace refraster {

/// Whether a key must be there; and if not, what the documentation says is taken instead ("": the value's own default).
struct Presence {
  enum class Need { required, defaulted } need;
  std::string_view otherwise = {};
};
inline constexpr Presence required{Presence::Need::required};
inline constexpr Presence defaulted{Presence::Need::defaulted};
constexpr Presence otherwise(std::string_view taken) {
  return {Presence::Need::defaulted, taken};
}

/// A path as it stands in the scene file; it is relative to that file's folder. Empty: not given.
struct PathText {
  std::string given;
  std::size_t offset = 0; // where in the scene file, for messages: its byte
  std::string json_path;  // and its key
};

/// The user's own fragment functions that a scene may name.
using UserFunctions = std::span<const std::shared_ptr<UserFunction>>;

/// The name of a fragment function, as an index into FragmentFunction, followed by those of the user. Empty when it is
/// not given, or unknown.
struct FragmentFunctionName {
  UserFunctions user_functions;
  std::optional<std::size_t> index;
  bool given = false;
};

// Shapes that need no file: the words in "mesh". The functions that make them are in scene/shapes.h.
inline constexpr Range mesh_cuts{3, 4096}; // 4096 x 4096 quads: 33 million triangles, 1 GB

struct SphereShape {
  static constexpr std::string_view name = "sphere", meaning = "radius 1, poles on the y axis";
  int segments = 64, rings = 32;
  static void fields(auto& self, auto&& keys) {
    keys("segments", self.segments, mesh_cuts, "quads around the axis", defaulted);
    keys("rings", self.rings, Range{2, mesh_cuts.max}, "quads from pole to pole", defaulted);
  }
  bool operator==(const SphereShape&) const = default;
};
struct CubeShape {
  static constexpr std::string_view name = "cube", meaning = "from -1 to 1 on each axis";
  static void fields(auto&, auto&&) {}
  bool operator==(const CubeShape&) const = default;
};
struct PlaneShape {
  static constexpr std::string_view name = "plane", meaning = "from -1 to 1 on x and z, facing +y";
  int segments = 1;
  static void fields(auto& self, auto&& keys) {
    keys("segments", self.segments, Range{1, mesh_cuts.max}, "quads along each side", defaulted);
  }
  bool operator==(const PlaneShape&) const = default;
};
struct TorusShape {
  static constexpr std::string_view name = "torus", meaning = "radius 1 around the y axis";
  int segments = 64, rings = 32;
  double tube_radius = 0.4;
  static void fields(auto& self, auto&& keys) {
    keys("segments", self.segments, mesh_cuts, "quads around the axis", defaulted);
    keys("rings", self.rings, mesh_cuts, "quads around the tube", defaulted);
    keys("tube_radius", self.tube_radius, Range{0, 1000, Ends::excluded}, "radius of the tube", defaulted);
  }
  bool operator==(const TorusShape&) const = default;
};
struct KnotShape {
  static constexpr std::string_view name = "knot", meaning = "a trefoil of radius 1 around the y axis";
  int segments = 512, rings = 32;
  double tube_radius = 0.25;
  static void fields(auto& self, auto&& keys) {
    keys("segments", self.segments, mesh_cuts, "quads along the knot", defaulted);
    keys("rings", self.rings, mesh_cuts, "quads around the tube", defaulted);
    keys("tube_radius", self.tube_radius, Range{0, 1000, Ends::excluded}, "radius of the tube", defaulted);
  }
  bool operator==(const KnotShape&) const = default;
};
using Shape = std::variant<SphereShape, CubeShape, PlaneShape, TorusShape, KnotShape>;

/// MeshNormals as an object of JSON.
void crease_keys(auto& normals, auto&& keys) {
  keys("crease_degrees", normals.crease_degrees, Range{0, 180},
       "edges are smooth where two faces enclose at most this angle, sharp where they enclose more", required);
}

/// A texture as the scene has it: what lies in the file is still to be loaded.
struct MapText {
  PathText path;
  TextureMap map; // but for the texture
  TextureReading reading;
};

/// Those of a material, in the order of texture_slots, as they are where nothing is said.
using MapTexts = std::array<MapText, texture_slots.size()>;
inline MapTexts map_texts() {
  MapTexts texts;
  for (std::size_t i = 0; i < texts.size(); ++i)
    if (texture_slots[i].value == SlotValue::scalar) texts[i].reading.channel = texture_slots[i].channel;
  return texts;
}

/// Of a texture of single numbers.
void channel_keys(ScalarChannel& channel, auto&& keys) {
  keys("channel", channel, Range{},
       "which of the image's values is taken: `\"auto\"` is alpha, where the image has it, else luminance", defaulted);
}

/// A texture as an object of JSON.
void map_keys(auto& text, auto&& keys) {
  keys("path", text.path, Range{}, "a `.png`, `.jpg`, `.tga` or `.bmp` image", required);
  keys("filter", text.map.filter, Range{}, "how it is read between its texels", defaulted);
  keys("wrap", text.map.wrap, Range{}, "what is seen beyond its edges: it again, or the texels of its edge", defaulted);
  keys("scale", text.map.scale, any_number, "texture coordinates u and v are multiplied by it,", defaulted);
  keys("offset", text.map.offset, any_number, "and this is added", defaulted);
  keys("color_space", text.reading.colour_space, Range{},
       "what its numbers mean: values, or values by the curve of sRGB, decoded before anything is made of them",
       defaulted);
  if (text.reading.channel) channel_keys(*text.reading.channel, keys);
}

/// Where a material is described: in the scene, or by a file of the mesh's.
enum class MaterialFrom { scene, file };
inline constexpr std::string_view from_file_word = "from_file";

/// An object as the file describes it. What lies in other files is still to be loaded.
struct ObjectText {
  Object object;
  FragmentFunctionName fragment_function;
  PathText obj_file, vertex_shader, fragment_shader;
  MeshNormals normals;                           // of obj_file
  VertexColours colours = VertexColours::linear; // likewise
  std::optional<Shape> shape;
  PathText brdf_file;
  MapTexts maps = map_texts();
  MaterialFrom material_from = MaterialFrom::scene;
  /// Of materials of the mesh: the name in object.material, and of the rest what belongs to a material.
  std::vector<ObjectText> materials;
  PathText material_place; // of one of those: where it stands
};

/// The fragment function of an object: its own key, else the stem of fragment_shader_file_path, else Blinn-Phong where
/// materials are those of a file. Empty: there is none.
std::optional<std::size_t> fragment_function_of(const ObjectText& text);

template <std::size_t... I>
void for_each_fragment_function(auto&& visit, std::index_sequence<I...>) {
  (visit(std::variant_alternative_t<I, FragmentFunction>{}, I), ...);
}
/// Calls visit(function, index) with a default-constructed object of every fragment function.
void for_each_fragment_function(auto&& visit) {
  for_each_fragment_function(visit, std::make_index_sequence<std::variant_size_v<FragmentFunction>>{});
}

/// The place of a fragment function in FragmentFunction.
template <class Function>
std::size_t place_of() {
  return FragmentFunction(Function{}).index();
}

/// A material may hold the parameters of every fragment function: those of its own must be there, others may.
enum class Use { own, other };

/// Whether a scene must give a parameter of this type and range: <refraster/fields.h>.
template <class Value>
constexpr bool is_required(const Range& range) {
  return !NamedEnum<Value> && range.need == Need::required;
}

/// A number of samples a pixel: not every whole number is one.
struct SampleCount {
  int& count;
};

void fit_keys(CameraFit& fit, auto&& keys) {
  keys("azimuth", fit.azimuth_degrees, any_number,
       "degrees about the up vector, from the front (+z where +y is up) to the right", defaulted);
  keys("elevation", fit.elevation_degrees, Range{-90, 90}, "degrees above the plane across the up vector", defaulted);
  keys("margin", fit.margin, Range{0, 0.49}, "part of the image's width and height that stays free on each side",
       defaulted);
  double distance = 0;
  keys("distance", distance, Range{.ends = Ends::excluded}, "from the point looked at",
       otherwise("as near as lets every vertex be seen"));
  if (distance > 0) fit.distance = distance;
}

void camera_keys(auto& camera, SceneView& view, auto&& keys) {
  keys.optional_object("fit", view.fit,
                       "from which side what the scene shows is looked at: then position, near and "
                       "far follow from it, and target, if left out",
                       [](CameraFit& fit, auto& inner) { fit_keys(fit, inner); });
  keys("position", camera.position, any_number, "where the eye is, world space; not beside `fit`",
       view.fit ? otherwise("`fit`") : required);
  keys("target", camera.target, any_number, "the point looked at: not the position",
       otherwise("position + (0, 0, -1); with `fit` the middle of what is seen"));
  keys("up", camera.up, any_number, "up in the image: not parallel to the line of sight", defaulted);
  keys("fov_y", camera.fov_y_degrees, Range{0, 180, Ends::excluded}, "vertical field of view, degrees", defaulted);
  keys("near", camera.near, Range{.ends = Ends::excluded},
       "distance of the near plane; with `fit` before the nearest vertex", defaulted);
  keys("far", camera.far, Range{.ends = Ends::excluded},
       "distance of the far plane: beyond the near one; with `fit` behind the farthest vertex", defaulted);
  const auto handling = [&](std::string_view key, std::optional<double>& member, std::string_view meaning,
                            std::string_view without) {
    double value = std::numeric_limits<double>::quiet_NaN(); // which no file can say
    keys(key, value, any_number, meaning, otherwise(without));
    if (!std::isnan(value)) member = value;
  };
  handling("movement_speed", view.handling.movement_speed,
           "of `refraster view`, as of the lecture's framework: world units a second; no image depends on it",
           "half of the way to the middle of the scene");
  handling("mouse_sensitivity", view.handling.mouse_sensitivity,
           "likewise: degrees that the view turns for a pixel that the mouse moves", "`0.1`");
  keys.check(camera, view);
}

/// ShadowMap as an object of JSON. A light without a place has no near plane.
template <class Light>
void shadow_map_keys(auto& map, auto&& keys) {
  ShadowMap::fields(map,
                    [&]<class Value>(std::string_view key, Value& value, const Range& range, std::string_view meaning) {
                      if constexpr (!requires(Light light) { light.position; })
                        if (key == "near") return;
                      keys(key, value, range, meaning, std::is_same_v<Value, int> ? required : defaulted);
                    });
}

template <class Light>
void light_keys(Light& light, LightSpace& space, auto&& keys) {
  Light::fields(
      light, [&]<class Value>(std::string_view key, Value& value, const Range& range, std::string_view meaning) {
        if constexpr (std::is_same_v<Value, CastShadow>)
          keys.shadow(key, value, meaning, [](ShadowMap& map, auto& inner) { shadow_map_keys<Light>(map, inner); });
        else keys(key, value, range, meaning, NamedEnum<Value> ? defaulted : required);
      });
  keys("space", space, Range{},
       "`\"camera\"`: x to the right, y up, z toward the viewer, from the eye: the light moves with the camera",
       defaulted);
  keys.check_light(light);
}

void material_keys(auto& text, auto&& keys) {
  const std::optional<std::size_t> own = fragment_function_of(text);
  bool needs_table = false;
  for_each_fragment_function([&](auto function, std::size_t index) {
    if (own != index) return;
    needs_table = std::is_same_v<decltype(function), Merl>;
    keys.parameters(function, Use::own);
    text.object.material.fragment_function = function;
  });
  const UserFunctions user_functions = text.fragment_function.user_functions;
  std::size_t number = std::variant_size_v<FragmentFunction>;
  for (const auto& function : user_functions)
    if (number++ == own) {
      const std::shared_ptr<UserFunction> copy = function->copy();
      keys.parameters(*copy, Use::own);
      text.object.material.user_function = copy;
    }
  for_each_fragment_function([&](auto function, std::size_t index) {
    if (own != index) keys.parameters(function, Use::other);
  });
  for (const auto& function : user_functions) keys.parameters(*function->copy(), Use::other);
  keys("brdf_file_path", text.brdf_file, Range{},
       "a MERL `.binary` file: must be there for `merl`, not loaded for others",
       needs_table ? required : otherwise("nothing"));
  for (std::size_t i = 0; i < texture_slots.size(); ++i) {
    const TextureSlot& slot = texture_slots[i];
    if (slot.file_key.empty()) {
      Double3* const multiplied = slot.multiplied ? &(text.object.material.*slot.multiplied) : nullptr;
      keys.map(slot.key, text.maps[i], slot.meaning, {}, multiplied);
      continue;
    }
    keys(slot.file_key, text.maps[i].path, Range{}, slot.meaning, otherwise("white"));
    keys(slot.filter_key, text.maps[i].map.filter, Range{}, "how the texture is read between its texels", defaulted);
    keys.map(slot.key, text.maps[i], "the same texture with all that can be said of it, instead of those two keys",
             slot.file_key, nullptr);
  }
  keys("emissive", text.object.material.emissive, Range{},
       "light of its own, r g b, added to the ambient term; not for `merl`",
       otherwise("`\"0 0 0\"`; `\"1 1 1\"` beside an `emissive_map`"));
  keys("opacity_threshold", text.object.material.opacity_threshold, Range{0, 1},
       "where the `opacity_map` at a pixel's centre is less, nothing of the surface is in the pixel", defaulted);
  keys("normal_scale", text.object.material.normal_scale, any_number,
       "of `normal_map`: what the slopes of its normals are multiplied by", defaulted);
  keys("bump_scale", text.object.material.bump_scale, any_number,
       "of `bump_map`: how much higher white is than black, in texels", defaulted);
}

void object_keys(auto& text, auto&& keys) {
  keys("name", text.object.name, Range{}, "for reports", otherwise("the mesh file's name, or the shape's"));
  keys("obj_file_path", text.obj_file, Range{}, "an OBJ file", otherwise("`mesh`"));
  keys.shape("mesh", text.shape, "a shape instead of a file: exactly one of the two is there");
  keys.normals(
      "normals", text.normals,
      "of an OBJ file: `\"file\"`, as it says; the others, computed from its faces: one normal a vertex, one a "
      "face, or sharp edges");
  keys("vertex_colors", text.colours, Range{},
       "of an OBJ file: what the colours of its vertices are taken as; they multiply the texture's", defaulted);
  keys.expect_material("material", text);
  keys("fragment_function", text.fragment_function, Range{}, "which function shades the surface",
       otherwise("the stem of `fragment_shader_file_path`; `\"blinn_phong\"` for the materials of a file"));
  const bool needs_no_shader = text.fragment_function.given || text.material_from == MaterialFrom::file;
  const Presence shader = needs_no_shader ? otherwise("nothing") : required;
  keys("vertex_shader_file_path", text.vertex_shader, Range{},
       "GLSL, read by `refraster gl` only; may be left out beside `fragment_function`", shader);
  keys("fragment_shader_file_path", text.fragment_shader, Range{},
       "GLSL, read by `refraster gl` only; may be left out beside `fragment_function`", shader);
  keys("position", text.object.position, any_number, "world space", required);
  keys("rotate_x", text.object.rotate_degrees.x, any_number, "degrees; world from object is T · Rx · Ry · Rz · S",
       required);
  keys("rotate_y", text.object.rotate_degrees.y, any_number, "degrees", required);
  keys("rotate_z", text.object.rotate_degrees.z, any_number, "degrees", required);
  keys("scale", text.object.scale, any_number, "negative mirrors, 0 flattens", required);
  keys("cull", text.object.cull, Range{}, "`\"back\"`: triangles seen from behind are not drawn", defaulted);
  keys("two_sided", text.object.two_sided, Range{},
       "true: the normal is turned to the eye where a triangle is seen from the side away from its normals, so that "
       "both sides are lit",
       defaulted);
  keys.material("material", text,
                "what the fragment function needs; or `\"from_file\"`: each triangle has the material that the OBJ "
                "file names for it ([mtl.md](mtl.md))",
                [](ObjectText& of, auto& inner) { material_keys(of, inner); });
  keys.materials(
      "materials", text,
      "of an OBJ file: materials by the names that the file has for them, each an object like `material`, or "
      "`\"from_file\"`; all others are `material`",
      [](ObjectText& of, auto& inner) { material_keys(of, inner); });
  keys.check(text);
}

void picture_keys(Picture& picture, auto&& keys) {
  const Range side{1, double(limit::frame_side.value)};
  keys("width", picture.width, side, "pixels", defaulted);
  keys("height", picture.height, side, "pixels", defaulted);
  keys("samples", SampleCount{picture.samples}, Range{}, "a pixel", defaulted);
  keys("srgb", picture.transfer, Range{}, "whether an 8-bit image has the sRGB curve", defaulted);
}

void scene_keys(auto& scene, SceneView& view, std::vector<ObjectText>& objects, UserFunctions user_functions,
                auto&& keys) {
  keys.object("camera", required, "", [&](auto& inner) { camera_keys(scene.camera, view, inner); });
  keys("background", scene.background, Range{}, "colour where there is no surface", defaulted);
  for_each_light_list(scene, [&]<class Light>(std::vector<Light>& lights) {
    keys.list(Light::names.key, Light::names.need == Need::required ? required : otherwise("none"),
              limit::lights<Light>, "may be empty", lights, [&](Light& light, auto& k) {
                LightSpace space = LightSpace::world;
                light_keys(light, space, k);
                if (space == LightSpace::camera) view.moving<Light>().push_back(lights.size() - 1);
              });
  });
  keys.list("objects", required, limit::objects, "drawn in this order; may be empty", objects,
            [&](auto& object, auto& k) {
              object.fragment_function.user_functions = user_functions;
              object_keys(object, k);
            });
  keys.object("picture", otherwise("its keys' defaults"),
              "the image that is made where no option of the command asks for another",
              [&](auto& inner) { picture_keys(view.picture, inner); });
}

} // namespace refraster
