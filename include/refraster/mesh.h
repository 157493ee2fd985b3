#pragma once
// Meshes, and those that need no file.

#include <refraster/fields.h>
#include <refraster/vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace refraster {

// Materials as a file beside a mesh describes them, Wavefront's .mtl: docs/mtl.md says what they mean.

/// An image that a material names, and how it is read.
struct MeshTexture {
  std::string path = {};     ///< as the file has it, which may be wrong; empty: none
  Double2 scale{1};          ///< -s: texture coordinates are multiplied by it,
  Double2 offset{0};         ///< -o: and this is added
  bool clamp = false;        ///< -clamp: the image does not repeat
  double bump_multiplier{1}; ///< -bm
  char channel = 0;          ///< -imfchan: r, g, b, m, l or z; 0: the key's own
  int line = 0;              ///< of the file, counted from 1
};

/// A material of the file. What it does not say is empty.
struct MeshMaterial {
  std::string name = {};                ///< as usemtl has it
  std::string file = {};                ///< the .mtl file that describes it; empty: none was found
  int line = 0;                         ///< where it does, counted from 1
  std::optional<Double3> ambient = {};  ///< Ka
  std::optional<Double3> diffuse = {};  ///< Kd
  std::optional<Double3> specular = {}; ///< Ks
  std::optional<Double3> emissive = {}; ///< Ke
  std::optional<double> exponent = {};  ///< Ns
  std::optional<double> dissolve = {};  ///< d, or 1 - Tr
  std::optional<double> roughness = {}; ///< Pr
  std::optional<double> metallic = {};  ///< Pm
  std::optional<int> illumination = {}; ///< illum
  MeshTexture ambient_map = {};         ///< map_Ka
  MeshTexture diffuse_map = {};         ///< map_Kd
  MeshTexture specular_map = {};        ///< map_Ks
  MeshTexture emissive_map = {};        ///< map_Ke
  MeshTexture dissolve_map = {};        ///< map_d
  MeshTexture bump_map = {};            ///< map_Bump, map_bump, bump
  MeshTexture normal_map = {};          ///< norm
  MeshTexture roughness_map = {};       ///< map_Pr
  MeshTexture metallic_map = {};        ///< map_Pm
};

/// What an OBJ file's `mtllib` says: one file or several.
struct MaterialLibrary {
  std::string text = {}; ///< as it stands
  int line = 0;          ///< counted from 1
};

/// Triangles that follow one another and have the same material: from the first on, up to the next run's first.
struct TriangleRun {
  std::uint32_t first_triangle = 0; ///< of the mesh
  std::uint32_t material = 0;       ///< which of Object::materials; one that is not there: Object::material
  /// Whether they say the same.
  bool operator==(const TriangleRun&) const = default;
};

/// Of triangles that name none.
inline constexpr std::uint32_t no_material = 0xffffffff;

/// Triangles in object space, counter-clockwise seen from outside. Coordinates are float: what a GPU is given, so that
/// both sides of a comparison start from the same numbers.
struct Mesh {
  std::vector<Float3> positions = {}; ///< one entry a unique (position, normal, uv)
  std::vector<Float3> normals = {};   ///< as many as positions; any length
  std::vector<Float2> uvs = {};       ///< of the first vertices, all or some; the others have none
  std::vector<Float3> colours = {};   ///< linear; of the first vertices, all or some; the others are white
  /// Where u grows, unit, and the handedness of the frame of tangent, bitangent and normal: 1, or -1 where uv is
  /// mirrored. What add_tangents() makes; of the first vertices, all or some; without, no map turns a normal.
  std::vector<Float4> tangents = {};
  std::vector<std::array<std::uint32_t, 3>> triangles = {}; ///< indices into the above, each < positions.size()
  /// In the order of triangles, no two of which begin at one; those before the first run name no material.
  std::vector<TriangleRun> material_runs = {};
  std::vector<MeshMaterial> materials = {}; ///< those that runs name, by their number: of each the name, at least
  std::vector<MaterialLibrary> material_libraries = {}; ///< the files that describe them
};

/// What turns an attribute of the mesh into one of the world.
enum class Transformed {
  as_position, ///< the object's matrix
  as_normal,   ///< its cofactors: stays perpendicular to what it was perpendicular to
  as_tangent,  ///< its 3x3 part, then made unit; a fourth component is times the sign of its determinant
  as_is        ///< nothing
};

/// What vertices bring and triangles interpolate.
template <class Value>
struct VertexAttribute {
  std::vector<Value> Mesh::*values = nullptr;   ///< the list
  std::string_view name = {};                   ///< in faults: "uvs"
  std::string_view words = {};                  ///< in messages: "texture coordinates"
  std::string_view input = {};                  ///< of a vertex shader, at the location that is its place in the list
  std::string_view varying = {};                ///< what our GLSL calls it between the shaders
  Transformed transformed = Transformed::as_is; ///< between the two
  Need need = Need::optional; ///< required: every vertex has one; optional: the first ones have, all, some or none
  float otherwise = 0;        ///< each component where a vertex has none

  /// Of each value.
  static constexpr int components = Value::length();
};

/// The attributes there are. Checks, the cache of meshes, set-up and interpolation in every precision, OpenGL's arrays
/// and what our vertex shader passes on follow from this list; what an attribute is for is in
/// raster/shade/shade_packet.h. A mesh without an optional one pays nothing for it.
inline constexpr std::tuple vertex_attributes{
    VertexAttribute<Float3>{&Mesh::positions, "positions", "positions", "vPos", "FragPos", Transformed::as_position,
                            Need::required},
    VertexAttribute<Float3>{&Mesh::normals, "normals", "normals", "vNormal", "Normal", Transformed::as_normal,
                            Need::required},
    VertexAttribute<Float2>{&Mesh::uvs, "uvs", "texture coordinates", "vTexCoord", "TexCoord"},
    VertexAttribute<Float3>{.values = &Mesh::colours,
                            .name = "colours",
                            .words = "vertex colours",
                            .input = "vColor",
                            .varying = "Color",
                            .otherwise = 1},
    VertexAttribute<Float4>{.values = &Mesh::tangents,
                            .name = "tangents",
                            .words = "tangents",
                            .input = "vTangent",
                            .varying = "Tangent",
                            .transformed = Transformed::as_tangent}};

/// Calls visit(attribute) with each.
constexpr void for_each_vertex_attribute(auto&& visit) {
  std::apply([&](const auto&... attribute) { (visit(attribute), ...); }, vertex_attributes);
}

/// The one that has this list.
template <class Value>
constexpr VertexAttribute<Value> declared(std::vector<Value> Mesh::*list) {
  VertexAttribute<Value> found;
  for_each_vertex_attribute([&](const auto& attribute) {
    if constexpr (std::is_same_v<decltype(attribute), const VertexAttribute<Value>&>)
      if (attribute.values == list) found = attribute;
  });
  return found;
}

/// Whether a triangle of the mesh has texture coordinates: all its corners do. Without them a texture is not shown on
/// it, as OBJ has it (statement f): it is white.
inline bool has_uvs(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const std::size_t count = mesh.uvs.size();
  return triangle[0] < count && triangle[1] < count && triangle[2] < count;
}

/// Gives the mesh the tangents that normal maps are made for: those of MikkTSpace, from positions, normals and texture
/// coordinates; docs/tangents.md says how. A vertex that would need several, where uv is mirrored or breaks, is split:
/// the triangles stay where they are, in their order, and look the same. The same bits on every machine. Of a mesh
/// without texture coordinates there are none. Indices must be those of vertices.
///
/// Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008.
void add_tangents(Mesh& mesh);

// All are in object space, counter-clockwise seen from outside, with unit normals and uv in [0, 1]. Where uv jumps or
// the normal breaks, vertices are duplicated; every vertex belongs to a triangle. The same bits on every machine, and
// mirror images of each other where the shape is: sines are computed here, not by the system's library.
// Arguments out of their range throw std::invalid_argument.

/// The unit sphere, swept by two angles: the longitude 2 pi u runs eastward from the back (-Z), the latitude pi v from
/// the south pole to the north pole.
///
///     x = -sin(pi v) sin(2 pi u),   y = -cos(pi v),   z = -sin(pi v) cos(2 pi u)
///
/// u = 1/2 faces +Z, where a camera usually stands, so a texture appears upright, unmirrored, and with its seam behind.
/// Cut at `segments` longitudes and `rings` latitudes this is a grid of quads, two triangles each; beside a pole a quad
/// has lost one edge and is a single triangle. Each of these has a pole vertex of its own, at the u of its middle: one
/// vertex cannot have the u of all. The seam is there twice, with u = 0 and u = 1.
/// segments >= 3, rings >= 2; 2 segments (rings - 1) triangles.
Mesh sphere_mesh(int segments, int rings);

/// [-1, 1]^3: six faces of two triangles, each with its own flat normal and the whole of [0, 1]^2 as uv.
Mesh cube_mesh();

/// [-1, 1]^2 in the xz plane, facing +Y; u runs along +X, v along -Z. segments >= 1 a side; 2 segments^2 triangles.
Mesh plane_mesh(int segments);

/// A torus around the Y axis: the centre of the tube is the unit circle. u runs round the axis as on the sphere, v
/// round the tube, from its innermost circle downward and out. 0 < tube_radius; at 1 the hole closes, above 1 it
/// intersects itself. segments >= 3 round the axis, rings >= 3 round the tube; 2 segments rings triangles.
Mesh torus_mesh(int segments, int rings, double tube_radius);

/// A trefoil: a tube around the knot that winds twice round the Y axis and three times round the circle of radius 1,
/// at a distance of 2/5 from that circle.
///
///     c(t) = (1 + 2/5 cos 3t) e(2t) - 2/5 sin 3t Y,   e(a) the unit vector of longitude a, as on the sphere
///
/// u runs along the knot and v round the tube, which is round at every u. Curved in every way, it shows what a
/// reflection model does at all angles. 0 < tube_radius; above 1/3 or so it intersects itself.
/// segments >= 3 along the knot, rings >= 3 round the tube; 2 segments rings triangles.
Mesh knot_mesh(int segments, int rings, double tube_radius);

} // namespace refraster
