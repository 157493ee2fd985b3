#pragma once
// A scene as plain data: what is drawn, no file formats. Meshes, textures and tables are shared and immutable.

#include <refraster/fields.h>
#include <refraster/material.h>
#include <refraster/mesh.h>
#include <refraster/vector.h>

#include <memory>
#include <string>
#include <vector>

namespace refraster {

/// A light that shines from one point in all directions: attenuated by 1 / (Kc + Kl d + Kq d^2), d in world units. All
/// three 0 means no attenuation.
struct PointLight {
  Double3 position{0};  ///< world space
  Double3 radiance{1};  ///< linear; each channel >= 0
  double constant = 1;  ///< Kc >= 0
  double linear = 0;    ///< Kl >= 0
  double quadratic = 0; ///< Kq >= 0
};

/// A light infinitely far away. Not attenuated.
struct DirectionLight {
  Double3 direction{0, 0, -1}; ///< world space: where the light travels to; any length but 0
  Double3 radiance{1};         ///< linear; each channel >= 0
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

/// A mesh, placed. World from object is T . Rx . Ry . Rz . S.
struct Object {
  std::string name = {};                 ///< for reports
  std::shared_ptr<const Mesh> mesh = {}; ///< not null
  Double3 position{0};                   ///< world space
  Double3 rotate_degrees{0};             ///< about x, y and z
  Double3 scale{1};                      ///< negative mirrors, 0 flattens: both are drawn
  Cull cull = Cull::none;                ///< whether its back is drawn
  Material material = {};                ///< what its surface is like
  /// GLSL, read by OpenGL only; an absolute path, or relative to the current directory. Empty: our own.
  std::string vertex_shader_path = {};
  /// The same.
  std::string fragment_shader_path = {};
};

/// What is drawn.
struct Scene {
  Camera camera = {};                                ///< from where
  Double3 background{0};                             ///< linear colour where there is no surface; each channel >= 0
  std::vector<PointLight> point_lights = {};         ///< light is summed in this order, points first
  std::vector<DirectionLight> direction_lights = {}; ///< then these
  std::vector<Object> objects = {};                  ///< drawn in this order
};

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
