#pragma once
// A scene as plain data: what is drawn, no file formats. Meshes, textures and tables are shared and immutable.

#include "shading/fragment_functions.h"
#include "shading/light.h"
#include "shading/texture.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace refraster {

/// Triangles in object space, counter-clockwise seen from outside. Coordinates are float: what a GPU is given, so that
/// both sides of a comparison start from the same numbers.
struct Mesh {
  std::vector<Float3> positions;                       // one entry a unique (position, normal, uv)
  std::vector<Float3> normals;                         // as many as positions; any length
  std::vector<Float2> uvs;                             // of the first vertices, all or some; the others have none
  std::vector<std::array<std::uint32_t, 3>> triangles; // indices into the above, each < positions.size()
};

/// Whether a triangle of the mesh has texture coordinates: all its corners do. Without them a texture is not shown on
/// it, as OBJ has it (statement f): it is white.
inline bool has_uvs(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const std::size_t count = mesh.uvs.size();
  return triangle[0] < count && triangle[1] < count && triangle[2] < count;
}

/// OpenGL's camera: right-handed, looks down its own -Z. target != position; up not parallel to the line of sight.
struct Camera {
  Double3 position{0, 0, 0};
  Double3 target{0, 0, -1};
  Double3 up{0, 1, 0};
  double fov_y_degrees = 45; // in (0, 180)
  double near = 0.1;         // 0 < near < far
  double far = 100;
};

enum class Cull { none, back };

template <>
struct EnumNames<Cull> {
  static constexpr std::pair<Cull, std::string_view> names[] = {{Cull::none, "none"}, {Cull::back, "back"}};
};

struct Material {
  FragmentFunction fragment_function;     // shading/fragment_functions.h
  std::shared_ptr<const Texture> texture; // null: white
  TextureFilter texture_filter = TextureFilter::bilinear;
};

/// World from object is T . Rx . Ry . Rz . S.
struct Object {
  std::string name;
  std::shared_ptr<const Mesh> mesh;
  Double3 position{0};
  Double3 rotate_degrees{0};
  Double3 scale{1}; // negative mirrors, 0 flattens: both are drawn
  Cull cull = Cull::none;
  Material material;
  // Only OpenGL reads these; absolute paths, or relative to the current directory.
  std::string vertex_shader_path, fragment_shader_path;
};

struct Scene {
  Camera camera;
  Double3 background{0};
  std::vector<PointLight> point_lights; // light is summed in this order, points first
  std::vector<DirectionLight> direction_lights;
  std::vector<Object> objects; // drawn in this order
};

} // namespace refraster
