#include "io/mesh/obj_file.h"

#include "io/file/input_file.h"
#include "io/file/limits.h"
#include "io/mesh/obj/weld.h"
#include "io/mesh/obj_colours.h"
#include "io/mesh/obj_faces.h"
#include "io/mesh/obj_numbers.h"
#include "io/parallel/pages.h"
#include "io/parallel/pieces.h"

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

/// A vn or vt that is not finite stands for none; and a face has a vt at all corners, or at none.
void drop_what_is_missing(ObjText& obj) {
  if (!obj.has_not_finite && !obj.has_mixed_corners) return; // nearly always
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
  const auto by_less = [](const MovedVertex& a, const MovedVertex& b) { return a.by < b.by; };
  const auto furthest = static_cast<double>(std::max_element(obj.moved.begin(), obj.moved.end(), by_less)->by);
  std::vector<char> used(obj.v.size());
  Float3 low(std::numeric_limits<float>::infinity()), high = -low;
  const auto largest = [](const Double3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); };
  for (std::size_t i = 0; i < obj.faces.corners.size(); ++i) {
    const auto v = static_cast<std::size_t>(obj.faces.corners[i].v);
    used[v] = 1;
    low = glm::min(low, obj.v[v]), high = glm::max(high, obj.v[v]);
    // As large as that already: nothing will be noted, which a few faces show of most files.
    if (i % 256 == 255 && !(furthest > largest(Double3(high) - Double3(low)) / 1000)) return;
  }
  double moved = 0;
  for (const MovedVertex& vertex : obj.moved)
    if (used[static_cast<std::size_t>(vertex.v)]) moved = std::max(moved, static_cast<double>(vertex.by));
  const double size = largest(Double3(high) - Double3(low));
  if (!(moved > size / 1000)) return;
  const double away = std::max(largest(Double3(low)), largest(Double3(high)));
  notes.add({path, 0, "",
             "coordinates as large as " + three_digits(away) +
                 " are rounded to single precision, which moves them by up to " + three_digits(moved) +
                 ": more than a thousandth of the mesh's size, " + three_digits(size)});
}

/// What vertices have.
void add_points(const ObjText& obj, const RawVector<TripleIndex::Triple>& vertices, int threads, Mesh& mesh) {
  const auto has_vt = [](const TripleIndex::Triple& vertex) { return vertex[1] >= 0; };
  const auto textured = std::partition_point(vertices.begin(), vertices.end(), has_vt) - vertices.begin();
  for_pieces(threads, 3, [&](std::size_t list, int) { // a list of vertices is cleared first, which takes its time
    if (list == 0) resize_in_pages(mesh.positions, vertices.size());
    if (list == 1) resize_in_pages(mesh.normals, vertices.size());
    if (list == 2) resize_in_pages(mesh.uvs, static_cast<std::size_t>(textured));
  });
  constexpr std::size_t block = 1 << 14; // vertices that a thread takes at a time
  for_pieces(threads, (vertices.size() + block - 1) / block, [&](std::size_t b, int) {
    for (std::size_t i = b * block; i < std::min((b + 1) * block, vertices.size()); ++i) {
      const auto& [v, vt, vn] = vertices[i];
      mesh.positions[i] = obj.v[static_cast<std::size_t>(v)];
      mesh.normals[i] = obj.vn[static_cast<std::size_t>(vn)];
      if (vt >= 0) mesh.uvs[i] = obj.vt[static_cast<std::size_t>(vt)];
    }
  });
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

Mesh mesh_of_obj(const std::string& path, std::string text, const ObjOptions& options, std::size_t chunk_bytes) {
  NoteList notes;
  const ObjWork work{options.threads, chunk_bytes};
  const int threads = threads_of(work);
  ObjText obj = parse_obj(path, std::move(text), notes, work);
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
  if (!add_missing_normals(obj, options.normals, threads, steps_left))
    throw InputError(InputFault{path, 0, 0, "", "edges that so many faces share that smoothing takes too long",
                                "smoothing groups, or normals (vn)"});

  Mesh mesh;
  WeldedFaces welded = weld(path, obj, threads, steps_left);
  mesh.triangles = std::move(welded.triangles);
  add_points(obj, welded.vertices, threads, mesh);
  mesh.colours = vertex_colours(path, obj, welded.vertices, options.colours, notes);
  add_materials(obj, mesh);
  if (options.notes) options.notes->add(notes);
  return mesh;
}

} // namespace refraster
