#include "io/mesh/obj_file.h"

#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/mesh/obj_colours.h"
#include "io/mesh/obj_faces.h"
#include "io/mesh/triple_index.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <locale>
#include <sstream>

namespace refraster {
namespace {

/// Steps that all polygons of a file together may take to be cut, and all its edges to be smoothed, beyond what is in
/// proportion to the file: some five seconds. Any polygon of 10,000 corners keeps within them.
constexpr std::uint64_t max_steps = std::uint64_t{1} << 29;

InputError too_intricate(const std::string& path, std::size_t face, std::size_t corners) {
  return InputError(InputFault{path, 0, 0, "face " + std::to_string(face + 1),
                               "a polygon of " + std::to_string(corners) + " corners that takes too long to cut",
                               "simpler polygons, or triangles"});
}

bool is_finite(const Float3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
bool is_finite(const Float2& a) {
  return std::isfinite(a.x) && std::isfinite(a.y);
}

/// A vn or vt that is not finite stands for none; and a face has a vt at all corners, or at none.
void drop_what_is_missing(ObjText& obj) {
  for (std::size_t f = 0; f < obj.faces.count(); ++f) {
    const auto corners = obj.faces.face(f);
    const auto has_vt = [&](const ObjCorner& corner) {
      return corner.vt >= 0 && is_finite(obj.vt[static_cast<std::size_t>(corner.vt)]);
    };
    const bool textured = std::all_of(corners.begin(), corners.end(), has_vt);
    for (ObjCorner& corner : corners) {
      if (!textured) corner.vt = -1;
      if (corner.vn >= 0 && !is_finite(obj.vn[static_cast<std::size_t>(corner.vn)])) corner.vn = -1;
    }
  }
}

std::string three_digits(double x) {
  std::ostringstream text;
  text.imbue(std::locale::classic()); // whatever the program's own is
  text << std::setprecision(3) << x;
  return text.str();
}

/// Survey coordinates: the mesh is small, and far from the origin.
void note_rounding(const std::string& path, const ObjText& obj, NoteList& notes) {
  if (obj.moved.empty()) return;
  std::vector<char> used(obj.v.size());
  Float3 low(std::numeric_limits<float>::infinity()), high = -low;
  for (const ObjCorner& corner : obj.faces.corners) {
    const auto v = static_cast<std::size_t>(corner.v);
    used[v] = 1;
    low = glm::min(low, obj.v[v]), high = glm::max(high, obj.v[v]);
  }
  double moved = 0;
  for (const MovedVertex& vertex : obj.moved)
    if (used[static_cast<std::size_t>(vertex.v)]) moved = std::max(moved, static_cast<double>(vertex.by));
  const auto largest = [](const Double3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); };
  const double size = largest(Double3(high) - Double3(low));
  if (!(moved > size / 1000)) return;
  const double away = std::max(largest(Double3(low)), largest(Double3(high)));
  notes.add({path, 0, "",
             "coordinates as large as " + three_digits(away) +
                 " are rounded to single precision, which moves them by up to " + three_digits(moved) +
                 ": more than a thousandth of the mesh's size, " + three_digits(size)});
}

/// Triangles of all faces, and a vertex for each different (v, vt, vn), in the order in which they appear.
std::vector<std::array<std::uint32_t, 3>> cut(const std::string& path, const ObjText& obj, TripleIndex& vertices,
                                              std::uint64_t& steps_left) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Float3> polygon;
  std::vector<std::uint32_t> names;
  for (std::size_t f = 0; f < obj.faces.count(); ++f) {
    polygon.clear();
    names.clear();
    for (const ObjCorner& corner : obj.faces.face(f)) {
      polygon.push_back(obj.v[static_cast<std::size_t>(corner.v)]);
      names.push_back(static_cast<std::uint32_t>(vertices({corner.v, corner.vt, corner.vn})));
    }
    if (polygon.size() == 3) {
      triangles.push_back({names[0], names[1], names[2]});
      continue;
    }
    const auto parts = triangulate(polygon, steps_left);
    if (parts.empty()) throw too_intricate(path, f, polygon.size());
    for (const auto& [a, b, c] : parts) triangles.push_back({names[a], names[b], names[c]});
  }
  return triangles;
}

/// Numbers those vertices first that have a vt.
void put_textured_first(std::vector<TripleIndex::Triple>& vertices,
                        std::vector<std::array<std::uint32_t, 3>>& triangles) {
  const auto has_vt = [](const TripleIndex::Triple& vertex) { return vertex[1] >= 0; };
  if (std::is_partitioned(vertices.begin(), vertices.end(), has_vt)) return; // nearly always
  std::vector<std::uint32_t> place(vertices.size());
  std::uint32_t textured = 0;
  auto plain = static_cast<std::uint32_t>(std::count_if(vertices.begin(), vertices.end(), has_vt));
  for (std::size_t i = 0; i < vertices.size(); ++i) place[i] = has_vt(vertices[i]) ? textured++ : plain++;
  std::stable_partition(vertices.begin(), vertices.end(), has_vt);
  for (auto& triangle : triangles)
    for (std::uint32_t& vertex : triangle) vertex = place[vertex];
}

/// A face of n corners has become n - 2 triangles, in the order of the file.
void add_materials(const ObjText& obj, Mesh& mesh) {
  for (const ObjName& name : obj.material_names) {
    MeshMaterial& material = mesh.materials.emplace_back();
    material.name = name.text;
  }
  for (const ObjName& library : obj.material_libraries) mesh.material_libraries.push_back({library.text, library.line});
  for (const MaterialRun& run : obj.material_runs) {
    const std::uint32_t triangle = obj.faces.begin[run.face] - 2 * run.face;
    if (triangle >= mesh.triangles.size()) continue; // a usemtl after the last face
    mesh.material_runs.push_back({triangle, run.name < 0 ? no_material : static_cast<std::uint32_t>(run.name)});
  }
}

} // namespace

Mesh read_obj(const std::string& path, const ObjOptions& options) {
  return mesh_of_obj(path, read_file(path, "an OBJ file", limit::obj_bytes.value), options);
}

Mesh mesh_of_obj(const std::string& path, std::string text, const ObjOptions& options) {
  NoteList notes;
  ObjText obj = parse_obj(path, std::move(text), notes);
  // Before the triangles are made: a polygon of n corners becomes n - 2. There are no more vertices than corners.
  if (const std::uint64_t triangles = obj.faces.corners.size() - 2 * obj.faces.count();
      triangles > limit::triangles.value)
    throw InputError(InputFault{path, 0, 0, "", found_of(limit::triangles, triangles), at_most(limit::triangles)});
  if (obj.material_names.size() > limit::materials.value)
    throw InputError(
        InputFault{path, 0, 0, "", found_of(limit::materials, obj.material_names.size()), at_most(limit::materials)});
  drop_what_is_missing(obj);
  note_rounding(path, obj, notes);
  std::uint64_t steps_left = max_steps;
  if (!add_missing_normals(obj, options.normals, steps_left))
    throw InputError(InputFault{path, 0, 0, "", "edges that so many faces share that smoothing takes too long",
                                "smoothing groups, or normals (vn)"});

  TripleIndex index(obj.faces.corners.size());
  Mesh mesh;
  mesh.triangles = cut(path, obj, index, steps_left);
  std::vector<TripleIndex::Triple> vertices = index.take_triples();
  put_textured_first(vertices, mesh.triangles);
  mesh.positions.reserve(vertices.size());
  mesh.normals.reserve(vertices.size());
  mesh.uvs.reserve(static_cast<std::size_t>(
      std::count_if(vertices.begin(), vertices.end(), [](const auto& vertex) { return vertex[1] >= 0; })));
  for (const auto& [v, vt, vn] : vertices) {
    mesh.positions.push_back(obj.v[static_cast<std::size_t>(v)]);
    mesh.normals.push_back(obj.vn[static_cast<std::size_t>(vn)]);
    if (vt >= 0) mesh.uvs.push_back(obj.vt[static_cast<std::size_t>(vt)]);
  }
  mesh.colours = vertex_colours(path, obj, vertices, options.colours, notes);
  add_materials(obj, mesh);
  if (options.notes) options.notes->add(notes);
  return mesh;
}

} // namespace refraster
